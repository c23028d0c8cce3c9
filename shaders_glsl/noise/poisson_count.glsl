// SPDX-License-Identifier: MIT
// The number of impacts in a cell of a Poisson process.
#ifndef LICHEN_POISSON_COUNT_GLSL
#define LICHEN_POISSON_COUNT_GLSL

// 0 where every material's point process is stratified. A literal, or the host's specialization
// constant.
#ifndef LICHEN_POISSON_POINTS
#define LICHEN_POISSON_POINTS 1
#endif

/// Impacts in a cell of the Poisson process: the quantile of a Poisson variable of mean 1.
uint lichenPoissonCount(uint hash) {
  // 2^32 times its distribution function at 0, 1, ...; more than 12 have a probability of 6e-11.
  uint count = 0u;
  count += hash >= 1580030169u ? 1u : 0u;
  count += hash >= 3160060337u ? 1u : 0u;
  count += hash >= 3950075422u ? 1u : 0u;
  count += hash >= 4213413783u ? 1u : 0u;
  count += hash >= 4279248374u ? 1u : 0u;
  count += hash >= 4292415292u ? 1u : 0u;
  count += hash >= 4294609778u ? 1u : 0u;
  count += hash >= 4294923276u ? 1u : 0u;
  count += hash >= 4294962463u ? 1u : 0u;
  count += hash >= 4294966817u ? 1u : 0u;
  count += hash >= 4294967253u ? 1u : 0u;
  count += hash >= 4294967292u ? 1u : 0u;
  return count;
}

#endif
