// SPDX-License-Identifier: MIT
// The factors of materials, which multiply a noise: what `lichen apply` says of them and does.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// Notes on the factors of materials that change the look of a noise, and on materials without
/// light: one note of each kind. Factors that are set to 1 change nothing, but other viewers show
/// an emissive one.
[[nodiscard]] std::vector<std::string> notesOnFactors(const GltfScene& scene,
                                                      std::span<const std::size_t> materials,
                                                      const Noise& noise, bool areSetToOne);

/// Sets the factors that multiply a map of the noise to 1, but for the alpha of a colour.
void setFactorsToOne(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise);

} // namespace lichen::cli
