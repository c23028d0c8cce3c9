// SPDX-License-Identifier: MIT
// Gaussian values with lost variance -> the mean of the decoded values, in closed form.
#include "srgb_curve.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

constexpr double kMostLog = 16.0; // kHalfMax is below 2^16 - 1

double normalCdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double normalDensity(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
}

/// Decodes a stored value, clamped to the range of its encoding.
double decodedStored(double stored, shader::uint encoding) {
  switch (encoding) {
  case LICHEN_ENCODING_SLOPE:
    return stored;
  case LICHEN_ENCODING_LOG2:
    return std::exp2(std::clamp(stored, 0.0, kMostLog)) - 1.0;
  case LICHEN_ENCODING_LINEAR:
    return std::clamp(stored, 0.0, 1.0);
  default:
    return double(srgbToLight(float(std::clamp(stored, 0.0, 1.0))));
  }
}

/// The mean of max(2^x - 1, 0) for Gaussian x.
double meanLog(double stored, double deviation) {
  const double tilt = std::numbers::ln2 * deviation;
  const double light = std::exp2(std::min(stored + 0.5 * tilt * deviation, kMostLog));
  return std::min(light * normalCdf(stored / deviation + tilt) - normalCdf(stored / deviation),
                  double(kHalfMax));
}

/// The mean of the decoded value for a stored value that is Gaussian about `stored`. Twin of
/// lichenMeanDecoded, which explains the steps.
double meanDecoded(double stored, double deviation, shader::uint encoding) {
  constexpr double kLeast = 1e-6;
  deviation = std::max(deviation, kLeast);
  if (encoding == LICHEN_ENCODING_LOG2)
    return meanLog(stored, deviation);
  const double above = normalCdf((stored - 1.0) / deviation);
  const double atOne = deviation * normalDensity((stored - 1.0) / deviation);
  const double atZero = deviation * normalDensity(stored / deviation);
  const double moment0 = 1.0 - normalCdf(-stored / deviation) - above;
  const double moment1 = stored * moment0 + atZero - atOne;
  if (encoding == LICHEN_ENCODING_LINEAR)
    return moment1 + above;
  const double variance = deviation * deviation;
  const double moment2 = stored * moment1 + variance * moment0 - atOne;
  const double moment3 = stored * moment2 + 2.0 * variance * moment1 - atOne;
  const double moment4 = stored * moment3 + 3.0 * variance * moment2 - atOne;
  constexpr double kCurve1 = 0.038181, kCurve2 = 0.525763, kCurve3 = 0.568864, kCurve4 = -0.132808;
  const double x = std::clamp(stored, 0.0, 1.0);
  const double curve = x * (kCurve1 + x * (kCurve2 + x * (kCurve3 + x * kCurve4)));
  return kCurve1 * moment1 + kCurve2 * moment2 + kCurve3 * moment3 + kCurve4 * moment4 + above -
         curve + decodedStored(stored, encoding);
}

} // namespace

std::array<float, 4> decodedGaussian(const shader::LichenMap& map,
                                     const std::array<float, 3>& gaussian,
                                     const std::array<float, 3>& lostVariance) {
  const std::array<const shader::vec4*, 3> rows{&map.row0, &map.row1, &map.row2};
  std::array<float, 4> value{0.0f, 0.0f, 0.0f, 1.0f};
  std::array<float, 3> variance{};
  constexpr float kVariance = 1.0f / 36.0f; // of a Gaussian value: rows are six times the root
  for (std::size_t c = 0; c < 3; ++c) {
    const shader::vec4& row = *rows[c];
    const float stored = row.x * (gaussian[0] - 0.5f) + row.y * (gaussian[1] - 0.5f) +
                         row.z * (gaussian[2] - 0.5f) + row.w;
    variance[c] = lostVariance[c] * kVariance * (row.x * row.x + row.y * row.y + row.z * row.z);
    value[c] = map.encoding == LICHEN_ENCODING_SLOPE
                   ? stored
                   : float(std::max(0.0, meanDecoded(double(stored), std::sqrt(double(variance[c])),
                                                     map.encoding)));
  }
  if (map.encoding == LICHEN_ENCODING_SLOPE)
    value[2] = 0.5f * (variance[0] + variance[1]);
  return value;
}

} // namespace lichen
