// SPDX-License-Identifier: MIT
// A picture of a plane seen slightly from a side -> how much narrower its far sides are.
#pragma once

#include "exemplar/planes.h"

#include <array>
#include <functional>
#include <optional>

namespace lichen::placement {

/// A rectangle seen as a quadrilateral: first as a trapezoid whose left side is shorter by the
/// share `x`, and that with an upper side that is shorter by the share `y`. If a share is negative,
/// the opposite side is shorter. (-1, 1)
struct Keystone {
  double x = 0.0, y = 0.0;
};

/// A position in the straightened picture -> in the picture; both from 0 to 1 along each side.
[[nodiscard]] std::array<double, 2> seen(const Keystone& keystone, double u, double v);

/// The quadrilateral as a rectangle of the picture's size. Throws std::bad_alloc.
[[nodiscard]] exemplar::ImageLevel straightened(const exemplar::ImageLevel& image,
                                                const Keystone& keystone);

/// How highly a picture correlates with itself where it repeats.
using CorrelationOf = std::function<double(const exemplar::ImageLevel&)>;

/// The keystone, of up to 17 % along an axis, without which the picture correlates most highly;
/// nothing unless it repeats weakly with it and clearly more highly without it. Calls
/// `correlationOf` up to 21 times, for pictures of at most 256 pixels a side. Deterministic. Throws
/// std::bad_alloc. Source: docs/decisions/012-quilting.md.
[[nodiscard]] std::optional<Keystone> keystoneOf(const exemplar::ImageLevel& image,
                                                 const CorrelationOf& correlationOf);

} // namespace lichen::placement
