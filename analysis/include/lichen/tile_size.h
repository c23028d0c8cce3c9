// SPDX-License-Identifier: MIT
// How large one tile of a noise is in a scene: in metres, and in pixels of a typical view.
#pragma once

#include <lichen/gltf_scene.h>

namespace lichen {

/// The picture of the typical view, in pixels.
inline constexpr int kViewWidth = 1920;
inline constexpr int kViewHeight = 1080;

/// One tile on an object: the nodes of a scene that have a material, or one of them. In the typical
/// view the object's bounding sphere touches the upper and lower edge of a picture of kViewHeight
/// pixels with a vertical field of view of 45 degrees; lengths are projected at the sphere's
/// centre.
struct TileSize {
  std::size_t node = 0;      ///< glTF index of the object's first node
  std::size_t nodeCount = 1; ///< of the object
  double metres = 0.0;       ///< width of a tile in the world
  double pixels = 0.0;       ///< the same in the typical view
};

/// Measures a tile of the noise for each of the materials, on the default scene's nodes that have
/// it, with their transforms. With noise in world space these nodes are one object, because one
/// pattern spans them; otherwise the object is the largest node. With texture coordinates the width
/// is the median over the object's area of sqrt(area in the world / area in texture coordinates),
/// times use.scale. In object space, it scales with the cube root of the node's change of volume. A
/// skinned mesh is measured as its first joint transforms it. Time: linear in the vertices, n log n
/// in the object's triangles. Errors, for a material each: badInput if there is nothing to measure:
/// no node, no triangles, compressed vertices, texture coordinates without area; resources if
/// memory does not suffice, or the file names the same vertices too often.
[[nodiscard]] std::vector<Result<TileSize>> measureTiles(GltfScene& scene,
                                                         std::span<const std::size_t> materials,
                                                         const Noise& noise,
                                                         const MaterialNoise& use);

} // namespace lichen
