// SPDX-License-Identifier: MIT
// Points on a line -> the target of each source.
#include "rank_matching.h"

#include "tie_order.h"

#include <algorithm>

namespace lichen::transport {
namespace {

std::vector<float> firstCoordinates(const std::vector<Point>& points) {
  std::vector<float> x(points.size());
  std::transform(points.begin(), points.end(), x.begin(), [](const Point& p) { return p.x; });
  return x;
}

} // namespace

std::vector<Point> matchedByRank(const std::vector<Point>& sources,
                                 const std::vector<Point>& targets) {
  return matchedInOrder(ascendingOrder(firstCoordinates(sources)), targets);
}

std::vector<Point> matchedInOrder(const std::vector<std::uint32_t>& order,
                                  const std::vector<Point>& targets) {
  const std::vector<std::uint32_t> to = ascendingOrder(firstCoordinates(targets));
  std::vector<Point> matched(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    matched[order[rank]] = targets[to[rank]];
  return matched;
}

} // namespace lichen::transport
