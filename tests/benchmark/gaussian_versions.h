// SPDX-License-Identifier: MIT
// What noises of random phases are compared with: Gaussian versions of an exemplar, its Gaussian
// values with random phases, decoded by the inverse table.
#pragma once

#include "exemplars.h"
#include "synthesized.h"

#include <cstdint>
#include <report/random_phases.h>
#include <vector>

namespace lichen::bench {

inline constexpr std::uint32_t kReferences = 4;

/// Gaussian versions of an exemplar.
inline std::vector<SrgbImage> gaussianVersions(const SrgbImage& exemplar) {
  std::vector<SrgbImage> versions;
  for (std::uint32_t seed = 1; seed <= kReferences; ++seed)
    versions.push_back(toSrgb(require(randomPhaseVersion(baseColorMap(exemplar), seed))));
  return versions;
}

} // namespace lichen::bench
