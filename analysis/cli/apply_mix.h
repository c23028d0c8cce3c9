// SPDX-License-Identifier: MIT
// Where a material of a scene takes the weight of a mix from: the options of `lichen apply`.
#pragma once

#include "options.h"

#include <lichen/gltf_scene.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

struct MixOptions {
  std::optional<double> weight;
  std::optional<std::array<double, 4>> direction; ///< start and end
  std::string texture;                            ///< a file, or the index of one of the scene's
  std::optional<int> colorSet;
  std::optional<int> channel;

  [[nodiscard]] bool isGiven() const {
    return weight || direction || !texture.empty() || colorSet || channel;
  }
};

void addMixOptions(CLI::App& verb, MixOptions& options);

/// The source that was chosen, or without one that of `use`, whose mapping and texture coordinates
/// are as they will be. A file becomes a texture of the scene; a mesh that reaches beyond it is
/// noted. Errors: usage for options that do not go together or with the noise, badInput where the
/// scene or the file is not what they need.
[[nodiscard]] Result<MixWeight> chosenMix(const MixOptions& options, const Noise& noise,
                                          const MaterialNoise& use,
                                          std::span<const std::size_t> materials, GltfScene& scene,
                                          std::vector<std::string>& notes);

} // namespace lichen::cli
