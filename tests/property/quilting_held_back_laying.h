// SPDX-License-Identifier: MIT
// How the structured kinds of quilting_held_back_pictures.h are laid.
//
// Positions and lengths are in units of the kind, about the width of its cells; y points down.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace lichen::test {

/// A position or an offset.
struct Point {
  float x = 0.0f, y = 0.0f;
};

/// What lies at a position.
struct Spot {
  Point middle;           ///< of its cell or its thread; no other has this middle
  Point axis{1.0f, 0.0f}; ///< along which fibres lie
  float inside = 0.0f;    ///< distance to the border of the cell
  float height = 0.0f;    ///< of a cloth, in [0, 1]
  float slant = 0.0f;     ///< of a cell's surface, in [-1, 1]: raised or lowered
};

enum class Matter { stone, ceramic, wood, yarn };

struct Laying {
  const char* name;
  Spot (*at)(Point p);
  Point box; ///< the rectangle after which everything repeats
  Matter matter = Matter::stone;
  bool overlaps = false;             ///< cells lie in the shadow of others
  float fewest = 6.0f, most = 12.0f; ///< units along the side of a picture
};

/// `whole` is a whole number.
inline bool isOdd(float whole) { return std::abs(whole - 2.0f * std::floor(0.5f * whole)) > 0.5f; }

/// The cell of a rectangle with this middle and these half sides.
inline Spot rectangle(Point p, Point middle, Point half) {
  Spot spot;
  spot.middle = middle;
  spot.axis = half.x >= half.y ? Point{1.0f, 0.0f} : Point{0.0f, 1.0f};
  spot.inside = std::min(half.x - std::abs(p.x - middle.x), half.y - std::abs(p.y - middle.y));
  return spot;
}

[[nodiscard]] std::vector<Laying> masonryLayings();
[[nodiscard]] std::vector<Laying> woodLayings();
[[nodiscard]] std::vector<Laying> clothLayings();

} // namespace lichen::test
