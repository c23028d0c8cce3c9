// SPDX-License-Identifier: MIT
// Bundle and exemplar (width * height * channels) -> how far the noise is from the exemplar.
#include "evaluation/method_evaluator.h"
#include "exemplar/color_space.h"
#include "exemplar/value_encoding.h"
#include "sampling/texels.h"

#include <lichen/quality.h>
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
    if (noise >= bundle.noises.size() || map >= bundle.noises[noise].maps.size())
      return Error{ErrorKind::usage, "map " + std::to_string(map) + " of noise " +
                                         std::to_string(noise) + ": the bundle has no such map"};
    const NoiseMap& described = bundle.noises[noise].maps[map];
    const Table& gaussian = bundle.tables[described.as<TilingMap>().gaussian];
    if (int(gaussian.width) != exemplar.width || int(gaussian.height) != exemplar.height ||
        described.channels != exemplar.channels)
      return Error{ErrorKind::usage, "the exemplar is not the one from which the map was baked"};
    const auto evaluator = methodEvaluator(bundle, noise);
    std::vector<float> decoded;
    for (const Texel& texel : texelsOf(gaussian, 0, Alpha::lastChannel)) {
      constexpr float kShift = 0.5f - kStoredGaussianMean;
      const auto value =
          evaluator->decoded(map, {texel[0] + kShift, texel[1] + kShift, texel[2] + kShift});
      decoded.insert(decoded.end(), value.begin(), value.begin() + int(exemplar.channels.size()));
    }
    return compared(exemplar, decoded, periodic);
  });
}

} // namespace lichen
