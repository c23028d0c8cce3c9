// SPDX-License-Identifier: MIT
// Which materials of a scene `lichen apply` gives the noise.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <string>
#include <vector>

namespace lichen::cli {

struct ChosenMaterials {
  std::vector<std::size_t> indices; ///< each once, in the scene's order
  bool areAll = false;              ///< of the scene, none of them named
};

/// Those that --material names: all, each of one name, or one by its index. Errors: usage for what
/// names none or several, badInput for a scene without materials.
[[nodiscard]] Result<ChosenMaterials> findMaterials(const GltfScene& scene,
                                                    const std::vector<std::string>& wanted);

/// Those that are shaded by glTF's metallic-roughness model, whose textures a noise takes the place
/// of. Where all of the scene were asked for, the others are left out with a note. Errors: badInput
/// for one that was named, or where none is left.
[[nodiscard]] Result<ChosenMaterials>
shadedMaterials(const GltfScene& scene, ChosenMaterials chosen, std::vector<std::string>& notes);

/// Those of which all primitives have the attribute, which `option` needs. Where all of the scene
/// were asked for, the others are left out with a note. Errors: badInput for one that was named, or
/// where none is left; `instead` names what is accepted.
[[nodiscard]] Result<std::vector<std::size_t>>
materialsWith(const std::string& attribute, const GltfScene& scene, const ChosenMaterials& chosen,
              const std::string& option, const std::string& instead,
              std::vector<std::string>& notes);

/// Those of which no mesh needs other tangents than the frame's; as materialsWith() where some do.
/// `bringsNormals` as checkFrames() has it. Errors: badInput.
[[nodiscard]] Result<std::vector<std::size_t>> materialsWithFrames(const GltfScene& scene,
                                                                   const ChosenMaterials& chosen,
                                                                   bool bringsNormals,
                                                                   std::vector<std::string>& notes);

} // namespace lichen::cli
