// SPDX-License-Identifier: MIT
// Bundle and exemplar (width * height * channels) -> how far the noise is from the exemplar.
#include "exemplar/color_space.h"
#include "exemplar/value_encoding.h"

#include <lichen/quality.h>
#include <lichen/tiling_evaluate.h>
#include <lichen/tiling_precision.h>

#include <cmath>

namespace lichen {
namespace {

/// Stored values as an image, for the measures of quality.h.
SrgbImage imageOf(const MapExemplar& exemplar, std::vector<float> stored) {
  SrgbImage image;
  image.width = exemplar.width;
  image.height = exemplar.height;
  image.channels = int(exemplar.channels.size());
  image.values = std::move(stored);
  return twoAsRedGreen(std::move(image));
}

Result<PrecisionLoss> compared(const MapExemplar& exemplar, const std::vector<float>& decodedTexels,
                               bool periodic) {
  const int channels = int(exemplar.channels.size());
  std::vector<float> wantedValues(exemplar.values.size());
  std::vector<float> stored(exemplar.values.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    wantedValues[i] = exemplar::decoded(exemplar.values[i], exemplar.encoding);
    stored[i] = exemplar::encoded(decodedTexels[i], exemplar.encoding);
    const double error = double(decodedTexels[i]) - double(wantedValues[i]);
    squares += error * error;
  }
  const exemplar::Moments wanted = exemplar::momentsOf(wantedValues, channels);
  const exemplar::Moments found = exemplar::momentsOf(decodedTexels, channels);
  const double variance = wanted.covariance.trace();
  if (variance <= 0.0)
    return PrecisionLoss{};
  PrecisionLoss loss;
  loss.mean = (found.mean - wanted.mean).cwiseAbs().maxCoeff();
  loss.variance = 1.0 - found.covariance.trace() / variance;
  if (periodic)
    loss.roundTrip = std::sqrt(squares / double(stored.size() / std::size_t(channels)) / variance);
  const Result<double> distance =
      colorDistance(imageOf(exemplar, exemplar.values), imageOf(exemplar, std::move(stored)));
  if (!distance)
    return distance.error();
  loss.colorDistance = distance.value();
  return loss;
}

} // namespace

Result<PrecisionLoss> precisionLoss(const Bundle& bundle, std::size_t noise, std::size_t map,
                                    const MapExemplar& exemplar, bool periodic) {
  const auto exhausted = [] { return "not enough memory to measure a map's tables"; };
  return withinMemory(exhausted, [&]() -> Result<PrecisionLoss> {
    const Result<TilingEvaluator> evaluator = TilingEvaluator::create(bundle, noise);
    if (!evaluator)
      return evaluator.error();
    if (map >= evaluator.value().mapCount())
      return Error{ErrorKind::usage, "map " + std::to_string(map) + ": the noise has " +
                                         std::to_string(evaluator.value().mapCount())};
    const NoiseMap& described = bundle.noises[noise].maps[map];
    const Table& gaussian = bundle.tables[described.as<TilingMap>().gaussian];
    if (int(gaussian.width) != exemplar.width || int(gaussian.height) != exemplar.height ||
        described.channels != exemplar.channels)
      return Error{ErrorKind::usage, "the exemplar is not the one from which the map was baked"};
    const std::vector<float> texels = evaluator.value().decodedTexels(map);
    return compared(exemplar, texels, periodic);
  });
}

} // namespace lichen
