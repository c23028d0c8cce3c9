// SPDX-License-Identifier: MIT
// Synthesizes whole images of a noise without Vulkan.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/noise_evaluator.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace lichen {

/// Pixels across one exemplar. At the minimum a pixel spans 1,024 tiles, far beyond the last mip
/// level.
inline constexpr NumberRange kTexelsPerTileRange{0x1p-10, 0x1p24};
/// Each coordinate of an image's corner, in tiles.
inline constexpr NumberRange kOriginRange{-0x1p40, 0x1p40};

struct SynthesisOptions {
  /// Supplies the noise, seed, blending, contrast and impacts. Its mapping onto a mesh and the
  /// source of its mix weight are ignored.
  MaterialNoise material;
  MapTarget map = MapTarget::baseColor;
  int width = 0;  ///< pixels, [1, 16384]
  int height = 0; ///< pixels, [1, 16384]
  /// Pixels across one exemplar's width, in kTexelsPerTileRange; 0 for the exemplar's own size, one
  /// texel per pixel.
  double texelsPerTile = 0.0;
  /// Top left corner of the image, in tiles, in kOriginRange. A tileable image wraps: what leaves
  /// at one border enters at the opposite one.
  std::array<double, 2> origin{0.0, 0.0};
  /// Takes every `stride`-th pixel of a larger image along each axis, starting with the first. The
  /// footprint is still one pixel of the larger image. >= 1; 1 for a tileable image.
  int stride = 1;
  bool tileable = false; ///< opposite borders continue each other; needs at least half a tile
  EvaluationOptions evaluation;
  /// For a mix: the weights at the left and the right border, linear between them, in
  /// kMixWeightRange. Must be equal if the image is tileable.
  std::array<double, 2> mix{0.0, 0.0};
  Progress progress; ///< empty: no reports
};

/// Evaluates the noise at the pixel centres, (x + 1/2, y + 1/2) pixels from the origin, with the
/// footprint of one pixel. Returns decoded values (light for colour) in as many channels as the map
/// has. Errors: usage for options out of range or a map that the noise does not have; resources if
/// memory runs out; environment if `options.progress` stops it. Multi-threaded; same result for any
/// number of threads.
[[nodiscard]] Result<LinearImage> synthesize(const Bundle& bundle, const SynthesisOptions& options);

/// Synthesizes a power-of-two image of the material's pattern, `tiles` exemplars per side and
/// repeating, for the core slots of a glTF material. The size follows the noise's widest and
/// highest maps, so the images of all maps have the same size, at most 1024 pixels per side. A mix
/// is evaluated at its middle. Errors: usage for an index or parameter out of range, a map that the
/// noise does not have, or tiles outside [1, 1024].
[[nodiscard]] Result<LinearImage>
synthesizePreview(const Bundle& bundle, const MaterialNoise& material, MapTarget map, int tiles);

/// The pixels of a result along x and y of a tile of noise `noise`: the pixels of the exemplar of
/// one of its maps if `texelsPerTile` is 0, otherwise alike for all its maps. As exemplarSize().
[[nodiscard]] std::array<double, 2> pixelsPerTile(const Bundle& bundle, std::size_t noise,
                                                  const NoiseMap& map, double texelsPerTile);

/// `values` holds decoded values, as synthesize() returns them: all channels of the map, in order.
/// Slopes become unit normals, stored as (n + 1) / 2 in RGB with green up. Occlusion, roughness and
/// metallic go to red, green and blue; absent ones are 1. Other maps are returned unchanged. Throws
/// std::bad_alloc, as all building blocks do.
[[nodiscard]] LinearImage coreTexture(const NoiseMap& map, LinearImage values);

/// The RGB of `color`, or white if that is empty, with `opacity`, of the same size, as alpha.
/// Throws std::bad_alloc.
[[nodiscard]] LinearImage withAlpha(const LinearImage& color, const LinearImage& opacity);

/// Encodes a core texture as PNG. Light is stored in sRGB; data and alpha are stored unchanged. The
/// file has 8 bits per channel, or 16 for a height, which no core material uses but `synth` writes.
/// Errors: as encodePng().
[[nodiscard]] Result<std::vector<std::byte>> encodeCoreTexture(MapTarget target,
                                                               LinearImage texture);

} // namespace lichen
