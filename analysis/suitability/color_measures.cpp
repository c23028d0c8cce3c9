// SPDX-License-Identifier: MIT
// Values (height, width, channels) -> entropies of their 8-bit codes, in nats. Source: [CT06],
// eqs. 2.1 (entropy) and 8.8 (entropy of a normal distribution).
#include "color_measures.h"

#include "risk_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace lichen::suitability {
namespace {

constexpr std::size_t kCodes = 256;

std::uint8_t codeOf(float value) {
  return std::uint8_t(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

/// The contribution of one bin to the entropy.
double termOf(std::size_t count, std::size_t all) {
  const double share = double(count) / double(all);
  return count == 0 ? 0.0 : -share * std::log(share);
}

/// Infinite if the channel does not vary.
double spacingOf(const std::array<std::size_t, kCodes>& histogram, std::size_t all) {
  double entropy = 0.0, mean = 0.0, square = 0.0;
  for (std::size_t code = 0; code < kCodes; ++code) {
    const double share = double(histogram[code]) / double(all);
    entropy += termOf(histogram[code], all);
    mean += share * double(code);
    square += share * double(code) * double(code);
  }
  if (entropy == 0.0)
    return std::numeric_limits<double>::infinity();
  const double deviation = std::sqrt(std::max(0.0, square - mean * mean));
  return std::sqrt(2.0 * std::numbers::pi * std::numbers::e) * deviation / std::exp(entropy);
}

/// exp(entropy) of the colours.
double countOf(const MapExemplar& map) {
  const std::size_t channels = map.channels.size();
  std::vector<std::uint32_t> colors;
  colors.reserve(map.values.size() / channels);
  for (std::size_t i = 0; i < map.values.size(); i += channels) {
    std::uint32_t color = 0;
    for (std::size_t c = 0; c < channels; ++c)
      color = color << 8 | codeOf(map.values[i + c]);
    colors.push_back(color);
  }
  std::sort(colors.begin(), colors.end());
  double entropy = 0.0;
  for (auto first = colors.begin(); first != colors.end();) {
    const auto last = std::upper_bound(first, colors.end(), *first);
    entropy += termOf(std::size_t(last - first), colors.size());
    first = last;
  }
  return std::exp(entropy);
}

} // namespace

FewColors fewColors(const MapExemplar& map) {
  if (map.target != MapTarget::baseColor || map.encoding != ValueEncoding::srgb)
    return {};
  const std::size_t channels = map.channels.size();
  double spacing = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < channels; ++c) {
    std::array<std::size_t, kCodes> histogram{};
    for (std::size_t i = c; i < map.values.size(); i += channels)
      ++histogram[codeOf(map.values[i])];
    spacing = std::min(spacing, spacingOf(histogram, map.values.size() / channels));
  }
  if (std::isinf(spacing))
    return {};
  return {spacing, spacing < kColorSpacing.mild ? 0.0 : countOf(map)};
}

// Values (height, width, channels) -> shares of white and black pixels.

ClippedShare clippedShare(const MapExemplar& map) {
  if (map.target != MapTarget::baseColor || map.encoding != ValueEncoding::srgb)
    return {};
  const auto halfQuantum = float(0.5 * map.quantum);
  std::size_t white = 0, black = 0;
  const auto channels = std::ptrdiff_t(map.channels.size());
  for (auto pixel = map.values.begin(); pixel != map.values.end(); pixel += channels) {
    const auto [least, most] = std::minmax_element(pixel, pixel + channels);
    white += std::size_t(*least >= 1.0f - halfQuantum);
    black += std::size_t(*most <= halfQuantum);
  }
  const double pixels = double(map.values.size()) / double(channels);
  return {double(white) / pixels, double(black) / pixels};
}

} // namespace lichen::suitability
