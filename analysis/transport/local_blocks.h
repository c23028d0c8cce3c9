// SPDX-License-Identifier: MIT
// Improves a matching inside small blocks of neighbouring pairs.
#pragma once

#include "precondition.h"

#include <cstdint>
#include <span>

namespace lichen::transport {

/// Cuts the pairs into blocks of at most `blockSize` neighbours (a k-d tree over the pairs' middles
/// in a random rotation, drawn from `seed`), and exchanges targets inside each block while any
/// exchange of two lowers the cost. Blocks are disjoint, so they run in parallel with one result.
void swapInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment, int blockSize,
                      std::uint64_t seed);

/// As above with the exact solution of each block's assignment problem.
void solveInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment, int blockSize,
                       std::uint64_t seed);

} // namespace lichen::transport
