// SPDX-License-Identifier: MIT
// The scene that shows the noises: balls on a ground, a camera, a sun.
#pragma once

#include "gltf_builder.h"

#include <lichen/bundle_writer.h>

namespace lichen {

/// Number of sectors of the ground, and so the maximum number of materials for PreviewShape::plane.
inline constexpr int kGroundSectors = 48;

/// Adds scene, nodes, cameras, meshes and the sun to `root`, and geometry to `builder`. Shows one
/// material per element of needsTangents; a primitive has TANGENT exactly if its material's element
/// is true. `exemplarAspect`, width over height, preserves the exemplar's proportions, because an
/// exemplar spans one unit of texture coordinates along both axes. All materials share the
/// geometry, so it is the aspect of the first noise. Adds nothing for PreviewShape::none.
void addPreviewScene(nlohmann::ordered_json& root, GltfBuilder& builder, PreviewShape shape,
                     const std::vector<bool>& needsTangents, double exemplarAspect);

} // namespace lichen
