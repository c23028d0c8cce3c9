// SPDX-License-Identifier: MIT
// The options --labels and --layers of `bake`: one exemplar -> a noise for each label, under index
// maps.
#pragma once

#include "methods/method_command.h"
#include "options.h"

#include <functional>
#include <optional>
#include <string>

namespace lichen::cli {

struct LayersOption {
  std::string labels;       ///< a picture; empty for none
  std::optional<int> count; ///< of colour clusters
  std::optional<double> softness;
  [[nodiscard]] bool isGiven() const { return !labels.empty() || count; }
};

inline constexpr double kUsualSoftness = 0.1;

void addLayersOption(CLI::App& verb, LayersOption& option);

/// A layered noise, noise 0 of the bundle, and what the method reports of the bake of its first
/// layer, with notes of all.
struct LayeredBake {
  Bundle bundle;
  MethodBake about;
};

/// Bakes each label's material with `bake`, and the index maps. Errors: usage for maps that layers
/// cannot have; errors of the labels and the bakes.
[[nodiscard]] Result<LayeredBake>
bakeLayers(const LayersOption& option, const std::string& name, std::span<const MapExemplar> maps,
           const std::function<Result<MethodBake>(std::span<const MapExemplar> maps)>& bake);

} // namespace lichen::cli
