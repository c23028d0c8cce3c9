// SPDX-License-Identifier: MIT
// Gaussian values with lost variance -> the mean of the decoded values, in closed form.
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// The mean of the decoded value for a stored value that is Gaussian about `stored`:
/// lichenDecodeGaussian.
float meanDecoded(float stored, float variance, shader::uint encoding) {
  constexpr float kHalfLn2 = float(0.5 * std::numbers::ln2);
  constexpr float kMostLog = 16.0f; // kHalfMax is below 2^16 - 1
  switch (encoding) {
  case LICHEN_ENCODING_SLOPE:
    return stored;
  case LICHEN_ENCODING_LINEAR:
    return std::clamp(stored, 0.0f, 1.0f);
  case LICHEN_ENCODING_LOG2:
    return std::max(std::exp2(std::min(stored + kHalfLn2 * variance, kMostLog)) - 1.0f, 0.0f);
  default:
    return stored * stored + variance;
  }
}

} // namespace

std::array<float, 4> decodedGaussian(const shader::LichenMap& map,
                                     const std::array<float, 3>& gaussian,
                                     const std::array<float, 3>& lostVariance) {
  if (map.encoding == LICHEN_ENCODING_INDEX)
    return {gaussian[0], gaussian[1], gaussian[2], lostVariance[0]};
  const std::array<const shader::vec4*, 3> rows{&map.row0, &map.row1, &map.row2};
  std::array<float, 4> value{0.0f, 0.0f, 0.0f, 1.0f};
  std::array<float, 3> variance{};
  constexpr float kVariance = 1.0f / 36.0f; // of a Gaussian value: rows are six times the root
  for (std::size_t c = 0; c < 3; ++c) {
    const shader::vec4& row = *rows[c];
    const float stored = row.x * (gaussian[0] - 0.5f) + row.y * (gaussian[1] - 0.5f) +
                         row.z * (gaussian[2] - 0.5f) + row.w;
    variance[c] = lostVariance[c] * kVariance * (row.x * row.x + row.y * row.y + row.z * row.z);
    value[c] = meanDecoded(stored, variance[c], map.encoding);
  }
  if (map.encoding == LICHEN_ENCODING_SLOPE)
    value[2] = 0.5f * (variance[0] + variance[1]);
  return value;
}

} // namespace lichen
