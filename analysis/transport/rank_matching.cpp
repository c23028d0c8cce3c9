// SPDX-License-Identifier: MIT
// Points on a line -> the target of each source.
#include "rank_matching.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>

namespace lichen::transport {
namespace {

std::vector<float> firstCoordinates(const std::vector<Point>& points) {
  std::vector<float> x(points.size());
  std::transform(points.begin(), points.end(), x.begin(), [](const Point& p) { return p.x; });
  return x;
}

/// An integer that sorts by value, then by index. Integers sort faster than pairs.
std::uint64_t sortKey(float value, std::uint32_t index) {
  constexpr std::uint32_t kSign = 1u << 31u;
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f); // -0 is 0
  const std::uint32_t ordered = (bits & kSign) != 0 ? ~bits : bits | kSign;
  return (std::uint64_t(ordered) << 32u) | index;
}

std::vector<std::uint32_t> indicesOf(const std::vector<std::uint64_t>& keys) {
  std::vector<std::uint32_t> indices(keys.size());
  std::transform(keys.begin(), keys.end(), indices.begin(),
                 [](std::uint64_t key) { return std::uint32_t(key); });
  return indices;
}

/// Indices by ascending value; the index breaks ties. O(N log N).
std::vector<std::uint32_t> ascendingOrder(std::span<const float> values) {
  std::vector<std::uint64_t> keys(values.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    keys[i] = sortKey(values[i], std::uint32_t(i));
  tbb::parallel_sort(keys.begin(), keys.end());
  return indicesOf(keys);
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

// Values and scores, one of each per pixel -> pixels in order.

TieOrder::TieOrder(std::span<const float> values) : order_(ascendingOrder(values)) {
  for (std::size_t rank = 0; rank < order_.size(); ++rank)
    if (rank == 0 || values[order_[rank]] != values[order_[rank - 1]])
      ties_.push_back(std::uint32_t(rank));
  ties_.push_back(std::uint32_t(order_.size()));
}

std::vector<std::uint32_t> TieOrder::by(std::span<const float> scores) const {
  std::vector<std::uint64_t> keys(order_.size());
  tbb::parallel_for(std::size_t(1), ties_.size(), [&](std::size_t k) {
    const auto begin = std::ptrdiff_t(ties_[k - 1]), end = std::ptrdiff_t(ties_[k]);
    for (std::ptrdiff_t i = begin; i < end; ++i) {
      const std::uint32_t pixel = order_[std::size_t(i)];
      keys[std::size_t(i)] = sortKey(scores[pixel], pixel);
    }
    if (end - begin > 1)
      tbb::parallel_sort(keys.begin() + begin, keys.begin() + end);
  });
  return indicesOf(keys);
}

} // namespace lichen::transport
