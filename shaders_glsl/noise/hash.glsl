// SPDX-License-Identifier: MIT
// The integer hashes, bit for bit those of bundle/include/lichen/lattice.h. Integers in, integers
// out; uint arithmetic wraps modulo 2^32.
// [JO20] Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg, pcg3d.
#ifndef LICHEN_HASH_GLSL
#define LICHEN_HASH_GLSL

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
#define LICHEN_PCG3D_FACTOR 1664525u
#define LICHEN_PCG3D_TERM 1013904223u

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
  return lichenPcg3dMix(v * LICHEN_PCG3D_FACTOR + LICHEN_PCG3D_TERM);
}

/// The word that stands for a noise's seed and a projection plane (0 for uv).
uint lichenLatticeSeed(uint seed, uint plane) { return lichenPcg(lichenPcg(seed) + plane); }

#endif
