// SPDX-License-Identifier: MIT
// Decodes by the inverse table or in closed form. Steps and names follow
// shaders_glsl/noise/decode.glsl with a trilinear sampler.
#include "value_decoder.h"

#include "polynomial_cdf.h"
#include "sampling/repeating_image.h"

#include <algorithm>
#include <cmath>

namespace lichen::gaussianization {

using Value = ValueDecoder::Value;

ValueDecoder::ValueDecoder(const Bundle& bundle, const shader::LichenMap& constants,
                           std::optional<std::size_t> inverseTable)
    : constants_(constants) {
  if (!inverseTable)
    return;
  const Table& table = bundle.tables[*inverseTable];
  for (std::uint32_t level = 0; level < table.mipLevels; ++level)
    table_.push_back({int(table.width >> level), texelsOf(table, level)});
}

Value ValueDecoder::lookup(const Value& uniform, std::size_t level) const {
  const std::vector<Value>& cells = table_[level].cells;
  const auto side = std::size_t(table_[level].side);
  std::array<std::size_t, 3> step{};
  std::array<float, 3> fraction{};
  std::size_t first = 0;
  std::size_t stride = 1;
  for (std::size_t axis = 0; axis < constants_.dimensions; ++axis, stride *= side) {
    const float place = std::clamp(uniform[axis] * float(side) - 0.5f, 0.0f, float(side - 1));
    const auto cell = std::size_t(place);
    first += cell * stride;
    step[axis] = cell + 1 < side ? stride : 0;
    fraction[axis] = place - float(cell);
  }
  const auto line = [&](std::size_t at) {
    return mix(cells[at], cells[at + step[0]], fraction[0]);
  };
  const auto square = [&](std::size_t at) {
    return step[1] > 0 ? mix(line(at), line(at + step[1]), fraction[1]) : line(at);
  };
  return step[2] > 0 ? mix(square(first), square(first + step[2]), fraction[2]) : square(first);
}

/// lichenDecodeTable.
Value ValueDecoder::decodeTable(const Value& gaussian, float lost, bool nearestLevel) const {
  constexpr float kLevels = 5.0f;
  const float retained = std::sqrt(std::max(1.0f - lost, 0.0f));
  float level = std::min(kLevels - kLevels * retained, float(table_.size() - 1));
  if (nearestLevel)
    level = std::floor(level + 0.5f);
  Value uniform{};
  for (std::size_t axis = 0; axis < constants_.dimensions; ++axis)
    uniform[axis] = polynomialCdf(gaussian[axis]);
  const auto fine = std::size_t(level);
  const float t = level - float(fine);
  Value value = lookup(uniform, fine);
  if (t > 0.0f)
    value = mix(value, lookup(uniform, fine + 1), t);
  if (constants_.encoding == LICHEN_ENCODING_ROOT)
    for (float& component : value)
      component *= component;
  return value;
}

Value ValueDecoder::decode(const Value& gaussian, float contrast, bool nearestLevel) const {
  const float lost = gaussian[3];
  const float within = std::min(contrast, 1.0f);
  const float scaled = contrast * contrast * lost;
  if (constants_.decoding == LICHEN_DECODING_GAUSSIAN ||
      constants_.encoding == LICHEN_ENCODING_INDEX)
    return decodedGaussian(constants_, {gaussian[0], gaussian[1], gaussian[2]},
                           {scaled, scaled, scaled});
  Value value = decodeTable(gaussian, within * within * lost, nearestLevel);
  // As lichenDecode has it.
  if (constants_.encoding == LICHEN_ENCODING_SLOPE)
    value[2] *= std::max(1.0f, 2.0f * contrast - 1.0f);
  return value;
}

std::array<float, 3> ValueDecoder::gradient(const Value& gaussian,
                                            const std::array<float, 3>& alongX,
                                            const std::array<float, 3>& alongY,
                                            float contrast) const {
  const auto decodedSlope = [&](const std::array<float, 3>& slope) {
    constexpr float kStep = 1.0f / 96.0f, kLeast = 1e-20f;
    const float length = std::hypot(slope[0], slope[1], slope[2]);
    Value before = gaussian, after = gaussian;
    for (std::size_t c = 0; c < 3; ++c) {
      before[c] -= kStep * slope[c] / std::max(length, kLeast);
      after[c] += kStep * slope[c] / std::max(length, kLeast);
    }
    return contrast * length / (2.0f * kStep) *
           (decode(after, contrast)[0] - decode(before, contrast)[0]);
  };
  return {decode(gaussian, contrast)[0], decodedSlope(alongX), decodedSlope(alongY)};
}

} // namespace lichen::gaussianization
