// SPDX-License-Identifier: MIT
// `lichen apply --material`: which materials of a scene receive the noise.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <string>
#include <vector>

namespace lichen::cli {

struct ChosenMaterials {
  std::vector<std::size_t> indices; ///< unique, in the scene's order
  bool areAll = false;              ///< --material selected every material, not single ones
};

/// Finds the materials for --material: all of them, the one with a given name, or the one with a
/// given index. Errors: usage if a value matches no material or several, badInput if the scene has
/// no materials.
[[nodiscard]] Result<ChosenMaterials> findMaterials(const GltfScene& scene,
                                                    const std::vector<std::string>& wanted);

/// Returns the materials for which every primitive has the attribute that `option` needs. If the
/// user chose all materials, the others are skipped with a note. Errors: badInput if a material
/// that the user named has a primitive without the attribute, or if no material remains; `instead`
/// tells the user what would work.
[[nodiscard]] Result<std::vector<std::size_t>>
materialsWith(const std::string& attribute, const GltfScene& scene, const ChosenMaterials& chosen,
              const std::string& option, const std::string& instead,
              std::vector<std::string>& notes);

/// Returns the materials whose meshes can use the frame's tangents, and skips or refuses the others
/// as materialsWith() does. `bringsNormals` is the parameter of checkFrames(). Errors: badInput.
[[nodiscard]] Result<std::vector<std::size_t>> materialsWithFrames(const GltfScene& scene,
                                                                   const ChosenMaterials& chosen,
                                                                   bool bringsNormals,
                                                                   std::vector<std::string>& notes);

} // namespace lichen::cli
