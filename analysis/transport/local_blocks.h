// SPDX-License-Identifier: MIT
// Improves a matching inside small blocks of neighbouring pairs.
#pragma once

#include "precondition.h"

#include <cstdint>
#include <span>

namespace lichen::transport {

/// Cuts the pairs into regions of some thousand neighbours (a k-d tree over the pairs' middles in a
/// random rotation, drawn from `seed`), and those several times into blocks of 64, inside which
/// targets are exchanged while any exchange of two lowers the cost. Regions are disjoint, so they
/// run in parallel with one result.
void swapInsideRegions(const PointPair& points, std::span<std::uint32_t> assignment,
                       std::uint64_t seed);

/// Cuts the pairs into blocks of at most `blockSize` neighbours, and solves each block's assignment
/// problem exactly.
void solveInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment, int blockSize,
                       std::uint64_t seed);

} // namespace lichen::transport
