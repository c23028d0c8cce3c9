// SPDX-License-Identifier: MIT
// The integer hash of the lattice, bit for bit that of bundle/include/lichen/lattice.h.
// Integers in, integers out; uint arithmetic wraps modulo 2^32.
// [JO20] Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg, pcg3d.
#ifndef LICHEN_HASH_GLSL
#define LICHEN_HASH_GLSL

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

/// Which of `counts` offsets on each axis vertex (i, j)'s tile has, [0, counts).
uvec2 lichenTileOffsetIndex(int i, int j, uint seedWord, uvec2 counts) {
  // Conversion of int to uint keeps the bits, negative values included.
  uvec3 hash = lichenPcg3d(uvec3(uint(i), uint(j), seedWord));
  return ((hash.xy >> 16u) * counts) >> 16u;
}

/// Which of `steps` steps of a turn vertex (i, j)'s tile has, [0, steps), steps up to 2^16.
uint lichenTileRotationStep(int i, int j, uint seedWord, uint steps) {
  // The word that the offset leaves over.
  uvec3 hash = lichenPcg3d(uvec3(uint(i), uint(j), seedWord));
  return ((hash.z >> 16u) * steps) >> 16u;
}

#endif
