// SPDX-License-Identifier: MIT
// One exemplar -> a noise for each label, under index maps.
#pragma once

#include <lichen/bake_material.h>

#include <functional>
#include <span>

namespace lichen {

/// Bakes each label's material with `bake`, and the index maps. Returns the bundle, and what is
/// known of the bake of the first label, with notes of all. Errors: as bakeMaterial().
struct LayeredBake {
  Bundle bundle;
  MethodBake about; ///< without noise and tables
  std::vector<double> proportions;
};
using LabelBake = std::function<Result<MethodBake>(std::span<const MapExemplar> maps)>;
[[nodiscard]] Result<LayeredBake> bakeLayers(const LayersOptions& options, const std::string& name,
                                             std::span<const MapExemplar> maps,
                                             const MaterialNoise& material, SettingWords words,
                                             const LabelBake& bake);

} // namespace lichen
