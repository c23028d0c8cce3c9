// SPDX-License-Identifier: MIT
// The maps of a material -> the textures that a program imports: which files there are, their
// names, and what their channels hold.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/result.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lichen {

/// A program into which people load textures.
enum class Importer { blender, godot, unity, unreal };
/// Which way the green channel of a normal map points: up, as in glTF, or down.
enum class GreenAxis { up, down };
enum class TextureFormat { png, exr };

/// That of a program's own normal maps.
[[nodiscard]] GreenAxis greenAxisOf(Importer importer);
/// Whether a program takes opacity from the base colour's alpha.
[[nodiscard]] bool opacityIsAlpha(Importer importer);

/// What all textures of a material share.
struct TextureStyle {
  Importer importer = Importer::blender;
  std::optional<GreenAxis> green; ///< absent: greenAxisOf()
  TextureFormat format = TextureFormat::png;
};

/// A texture as a file.
struct TextureFile {
  std::string name; ///< with its extension: "moss_BaseColor.png"
  std::vector<std::byte> bytes;
};

/// The files of one map. `material` begins their names; characters that file systems or importers
/// may not take are replaced. `values` come from synthesize(), colours also from withAlpha().
/// Errors: as encodePng().
[[nodiscard]] Result<std::vector<TextureFile>> texturesOf(const std::string& material,
                                                          const NoiseMap& map, LinearImage values,
                                                          const TextureStyle& style);

} // namespace lichen
