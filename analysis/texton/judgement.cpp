// SPDX-License-Identifier: MIT
// A stored texton and its exemplar -> its error and flatness, and the exemplar's Gaussian texture.
//
// Sources: [GLM14] section 4 and eq. 5.
#include "coefficients.h"
#include "exemplar/resample.h"
#include "exemplar/value_encoding.h"
#include "gaussian_model.h"
#include "transport/covariance.h"

#include <lichen/spectrum.h>
#include <lichen/texton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lichen {
namespace {

using namespace texton;
using Eigen::MatrixXd;

Error usage(std::string message) { return {ErrorKind::usage, std::move(message)}; }

GaussianModel modelOf(const MapExemplar& exemplar) {
  return gaussianModel(exemplar.values, exemplar.width, exemplar.height,
                       int(exemplar.channels.size()));
}

/// Returns the coefficients in the frame of a step.
TextonCoefficients storedCoefficients(const Table& image, const TextonShape& shape,
                                      const NoiseMap& map, std::size_t step) {
  const std::vector<float> texels = decodeLevel(image, 0);
  const auto stride = std::size_t(channelCount(image.format));
  const std::size_t top = step * shape.frameHeight();
  TextonCoefficients stored{shape.coefficientsX, shape.coefficientsY, int(map.channels.size()), {}};
  for (std::size_t c = 0; c < map.channels.size(); ++c)
    for (std::size_t y = 0; y < std::size_t(shape.coefficientsY); ++y)
      for (std::size_t x = 0; x < std::size_t(shape.coefficientsX); ++x)
        stored.values.push_back(float(map.as<TextonMap>().scale[c]) *
                                texels[((top + y) * image.width + x) * stride + c]);
  return stored;
}

TextonJudgement judged(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                       const MapExemplar& exemplar, std::size_t step) {
  const auto [width, height] = exemplarSize(bundle, noise, map);
  const bool fits = exemplar.width == int(width) && exemplar.height == int(height);
  const GaussianModel model =
      modelOf(fits ? exemplar : exemplar::resampled(exemplar, int(width), int(height), false));
  const auto& shape = noise.as<TextonShape>();
  TextonCoefficients texton =
      storedCoefficients(bundle.tables[map.as<TextonMap>().image], shape, map, step);
  // A texton that cannot have this covariance is judged unchanged.
  (void)correctCovariance(texton, shape.order, modelCovariance(model));
  return {relativeModelError(model, texton, shape.order),
          flatness(interpolatedSpot(texton, shape.order), seenWeights(map.channels))};
}

/// Returns the range that images of an encoding can hold.
std::pair<float, float> shownRange(ValueEncoding encoding) {
  constexpr float kNone = std::numeric_limits<float>::max();
  switch (encoding) {
  case ValueEncoding::slope:
    return {-kNone, kNone};
  case ValueEncoding::log2:
    return {0.0f, kNone};
  default:
    return {0.0f, 1.0f};
  }
}

/// [GGM11]: every channel with the same random phases.
MapExemplar gaussianTextureOf(const NoiseMap& map, const MapExemplar& exemplar,
                              std::uint64_t seed) {
  MapExemplar result = exemplar::asStored(exemplar);
  const GaussianModel model = modelOf(result);
  std::vector<std::vector<float>> planes;
  for (const HalfSpectrum& channel : model.channels)
    planes.push_back(phaseRandomizedPlane(channel, std::uint32_t(seed)));
  // The kernels of a model are divided by the root of the number of pixels.
  const std::size_t pixels = planes.front().size();
  const auto n = Eigen::Index(map.channels.size());
  const MatrixXd wanted = Eigen::Map<const MatrixXd>(map.covariance.data(), n, n);
  const MatrixXd correction =
      std::sqrt(double(pixels)) * transport::covarianceMap(modelCovariance(model), wanted);
  const auto [least, most] = shownRange(map.encoding);
  for (std::size_t i = 0; i < pixels; ++i)
    for (Eigen::Index c = 0; c < n; ++c) {
      double value = map.mean[std::size_t(c)];
      for (Eigen::Index d = 0; d < n; ++d)
        value += correction(c, d) * double(planes[std::size_t(d)][i]);
      result.values[i * std::size_t(n) + std::size_t(c)] = std::clamp(float(value), least, most);
    }
  return result;
}

} // namespace

Result<TextonJudgement> judgeTexton(const Bundle& bundle, std::size_t noiseIndex,
                                    const MapExemplar& exemplar, std::size_t step) {
  const auto exhausted = [] { return "not enough memory to judge a texton"; };
  return withinMemory(exhausted, [&]() -> Result<TextonJudgement> {
    if (noiseIndex >= bundle.noises.size())
      return usage("noise " + std::to_string(noiseIndex) + ": the bundle has " +
                   std::to_string(bundle.noises.size()));
    const Noise& noise = bundle.noises[noiseIndex];
    if (noise.method() != Method::texton)
      return usage("noise '" + noise.name + "' has the method " +
                   std::string(nameOf(noise.method())) + ", not texton");
    if (step >= std::size_t(noise.as<TextonShape>().steps))
      return usage("step " + std::to_string(step) + ": noise '" + noise.name + "' has " +
                   std::to_string(noise.as<TextonShape>().steps));
    const std::optional<std::size_t> place = findMap(noise, exemplar.target);
    if (!place)
      return usage("noise '" + noise.name + "' has no map " + std::string(nameOf(exemplar.target)));
    const NoiseMap& map = noise.maps[*place];
    if (map.channels != exemplar.channels)
      return Error{ErrorKind::badInput, "the exemplar has other channels than the map " +
                                            std::string(nameOf(map.target)) + " of noise '" +
                                            noise.name + "'"};
    return judged(bundle, noise, map, exemplar::asStored(exemplar), step);
  });
}

Result<MapExemplar> gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar,
                                    std::uint64_t seed) {
  const auto exhausted = [] { return "not enough memory for the exemplar's Gaussian texture"; };
  return withinMemory(exhausted, [&]() -> Result<MapExemplar> {
    if (map.channels != exemplar.channels)
      return usage("the exemplar has other channels than the map " +
                   std::string(nameOf(map.target)));
    return gaussianTextureOf(map, exemplar, seed);
  });
}

} // namespace lichen
