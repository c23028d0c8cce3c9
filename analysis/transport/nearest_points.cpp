// SPDX-License-Identifier: MIT
// Nearest neighbours: N points in a spatial order -> a few indices for a query.
#include "nearest_points.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace lichen::transport {
namespace {

/// Points per leaf: as many as can be compared in the time of a few steps down the tree.
constexpr std::size_t kLeafSize = 8;

/// The most nodes that wait at once: one per tree level.
constexpr std::size_t kDepth = 64;

/// Far outside any set of points; its square fits a float.
constexpr float kFarAway = 1e18f;

} // namespace

NearestPoints::NearestPoints(const PointArrays& points)
    : points_(points), leafCount_(std::bit_ceil((points.size() + kLeafSize - 1) / kLeafSize)),
      boxes_(2 * leafCount_, {{kFarAway, kFarAway, kFarAway}, {-kFarAway, -kFarAway, -kFarAway}}) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    Box& box = boxes_[leafCount_ + i / kLeafSize];
    const std::array<float, 3> p{points.x[i], points.y[i], points.z[i]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  }
  for (std::size_t node = leafCount_; node-- > 1;)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes_[node].low[axis] = std::min(boxes_[2 * node].low[axis], boxes_[2 * node + 1].low[axis]);
      boxes_[node].high[axis] =
          std::max(boxes_[2 * node].high[axis], boxes_[2 * node + 1].high[axis]);
    }
}

float NearestPoints::squaredDistance(std::size_t node, const Point& at) const {
  const Box& box = boxes_[node];
  const std::array<float, 3> p{at.x, at.y, at.z};
  float sum = 0.0f;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float outside = std::max({box.low[axis] - p[axis], p[axis] - box.high[axis], 0.0f});
    sum += outside * outside;
  }
  return sum;
}

std::size_t NearestPoints::find(const Point& at, std::span<std::uint32_t> nearest) const {
  using Candidate = std::pair<float, std::uint32_t>;
  const std::size_t wanted = std::min({nearest.size(), kMostWanted, points_.size()});
  std::array<Candidate, kMostWanted> best;
  best.fill({std::numeric_limits<float>::infinity(), 0});
  const auto offer = [&](float distance, std::uint32_t index) {
    if (!(distance < best[wanted - 1].first))
      return;
    std::size_t rank = wanted - 1;
    for (; rank > 0 && distance < best[rank - 1].first; --rank)
      best[rank] = best[rank - 1];
    best[rank] = {distance, index};
  };
  std::array<Candidate, kDepth> waiting;
  std::size_t count = 0;
  waiting[count++] = {0.0f, 1};
  while (wanted > 0 && count > 0) {
    const auto [distance, node] = waiting[--count];
    if (!(distance < best[wanted - 1].first))
      continue;
    if (node < leafCount_) {
      const Candidate left{squaredDistance(2 * node, at), 2 * node};
      const Candidate right{squaredDistance(2 * node + 1, at), 2 * node + 1};
      const bool leftFirst = left.first <= right.first;
      waiting[count++] = leftFirst ? right : left;
      waiting[count++] = leftFirst ? left : right;
      continue;
    }
    const std::size_t begin = (node - leafCount_) * kLeafSize;
    for (std::size_t i = begin; i < std::min(points_.size(), begin + kLeafSize); ++i) {
      const Point d{at.x - points_.x[i], at.y - points_.y[i], at.z - points_.z[i]};
      offer(dot(d, d), std::uint32_t(i));
    }
  }
  for (std::size_t k = 0; k < wanted; ++k)
    nearest[k] = best[k].second;
  return wanted;
}

} // namespace lichen::transport
