// SPDX-License-Identifier: MIT
// What a SPIR-V module computes, counted without running it.
#pragma once

#include <cstdint>
#include <span>

namespace lichen::bench {

struct SpirvStatistics {
  /// Scalar operations: an addition of three components counts three, a dot product or a product
  /// with a matrix one per multiply-add. Counts arithmetic, conversions, comparisons, selections,
  /// logic, bits, derivatives, queries of a level of detail, and the extended instructions, such as
  /// a sine, per component of the result. Does not count what only moves or names values: loads,
  /// stores, access chains, phis, branches, bit casts, and the making and taking apart of vectors.
  int valueOperations = 0;
  int fetches = 0; ///< samples, gathers and texel fetches
};

/// Counts the instructions of all functions, each once: those of a loop do not count per iteration,
/// and both sides of a branch count. Returns zeros for what is not SPIR-V.
[[nodiscard]] SpirvStatistics spirvStatistics(std::span<const std::uint32_t> module);

} // namespace lichen::bench
