// SPDX-License-Identifier: MIT
// Splits a place far from the origin into a corner of cells, which integers hold, and the rest.
#pragma once

#include <cmath>
#include <cstdint>

namespace lichen {

/// A place [tiles] as a multiple of `step` tiles, which is a corner of cells, and the rest.
struct SplitOrigin {
  std::int64_t tile;
  float offset;
};

inline SplitOrigin splitOrigin(std::int64_t origin, double offset, std::int64_t step) {
  const double whole = std::floor(offset);
  const std::int64_t tile = origin + std::int64_t(whole);
  const std::int64_t rest = (tile % step + step) % step;
  return {tile - rest, float(offset - whole + double(rest))};
}

/// The same of a place that is no whole number of tiles.
inline SplitOrigin splitOrigin(double origin, double offset, std::int64_t step) {
  const double whole = std::floor(origin);
  return splitOrigin(std::int64_t(whole), origin - whole + offset, step);
}

} // namespace lichen
