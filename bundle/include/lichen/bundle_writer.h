// SPDX-License-Identifier: MIT
// Writes a bundle as a glTF scene that any viewer opens: the noise in our extension, a tileable
// preview of the same mean and scale in the core material.
#pragma once

#include <lichen/bundle.h>

namespace lichen {

enum class PreviewShape {
  sphere, ///< a sphere for each material, on a ground with the first that reaches to the horizon
  plane,  ///< the ground alone, divided between the materials, seen at a grazing angle
  none,   ///< no nodes and no meshes: a material library
};

/// PNG files for the core slots; empty where the noise has no such map. Power-of-two sizes.
struct PreviewImages {
  std::vector<std::byte> baseColor; ///< its alpha is the noise's opacity
  std::vector<std::byte> normal;
  std::vector<std::byte> occlusionRoughnessMetallic;
  std::vector<std::byte> emissive;
  /// How many exemplars one preview image spans each way, >= 1.
  int tilesPerImage = 1;
};

/// What the scene around the bundle looks like. One material per noise, in order, taking
/// bundle.materials[i] (which the caller has filled) and previews[i].
struct BundleFile {
  Bundle bundle;
  std::vector<PreviewImages> previews; ///< one per noise
  PreviewShape shape = PreviewShape::sphere;
  std::string generator; ///< asset.generator, such as "lichen 0.1.0"
};

/// Deterministic bytes of a GLB. Errors: usage when the parts do not fit one another or
/// readBundle() would refuse the result, for its reason; resources when memory does not suffice.
[[nodiscard]] Result<std::vector<std::byte>> encodeGlb(const BundleFile& file);

/// Writes .glb, or .gltf with one STEM.HASH.bin beside it, named by its content; that of the .gltf
/// which this one replaces is removed. Errors as replaceFile, with the old files whole and no
/// other; usage for another extension.
[[nodiscard]] Result<void> writeBundle(const std::filesystem::path& path, const BundleFile& file);

} // namespace lichen
