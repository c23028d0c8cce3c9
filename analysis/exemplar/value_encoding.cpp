// SPDX-License-Identifier: MIT
#include "value_encoding.h"

#include <lichen/image.h>

#include <algorithm>
#include <cmath>

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

} // namespace lichen::exemplar
