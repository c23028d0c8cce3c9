// SPDX-License-Identifier: MIT
// `lichen apply`: the material factors that multiply a noise, and the notes about them.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// Describes, with at most one note of each kind, the material factors that change the look of the
/// noise. If `areSetToOne`, the factors do not change the
/// noise, but other viewers show an emissive factor of 1.
[[nodiscard]] std::vector<std::string> notesOnFactors(const GltfScene& scene,
                                                      std::span<const std::size_t> materials,
                                                      const Noise& noise, bool areSetToOne);

/// Sets every factor that multiplies a map of the noise to 1, except the alpha of a colour.
void setFactorsToOne(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise);

} // namespace lichen::cli
