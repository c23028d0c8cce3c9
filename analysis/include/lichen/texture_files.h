// SPDX-License-Identifier: MIT
// A noise -> the textures that a program imports: which files there are, their names, and what
// their channels hold.
#pragma once

#include <lichen/synthesize.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lichen {

/// A program into which people load textures.
enum class Importer { blender, godot, unity, unreal };
/// Which way the green channel of a normal map points: up, as in glTF, or down.
enum class GreenAxis { up, down };
enum class TextureFormat { png, exr };

/// What all textures of a material share.
struct TextureStyle {
  Importer importer = Importer::blender;
  std::optional<GreenAxis> green; ///< absent: down for Unreal, up for the others
  TextureFormat format = TextureFormat::png;
};

/// A texture as a file.
struct TextureFile {
  std::string name; ///< with its extension: "moss_BaseColor.png"
  std::vector<std::byte> bytes;
};

/// Synthesizes all maps of the noise of `synthesis`, whose `map` is ignored, and gives each file to
/// `take`, one map after the other, so that memory holds one. The noise's name begins the names of
/// the files; characters that file systems or importers may not take are replaced. Opacity is the
/// base colour's alpha where the program expects that. Errors: as synthesize() and encodePng(); an
/// error of `take` ends the work.
[[nodiscard]] Result<void>
makeTextures(const Bundle& bundle, const SynthesisOptions& synthesis, const TextureStyle& style,
             const std::function<Result<void>(const TextureFile& file)>& take);

} // namespace lichen
