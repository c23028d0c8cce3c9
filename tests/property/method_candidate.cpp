// SPDX-License-Identifier: MIT
// The rule by which --method auto chooses, at its borders.
#include <lichen/method_candidate.h>

#include <catch2/catch.hpp>

using namespace lichen;

TEST_CASE("a dearer method must be nearer by a tenth and by chance on top") {
  const auto chosen = [](double dearer) {
    const MethodCandidate candidates[] = {{Method::texton, 38.0, dearer},
                                          {Method::tiling, 4.0, 0.100}};
    return candidates[nearestForItsCost(candidates)].method;
  };
  CHECK(chosen(0.0879) == Method::texton);
  CHECK(chosen(0.0881) == Method::tiling);
  // The dearest must beat the one that beat the cheapest; of equals the first is taken.
  const MethodCandidate several[] = {{Method::localRandomPhase, 80.0, 0.050},
                                     {Method::tiling, 4.0, 0.100},
                                     {Method::texton, 38.0, 0.052},
                                     {Method::multipleKernels, 38.0, 0.052}};
  CHECK(nearestForItsCost(several) == 2);
}
