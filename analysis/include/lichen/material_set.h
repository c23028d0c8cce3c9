// SPDX-License-Identifier: MIT
// Reads the image files of a material into exemplars for a bake.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image_io.h>
#include <lichen/result.h>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// Direction of the green channel of a normal map.
enum class NormalConvention {
  openGl,  ///< up the image, as in glTF
  directX, ///< down
};

/// What the alpha channel of the base colour means.
enum class AlphaUse {
  ignore, ///< unused, with a note if it is not fully opaque
  /// Alpha becomes the opacity map. A noise mixes colours from all over the exemplar and would show
  /// the arbitrary colours of transparent pixels, so the nearby covered pixels replace them,
  /// weighted by coverage. A separate opacity file has the same effect.
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
  NormalConvention normal = NormalConvention::openGl; ///< for files whose names do not say
  AlphaUse alpha = AlphaUse::ignore;
  /// The crop, applied first, in pixels of the largest map. Other maps are cropped to match.
  std::optional<PixelRectangle> crop;
  /// Whether to cut off a frame around the base colour, the border of a scan or a screenshot, if
  /// there is no crop. None is looked for with Periodic::yes, or beside an opacity.
  bool cutsFrame = true;
  /// Width and height to which every map is resampled, [1, kMaxImageSide]. Resampling averages
  /// light for colours, slopes for normals and values for other maps.
  std::optional<std::array<int, 2>> size;
  /// Whether resampling wraps around opposite borders; use the bake's own option.
  Periodic periodic = Periodic::detect;
  /// Called with each file and its width and height before its pixels are decoded, so that the
  /// caller can reject images that need too much memory. Empty: no check.
  std::function<Result<void>(const std::filesystem::path&, int width, int height)> sizeCheck;
};

/// The content of the files, ready for bakeTiling().
struct MaterialSet {
  std::string name;              ///< the folder's name, or the common start of the file names
  std::vector<MapExemplar> maps; ///< one per target, in the order of MapTarget
  /// Whether the maps' borders match, if that was measured. It is measured before resampling, which
  /// smooths the differences that a seam is compared with.
  Periodic periodic = Periodic::detect;
  std::optional<PixelRectangle> crop; ///< the options' crop, or the part inside a frame
  std::vector<std::string> notes;     ///< notes for the user, one sentence each
};

/// Reads one image, several images or the images of one folder. File names determine the maps
/// (docs/cli.md lists the words). The name of a single image counts only if its colours agree;
/// otherwise it is the base colour. Occlusion, roughness and metallic become one map, as large as
/// the largest of them. Grey becomes RGB where the map needs a colour. EXR light is encoded as
/// sRGB, or as log2(1 + light) if it exceeds 1, and clamped to kHalfMax.
/// Errors: badInput for images that cannot be read, a folder without a map, two files for one map,
/// or a map with too few channels; usage for options out of range; resources if memory runs out;
/// and the errors of `sizeCheck`. Thread-safe; same result for any number of threads.
[[nodiscard]] Result<MaterialSet> readMaterialSet(std::span<const std::filesystem::path> inputs,
                                                  const MaterialSetOptions& options);

/// A decoded image. Its name says which map it is, as the name of a file does: "rock_nor_gl.png".
struct Photograph {
  std::string name;
  ImageFile image;
};

/// The same for images in memory, whose pixels are upright. `sizeCheck` is not called.
[[nodiscard]] Result<MaterialSet> materialSetOf(std::vector<Photograph> photographs,
                                                const MaterialSetOptions& options);

} // namespace lichen
