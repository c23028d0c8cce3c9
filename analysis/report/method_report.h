// SPDX-License-Identifier: MIT
// What comparison and report need from a method. Each method has one in methods/, and methods.cpp
// lists them.
#pragma once

#include "pictures.h"

#include <lichen/noise_comparison.h>
#include <lichen/suitability.h>
#include <lichen/synthesize.h>

#include <utility>
#include <vector>

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
  double judgedShare = 0.0; ///< of the progress: the part that judge() takes
  /// Whether all maps of a set are resampled to the size of the largest.
  bool enlargesMaps = false;
};

[[nodiscard]] const MethodReport& reportOf(Method method);

/// Gives the comparison these measures, or returns their error.
[[nodiscard]] inline Result<void> take(Result<std::vector<Measure>> measures,
                                       NoiseComparison& comparison) {
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  return {};
}

} // namespace lichen
