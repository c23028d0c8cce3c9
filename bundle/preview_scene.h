// SPDX-License-Identifier: MIT
// The scene that shows a noise: balls on a ground, a camera, a sun.
#pragma once

#include "gltf_builder.h"

#include <lichen/bundle_writer.h>

namespace lichen {

/// Parts into which the ground can be divided: no more materials are shown by PreviewShape::plane.
inline constexpr int kGroundSectors = 48;

/// Adds scene, nodes, cameras, meshes and the sun to `root`, geometry to `builder`. Every material,
/// as many as needsTangents has elements, is shown; a primitive has TANGENT exactly where its
/// material's needsTangents is set. `exemplarAspect`, width over height, keeps the exemplar's
/// proportions, since it spans one unit of texture coordinates each way; all share the geometry, so
/// it is the first noise's. Nothing for PreviewShape::none.
void addPreviewScene(JsonTree& root, GltfBuilder& builder, PreviewShape shape,
                     const std::vector<bool>& needsTangents, double exemplarAspect);

} // namespace lichen
