// SPDX-License-Identifier: MIT
// Improves a matching inside small blocks of neighbouring pairs.
#pragma once

#include "precondition.h"

#include <cstdint>
#include <span>

namespace lichen::transport {

/// Cuts the pairs into regions of some thousand neighbours: a k-d tree over the pairs' midpoints in
/// a random rotation, drawn from `seed`. Cuts each region several times into blocks of 64 and
/// exchanges targets inside a block while any exchange of two lowers the cost. Regions are
/// disjoint, so they run in parallel and the result does not depend on the number of threads.
void swapInsideRegions(const PointPair& points, std::span<std::uint32_t> assignment,
                       std::uint64_t seed);

/// Cuts the pairs into blocks of at most 48 neighbours and solves the assignment problem of each
/// block exactly.
void solveInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment,
                       std::uint64_t seed);

} // namespace lichen::transport
