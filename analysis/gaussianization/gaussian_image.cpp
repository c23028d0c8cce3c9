// SPDX-License-Identifier: MIT
// Map (width * height * n values) -> width * height Gaussian points.
#include "gaussian_image.h"

#include "gaussian/cross_fade.h"

#include <Eigen/Cholesky>

namespace lichen::gaussianization {

Gaussianized gaussianImage(const MapExemplar& map, gaussian::BorderTreatment borders,
                           gaussian::Precision precision, ProgressPart progress) {
  // Part of the progress; whitening takes the rest.
  constexpr double kPoints = 0.3, kFaded = 0.6;
  const auto n = Eigen::Index(map.channels.size());
  const exemplar::Moments moments = exemplar::momentsOf(map.values, int(n));
  const Eigen::LLT<exemplar::ChannelMatrix> factor(moments.covariance);
  std::vector<Point> points(map.values.size() / std::size_t(n));
  for (std::size_t i = 0; i < points.size(); ++i) {
    exemplar::ChannelVector centred(n);
    for (Eigen::Index c = 0; c < n; ++c)
      centred[c] = double(map.values[i * std::size_t(n) + std::size_t(c)]) - moments.mean[c];
    const exemplar::ChannelVector g =
        gaussian::kGaussianDeviation * factor.matrixL().solve(centred);
    const auto channel = [&](Eigen::Index c) {
      return c < n ? float(gaussian::kGaussianMean + g[c]) : 0.0f;
    };
    points[i] = {channel(0), channel(1), channel(2)};
  }
  progress.reach(kPoints);
  if (!borders.fit)
    points = gaussian::crossFadeBorders(points, map.width, map.height, borders.grain);
  progress.reach(kFaded);
  return {
      map.width, map.height, int(n), gaussian::whitenedForStorage(points, int(n), precision), {}};
}

} // namespace lichen::gaussianization
