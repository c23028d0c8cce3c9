// SPDX-License-Identifier: MIT
#include "value_encoding.h"

#include "color_space.h"

#include <lichen/image.h>
#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace lichen::exemplar {

float decoded(float value, ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return srgbToLinear(value);
  case ValueEncoding::root:
    return value * value;
  case ValueEncoding::log2:
    return std::exp2(value) - 1.0f;
  case ValueEncoding::linear:
  case ValueEncoding::slope:
  case ValueEncoding::index:
    return value;
  }
  return value;
}

float encoded(float value, ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return linearToSrgb(value);
  case ValueEncoding::root:
    return std::sqrt(std::max(0.0f, value));
  case ValueEncoding::log2:
    return std::log2(value + 1.0f);
  case ValueEncoding::linear:
  case ValueEncoding::slope:
  case ValueEncoding::index:
    return value;
  }
  return value;
}

float tableValue(float stored, ValueEncoding encoding) {
  const float value = decoded(stored, encoding);
  return storedEncoding(encoding) == ValueEncoding::root ? encoded(value, ValueEncoding::root)
                                                         : value;
}

float storedOfTable(float tableValue, ValueEncoding encoding) {
  const bool isRoot = storedEncoding(encoding) == ValueEncoding::root;
  return encoded(isRoot ? decoded(tableValue, ValueEncoding::root) : tableValue, encoding);
}

ValueEncoding storedEncoding(ValueEncoding encoding) {
  return encoding == ValueEncoding::srgb ? ValueEncoding::root : encoding;
}

MapExemplar asStored(const MapExemplar& map) {
  MapExemplar stored = map;
  stored.encoding = storedEncoding(map.encoding);
  if (stored.encoding != map.encoding)
    for (float& value : stored.values)
      value = encoded(decoded(value, map.encoding), stored.encoding);
  return stored;
}

std::vector<MapExemplar> asStored(std::span<const MapExemplar> maps) {
  std::vector<MapExemplar> stored;
  stored.reserve(maps.size());
  for (const MapExemplar& map : maps)
    stored.push_back(asStored(map));
  return stored;
}

// One map -> whether a bake accepts it.
namespace {

std::string shortest(float value) {
  std::array<char, 16> digits{}; // fits the shortest text that parses back to any float
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// Returns a value that tables cannot hold, or whose decoded value they cannot hold.
std::optional<float> valueOutOfRange(const MapExemplar& map) {
  // From here on, rounding to half gives infinity: half a step, 2^4, above the largest half.
  constexpr float kBeyondHalf = kHalfMax + 16.0f;
  const auto fits = [](float v) { return v > -kBeyondHalf && v < kBeyondHalf; };
  for (const float value : map.values)
    if (!fits(value))
      return value;
  // Decoding is monotonic.
  const auto [least, most] = std::minmax_element(map.values.begin(), map.values.end());
  for (const float value : {*least, *most})
    if (!fits(decoded(value, map.encoding)))
      return value;
  return std::nullopt;
}

} // namespace

Result<void> checkRanges(const MapExemplar& map) {
  const auto usage = [](const std::string& message) { return Error{ErrorKind::usage, message}; };
  if (map.width < 1 || map.height < 1 || map.width > kMaxImageSide || map.height > kMaxImageSide)
    return usage("a map of " + std::to_string(map.width) + " x " + std::to_string(map.height) +
                 " pixels; expected sides from 1 to " + std::to_string(kMaxImageSide));
  if (map.channels.empty() || map.channels.size() > std::size_t(kMaxChannels))
    return usage("a map of " + std::to_string(map.channels.size()) + " channels; expected 1 to 3");
  if (map.values.size() != std::size_t(map.width) * std::size_t(map.height) * map.channels.size())
    return usage("a map with " + std::to_string(map.values.size()) +
                 " values; expected width x height x channels");
  if (const std::optional<float> value = valueOutOfRange(map))
    return usage("a map with the value " + shortest(*value) + ", which stands for " +
                 shortest(decoded(*value, map.encoding)) + "; expected both from " +
                 shortest(-kHalfMax) + " to " + shortest(kHalfMax));
  if (!(map.quantum > 0.0) || !(map.quantum <= 1.0))
    return usage("a quantum of " + std::to_string(map.quantum) +
                 "; expected above 0 and at most 1");
  return {};
}

Result<void> checkRanges(std::span<const MapExemplar> maps) {
  if (maps.empty())
    return Error{ErrorKind::usage, "no map; expected at least one"};
  for (const MapExemplar& map : maps)
    if (Result<void> checked = checkRanges(map); !checked)
      return checked;
  return {};
}

} // namespace lichen::exemplar
