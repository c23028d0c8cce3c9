// SPDX-License-Identifier: MIT
// The integer hashes, bit for bit as in bundle/include/lichen/lattice.h. Integers in, integers
// out; uint arithmetic wraps modulo 2^32.
// [JO20] Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg, pcg3d.

/// Vertex (i, j) of the lattice, modulo 2^32 -> two random halves of 16 bits.
uint lichenVertexHash(uint i, uint j, uint seedWord) {
  // i is mixed before j is added: of a sum of products i A + j B vertices repeat in rows. The seed
  // comes in between, so that no two seeds give one field shifted by less than 2^31 rows.
  // Then the finalizer of MurmurHash3 [A16] with other shifts.
  uint h = i * 0x9E3779B1u;
  h = ((h ^ (h >> 15u)) + j) ^ seedWord;
  h *= 0x85EBCA6Bu;
  h = (h ^ (h >> 15u)) * 0xC2B2AE35u;
  return h ^ (h >> 16u);
}

/// PCG output function over one LCG step.
uint lichenPcg(uint value) {
  // [JO20] listing "pcg".
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// The first step of pcg3d, a linear congruential generator for each word.
const uint kLichenPcg3dFactor = 1664525u, kLichenPcg3dTerm = 1013904223u;

/// The other steps of pcg3d.
uvec3 lichenPcg3dMix(uvec3 v) {
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

/// Three words hashed to three.
uvec3 lichenPcg3d(uvec3 v) {
  // [JO20] listing "pcg3d".
  return lichenPcg3dMix(v * kLichenPcg3dFactor + kLichenPcg3dTerm);
}

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

/// The word that stands for a noise's seed and a projection plane (0 for uv).
uint lichenLatticeSeed(uint seed, uint plane) { return lichenPcg(lichenPcg(seed) + plane); }
