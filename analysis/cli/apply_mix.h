// SPDX-License-Identifier: MIT
// `lichen apply`: the options that choose the source of a material's mix weight.
#pragma once

#include "apply_materials.h"
#include "options.h"

#include <lichen/gltf_scene.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

struct MixOptions {
  std::optional<double> weight;
  std::optional<std::array<double, 4>> direction; ///< u, v of the start, then of the end
  std::string texture; ///< a file name, or the index of a texture in the scene
  std::optional<int> colorSet;
  std::optional<int> channel;

  [[nodiscard]] bool isGiven() const {
    return weight || direction || !texture.empty() || colorSet || channel;
  }
};

void addMixOptions(CLI::App& verb, MixOptions& options);

struct ChosenMix {
  MixWeight weight;
  std::vector<std::size_t> materials; ///< whose meshes have what the source of the weight needs
};

/// Returns the source that the options choose; without options, the source of `use`, whose mapping
/// and texture coordinates must be final. An image file becomes a texture of the scene. Notes name
/// materials that are skipped, texture coordinates outside the image, and a direction that is short
/// for the texture coordinates. Errors: usage for options that contradict each other or do not fit
/// the noise; badInput for an unusable image, and as materialsWith().
[[nodiscard]] Result<ChosenMix> chosenMix(const MixOptions& options, const Noise& noise,
                                          const MaterialNoise& use, const ChosenMaterials& chosen,
                                          GltfScene& scene, std::vector<std::string>& notes);

} // namespace lichen::cli
