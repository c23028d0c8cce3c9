// SPDX-License-Identifier: MIT
// Writes a bundle as a glTF scene that any viewer opens. The extension holds the noise; the core
// material holds a tileable preview with the same mean and scale.
#pragma once

#include <lichen/bundle.h>

#include <filesystem>

namespace lichen {

enum class PreviewShape {
  sphere, ///< one sphere per material, on a ground of the first that reaches the horizon
  plane,  ///< the ground alone, divided between the materials, at a grazing angle
  none,   ///< a material library without nodes or meshes
};

/// PNG files for the core material's texture slots; empty if the noise has no such map. Sides are
/// powers of two.
struct PreviewImages {
  std::vector<std::byte> baseColor; ///< alpha is the noise's opacity
  std::vector<std::byte> normal;
  std::vector<std::byte> occlusionRoughnessMetallic;
  std::vector<std::byte> emissive;
  /// Number of exemplars that one preview image spans along each axis, >= 1.
  int tilesPerImage = 1;
};

/// A bundle and its preview scene. Material i of the scene uses bundle.materials[i], which the
/// caller fills, and previews[i].
struct BundleFile {
  Bundle bundle;
  std::vector<PreviewImages> previews; ///< one per material
  PreviewShape shape = PreviewShape::sphere;
  std::string generator; ///< asset.generator, such as "lichen 0.1.0"
};

/// Encodes a table as a KTX2 file. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> encodeKtx2(const Table& table);

/// Encodes a GLB, with deterministic bytes. Errors: usage, with the reason, when the parts are
/// inconsistent or parseBundle() would reject the result; resources if a large allocation fails.
[[nodiscard]] Result<std::vector<std::byte>> encodeGlb(const BundleFile& file);

/// Writes a .glb, or a .gltf with its binary beside it in STEM.HASH.bin, where HASH depends on the
/// content. Replacing a .gltf removes its old binary. Errors: as of encodeGlb() and replaceFile(),
/// which leave the old files intact and no new ones; usage for another extension.
[[nodiscard]] Result<void> writeBundle(const std::filesystem::path& path, const BundleFile& file);

} // namespace lichen
