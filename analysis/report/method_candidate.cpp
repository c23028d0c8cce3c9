// SPDX-License-Identifier: MIT
// Costs and distances -> the method that is worth its cost.
#include <lichen/method_candidate.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace lichen {

std::size_t nearestForItsCost(std::span<const MethodCandidate> candidates) {
  constexpr double kLeastGain = 0.1, kChance = 0.002;
  std::vector<std::size_t> byCost(candidates.size());
  std::iota(byCost.begin(), byCost.end(), std::size_t(0));
  std::stable_sort(byCost.begin(), byCost.end(), [&](std::size_t a, std::size_t b) {
    return candidates[a].plainFetches < candidates[b].plainFetches;
  });
  std::size_t best = byCost.front();
  for (const std::size_t dearer : byCost)
    if (candidates[dearer].distance < (1.0 - kLeastGain) * candidates[best].distance - kChance)
      best = dearer;
  return best;
}

} // namespace lichen
