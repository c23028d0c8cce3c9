// SPDX-License-Identifier: MIT
// A stored texton and its exemplar -> its error and flatness, and the exemplar's Gaussian texture.
//
// Sources: [GLM14] section 4 and eq. 5.
#include "judgement.h"

#include "coefficients.h"
#include "exemplar/resample.h"
#include "exemplar/value_encoding.h"
#include "gaussian_model.h"
#include "texton_table.h"
#include "transport/covariance.h"

#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lichen::texton {
namespace {

using Eigen::MatrixXd;

GaussianModel modelOf(const MapExemplar& exemplar) {
  return gaussianModel(exemplar.values, exemplar.width, exemplar.height,
                       int(exemplar.channels.size()));
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

} // namespace

TextonJudgement judgeTexton(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                            const MapExemplar& exemplar, std::size_t step) {
  MapExemplar stored = exemplar::asStored(exemplar);
  const auto [width, height] = exemplarSize(bundle, noise, map);
  if (stored.width != int(width) || stored.height != int(height))
    stored = exemplar::resampled(stored, int(width), int(height), false);
  const GaussianModel model = modelOf(stored);
  const int order = noise.as<TextonShape>().order;
  TextonCoefficients texton = storedTexton(noise, {&map, 1}, bundle.tables, int(step));
  // A texton that cannot have this covariance is judged unchanged.
  (void)correctCovariance(texton, order, modelCovariance(model));
  return {relativeModelError(model, texton, order),
          flatness(interpolatedSpot(texton, order), seenWeights(map.channels))};
}

// [GGM11]: every channel with the same random phases.
MapExemplar gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar, std::uint32_t seed) {
  MapExemplar result = exemplar::asStored(exemplar);
  const GaussianModel model = modelOf(result);
  std::vector<std::vector<float>> planes;
  for (const HalfSpectrum& channel : model.channels)
    planes.push_back(phaseRandomizedPlane(channel, seed));
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

} // namespace lichen::texton
