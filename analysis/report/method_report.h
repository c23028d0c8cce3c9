// SPDX-License-Identifier: MIT
// What comparison and report need from a method. Each method has one in methods/, and methods.cpp
// lists them.
#pragma once

#include "pictures.h"

#include <lichen/noise_comparison.h>
#include <lichen/suitability.h>
#include <lichen/synthesize.h>

namespace lichen {

/// The largest side of a synthesized result. A 4096 x 4096 RGB result takes 200 MB; more pixels do
/// not add information.
inline constexpr int kLargestResultSide = 4096;

/// A result of a noise and the exemplar that the noise was made from.
struct ComparedResult {
  const Bundle& bundle;
  const NoiseMap& map;
  const MapExemplar& exemplar; ///< same size as the map's exemplar
  bool isEnlarged = false;     ///< resampled from a smaller map to the size of the set's largest
  const SynthesisOptions& options; ///< of the result
  Progress progress;               ///< of any further synthesis
};

/// A noise's map and the exemplars of the noise, as they were baked.
struct AssessedMap {
  const Noise& noise;
  std::span<const MapExemplar> maps;
  std::size_t place = 0; ///< of the map among `maps`
  bool bordersFit = true;

  [[nodiscard]] const MapExemplar& map() const { return maps[place]; }
};

struct MethodReport {
  /// The risks of one map, as assessNoise() returns them.
  Result<std::vector<Risk>> (*assess)(const AssessedMap& assessed, const Progress& progress);
  /// Adds measures of the result, and the method's own pictures, to a comparison that already has
  /// its pictures.
  Result<void> (*measure)(const ComparedResult& result, NoiseComparison& comparison);
  /// Adds measures that need more than the result; null if there are none.
  Result<void> (*judge)(const ComparedResult& result, NoiseComparison& comparison) = nullptr;
  /// The number of pixels that judge() synthesizes, for an exemplar of this size; null for none.
  double (*judgedPixels)(int width, int height) = nullptr;
  /// The most pixels of all of a map's pictures on the page, in units of the exemplar's.
  double picturePixels = 0.0;
  /// Whether all maps of a set are resampled to the size of the largest.
  bool enlargesMaps = false;
};

[[nodiscard]] const MethodReport& reportOf(Method method);

} // namespace lichen
