// SPDX-License-Identifier: MIT
// A hash -> a Poisson number.
#include "poisson_count.h"

#include <algorithm>
#include <array>

namespace lichen {

int poissonCount(std::uint32_t hash) {
  // 2^32 times the distribution function at 0, 1, ...; counts above 12 have a probability of 6e-11.
  constexpr std::array<std::uint32_t, 12> kDistribution{
      1580030169u, 3160060337u, 3950075422u, 4213413783u, 4279248374u, 4292415292u,
      4294609778u, 4294923276u, 4294962463u, 4294966817u, 4294967253u, 4294967292u};
  return int(std::upper_bound(kDistribution.begin(), kDistribution.end(), hash) -
             kDistribution.begin());
}

} // namespace lichen
