// SPDX-License-Identifier: MIT
// Point sets that the transport tests share. The same points on every run and machine.
#pragma once

#include <cstddef>
#include <string>
#include <transport/assignment.h>
#include <vector>

namespace lichen::test {

using Points = std::vector<Point>;

/// Independent Gaussian coordinates of mean 1/2 and deviation 1/6.
[[nodiscard]] Points gaussianCloud(std::size_t count, unsigned seed);
/// Five tight clusters of unlike population.
[[nodiscard]] Points clusters(std::size_t count, unsigned seed);
/// Colours rounded to 8 bits of which many are equal: two narrow modes.
[[nodiscard]] Points quantizedColors(std::size_t count, unsigned seed);
/// In a plane that no axis is normal to.
[[nodiscard]] Points coplanar(std::size_t count, unsigned seed);
/// On a line that no axis is parallel to.
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
