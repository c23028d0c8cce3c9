// SPDX-License-Identifier: MIT
// Proportion -> the covariance of an indicator as a function of the field's correlation, by
// quadrature. Source: [T91], for one threshold.
#include "level_cut.h"

#include "gaussian/gaussian_distribution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace lichen::layers {
namespace {

constexpr int kSteps = 4096; // the quadrature's error is about 1e-8
constexpr double kStep = std::numbers::pi / kSteps;
constexpr double kLeast = 1e-12; // a divisor

/// [T91]: the covariance P(X > t, Y > t) - P(X > t)^2, differentiated by the arc sine of the
/// correlation. At t = 0 the covariance is the arc sine over 2 pi.
double slopeByArc(double threshold, double correlation) {
  return std::exp(-threshold * threshold / std::max(kLeast, 1.0 + correlation)) /
         (2.0 * std::numbers::pi);
}

} // namespace

LevelCut::LevelCut(double proportion)
    : threshold_((gaussian::gaussianQuantile(1.0 - proportion) - gaussian::kGaussianMean) /
                 gaussian::kGaussianDeviation),
      covariances_{0.0} {
  for (int i = 0; i < kSteps; ++i) {
    const double sine = std::sin(kStep * (i + 0.5) - std::numbers::pi / 2.0);
    covariances_.push_back(covariances_.back() + kStep * slopeByArc(threshold_, sine));
  }
  const double atZero = covariances_[kSteps / 2];
  for (double& value : covariances_)
    value -= atZero;
}

double LevelCut::slope(double correlation) const {
  return slopeByArc(threshold_, correlation) /
         std::sqrt(std::max(kLeast, 1.0 - correlation * correlation));
}

double LevelCut::covariance(double correlation) const {
  const double place = (std::asin(correlation) / std::numbers::pi + 0.5) * kSteps;
  const auto below = std::min(std::size_t(place), std::size_t(kSteps - 1));
  return std::lerp(covariances_[below], covariances_[below + 1], place - double(below));
}

double LevelCut::correlation(double covariance) const {
  if (covariance <= covariances_.front())
    return -1.0;
  if (covariance >= covariances_.back())
    return 1.0;
  const auto above = std::upper_bound(covariances_.begin(), covariances_.end(), covariance);
  const double share = (covariance - above[-1]) / (above[0] - above[-1]);
  return std::sin(kStep * (double(above - covariances_.begin()) - 1.0 + share) -
                  std::numbers::pi / 2.0);
}

} // namespace lichen::layers
