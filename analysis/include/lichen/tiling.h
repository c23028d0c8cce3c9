// SPDX-License-Identifier: MIT
// Bakes exemplars for tiling and blending on a simplex grid [HN18].
#pragma once

#include <lichen/bundle.h>
#include <lichen/progress.h>
#include <lichen/result.h>
#include <lichen/transport.h>

#include <span>
#include <string>
#include <vector>

namespace lichen {

/// One map of an exemplar: `channels.size()` (1 to 3) interleaved values a pixel, row 0 at the top,
/// in the encoding stated.
struct MapExemplar {
  MapTarget target = MapTarget::baseColor;
  std::vector<MapChannel> channels;
  ValueEncoding encoding = ValueEncoding::srgb;
  int width = 0;
  int height = 0;
  std::vector<float> values; ///< width * height * channels.size(), finite
  /// The step between neighbouring stored values: 1/255 of an 8-bit file. Variation below its
  /// rounding error counts as none.
  double quantum = 1.0 / 255.0;
};

/// Whether the exemplar's opposite borders fit together.
enum class Periodic { detect, yes, no };

struct TilingOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the tables
  TransportEffort transport = TransportEffort::standard;
  Progress progress; ///< empty: nobody watches
};

/// What a bake made: tables numbered from 0 in the maps of `noise`.
struct TilingBake {
  Noise noise;
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
};

/// Gaussianizes each map by optimal transport, makes it periodic, and fits its inverse table with
/// prefiltered slabs. Maps have sides of 1 to 16,384 pixels. Errors: usage for options or maps
/// outside their ranges, resources when memory does not suffice,
/// environment when `options.progress` stops it. Deterministic for any number of
/// threads. O(N log N) in the number of pixels.
[[nodiscard]] Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                                            const TilingOptions& options);

} // namespace lichen
