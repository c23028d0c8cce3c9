// SPDX-License-Identifier: MIT
// Point sets that the transport tests share. The points are the same on every run and machine.
#pragma once

#include <cstddef>
#include <string>
#include <transport/assignment.h>
#include <vector>

namespace lichen::test {

using Points = std::vector<Point>;

/// Independent Gaussian coordinates with mean 1/2 and standard deviation 1/6.
[[nodiscard]] Points gaussianCloud(std::size_t count, unsigned seed);
/// Five tight clusters of different sizes.
[[nodiscard]] Points clusters(std::size_t count, unsigned seed);
/// Two narrow modes of colours rounded to 8 bits; many points are equal.
[[nodiscard]] Points quantizedColors(std::size_t count, unsigned seed);
/// In a plane that is normal to no axis.
[[nodiscard]] Points coplanar(std::size_t count, unsigned seed);
/// On a line that is parallel to no axis.
[[nodiscard]] Points collinear(std::size_t count, unsigned seed);
/// One point, repeated.
[[nodiscard]] Points identical(std::size_t count);

struct NamedSet {
  std::string name;
  Points points;
};

/// One of each of the above.
[[nodiscard]] std::vector<NamedSet> everyKindOfSet(std::size_t count, unsigned seed);

} // namespace lichen::test
