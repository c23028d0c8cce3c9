// SPDX-License-Identifier: MIT
// From the image files of a material to exemplars that can be baked.
#pragma once

#include <lichen/result.h>
#include <lichen/exemplar.h>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// Which way the green channel of a normal map points.
enum class NormalConvention {
  openGl,  ///< up the image, as in glTF
  directX, ///< down
};

/// What the alpha channel of the base colour is taken for.
enum class AlphaUse {
  ignore, ///< nothing, with a note when it is not all opaque
  /// The opacity map. The colours of transparent pixels, which nobody has seen, are replaced by
  /// those of covered pixels around them, weighted by coverage: a noise mixes colours from all over
  /// the exemplar, and would bring invisible ones to light. A file of opacity does the same.
  opacity,
};

/// Pixels [x, x + width) x [y, y + height), row 0 at the top.
struct PixelRectangle {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

struct MaterialSetOptions {
  NormalConvention normal = NormalConvention::openGl; ///< of files whose names do not say
  AlphaUse alpha = AlphaUse::ignore;
  /// Cut out first. Pixels of the largest map; the others are cut at the same places.
  std::optional<PixelRectangle> crop;
  /// Width and height to which every map is resampled, [1, kMaxImageSide]: light is averaged, of
  /// normals the slopes, of other maps the values.
  std::optional<std::array<int, 2>> size;
  /// Whether resampling continues over opposite borders, as the bake's own option says.
  Periodic periodic = Periodic::detect;
  /// Called with each file and its width and height before its pixels are decoded, so that one can
  /// be refused for the memory that it would take. Empty: all are accepted.
  std::function<Result<void>(const std::filesystem::path&, int width, int height)> sizeCheck;
};

/// What the files hold, ready for bakeTiling().
struct MaterialSet {
  std::string name;              ///< the folder's, or what the files' names begin with
  std::vector<MapExemplar> maps; ///< each with another target, in the order of MapTarget
  /// Whether the maps' borders fit together, where that was decided: before they were resampled,
  /// which smooths the differences that a seam is measured against.
  Periodic periodic = Periodic::detect;
  std::vector<std::string> notes; ///< what the user should know, one sentence each
};

/// Reads one image; or several, or those of one folder. Their names say what they are (docs/cli.md
/// has the words); of a single one, if its colours agree, else it is the base colour. Occlusion,
/// roughness and metallic become one map, as large as the largest of them. Grey becomes RGB where a
/// colour is wanted, EXR light is encoded as sRGB, or as log2(1 + light) where it exceeds 1, and
/// clamped to kHalfMax. Errors: badInput for images that cannot be read, a folder without a map,
/// two files for one map, and a map with too few channels; usage for options out of range;
/// resources for memory; those of `sizeCheck`. Thread-safe; the same result for any number of
/// threads.
[[nodiscard]] Result<MaterialSet> readMaterialSet(std::span<const std::filesystem::path> inputs,
                                                  const MaterialSetOptions& options);

} // namespace lichen
