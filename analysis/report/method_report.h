// SPDX-License-Identifier: MIT
// What comparison and report need from a method. Each method implements it in methods/, and
// methods.cpp lists them.
#pragma once

#include "data_uri.h"

#include <lichen/noise_comparison.h>
#include <lichen/suitability.h>
#include <lichen/synthesize.h>

#include <nlohmann/json.hpp>

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

class MethodReport {
public:
  virtual ~MethodReport() = default;

  /// The risks of one map, as assessNoise() returns them.
  [[nodiscard]] virtual Result<std::vector<Risk>> assess(const AssessedMap& assessed,
                                                         const Progress& progress) const = 0;

  /// Whether all maps of a set are resampled to the size of the largest.
  [[nodiscard]] virtual bool enlargesMaps() const = 0;
  /// The number of pixels that judge() synthesizes.
  [[nodiscard]] virtual double judgedPixels(int, int) const { return 0.0; }
  /// Adds measures of the result, and the method's own pictures, to a comparison that already has
  /// its pictures.
  [[nodiscard]] virtual Result<void> measure(const ComparedResult& result,
                                             NoiseComparison& comparison) const = 0;
  /// Adds measures that need more than the result.
  [[nodiscard]] virtual Result<void> judge(const ComparedResult&, NoiseComparison&) const {
    return {};
  }

  /// The most pixels of all of a map's pictures on the page, except for the table's, in units of
  /// side^2.
  [[nodiscard]] virtual double picturePixels() const = 0;
  /// `title`, `text` and the picture `png` of the image that the shader fetches from; of a mix, at
  /// this weight. The picture has at most side^2 pixels.
  [[nodiscard]] virtual Result<nlohmann::ordered_json> image(const Bundle& bundle,
                                                             const Noise& noise,
                                                             const NoiseMap& map, double mixWeight,
                                                             int side) const = 0;
  /// Further pictures of what the bundle holds, each as image() returns one; `look` is that of the
  /// map.
  [[nodiscard]] virtual Result<nlohmann::ordered_json>
  furtherImages(const Bundle&, const Noise&, const NoiseMap&, const MapLook&, int) const {
    return nlohmann::ordered_json::array();
  }
  /// `picture`, `slices` and `levels` of the table that decodes Gaussian values; null if there is
  /// none.
  [[nodiscard]] virtual Result<nlohmann::ordered_json>
  table(const Bundle& bundle, const NoiseMap& map, const MapLook& look) const = 0;
};

[[nodiscard]] const MethodReport& reportOf(Method method);

} // namespace lichen
