// SPDX-License-Identifier: MIT
// What a pixel of one map costs, in the unit of `lichen bake --budget`: trilinear fetches of a
// plain texture, on a CPU. docs/benchmarks.md measures it.
#pragma once

namespace lichen {

inline constexpr double kTilingFetches = 4.1, kQuiltingFetches = 5.3;
/// `impacts`: the mean number of them at a point.
[[nodiscard]] constexpr double textonFetches(double impacts) { return 1.37 * impacts; }
[[nodiscard]] constexpr double cosineFetches(int cosines, bool hasStructure) {
  return 1.04 * cosines + (hasStructure ? 27.6 : 0.0);
}
/// `cosines`: of a pattern, each at most as dear as one of cosineFetches().
[[nodiscard]] constexpr double kernelFetches(double impacts, int cosines) {
  return 1.72 * impacts + 1.04 * cosines;
}

} // namespace lichen
