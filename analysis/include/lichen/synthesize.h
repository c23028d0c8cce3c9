// SPDX-License-Identifier: MIT
// Whole images of a noise, without Vulkan.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/progress.h>
#include <lichen/result.h>
#include <lichen/noise_evaluator.h>

#include <array>
#include <optional>

namespace lichen {

/// Pixels across one exemplar. At the least, a pixel spans 1,024 tiles, far beyond the last mip.
inline constexpr NumberRange kTexelsPerTileRange{0x1p-10, 0x1p24};
/// Either coordinate of an image's corner, in tiles.
inline constexpr NumberRange kOriginRange{-0x1p40, 0x1p40};

struct SynthesisOptions {
  /// Its noise, seed, blending, contrast and impacts. Where the noise lies on a mesh, and where it
  /// has the weight of its mix from, is not looked at.
  MaterialNoise material;
  MapTarget map = MapTarget::baseColor;
  int width = 0;  ///< pixels, [1, 16384]
  int height = 0; ///< pixels, [1, 16384]
  /// Pixels across one exemplar's width, in kTexelsPerTileRange; 0 for the exemplar's own, one
  /// texel a pixel.
  double texelsPerTile = 0.0;
  /// Of the image's top left corner, in tiles, in kOriginRange. Shifts a tileable image in itself:
  /// what leaves at one border enters at the opposite one.
  std::array<double, 2> origin{0.0, 0.0};
  /// Of a larger image every `stride`-th pixel along each axis, beginning with the first: the
  /// footprint stays that of one of its pixels. >= 1; 1 for a tileable image.
  int stride = 1;
  bool tileable = false; ///< opposite borders continue each other; at least half a tile
  EvaluationOptions evaluation;
  /// Of a mix, the weight at the left and the right border, linear between; in kMixWeightRange,
  /// the same where the image is tileable.
  std::array<double, 2> mix{0.0, 0.0};
  Progress progress; ///< empty: nobody watches
};

/// Evaluates the noise at the pixels' centres, (x + 1/2, y + 1/2) pixels from the origin, with the
/// footprint of one pixel. The result holds decoded values: light for colour; as many channels as
/// the map has. Errors: usage for options out of range or a map that the noise has not; resources
/// for memory; environment when `options.progress` stops it. Multi-threaded, the same result for
/// any number of threads.
[[nodiscard]] Result<LinearImage> synthesize(const Bundle& bundle, const SynthesisOptions& options);

/// A power-of-two image of the material's pattern, `tiles` exemplars a side and repeating, for the
/// core slots of a glTF material. It has the texels of the noise's widest and highest map, so that
/// the images of all maps have one size; at most 1024 pixels a side. A mix is shown in its middle.
/// Errors: usage for an index or
/// a parameter out of range, a map that the noise has not, or tiles outside [1, 1024].
[[nodiscard]] Result<LinearImage>
synthesizePreview(const Bundle& bundle, const MaterialNoise& material, MapTarget map, int tiles);

} // namespace lichen
