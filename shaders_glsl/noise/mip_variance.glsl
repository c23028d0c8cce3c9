// SPDX-License-Identifier: MIT
// The amplitude that each mip of a map's image retains.
#ifndef LICHEN_MIP_VARIANCE_GLSL
#define LICHEN_MIP_VARIANCE_GLSL

#include "../interface/lichen_interface.h"

/// The amplitude of a mip's texels, as a share of the Gaussian value's. `bytes` are those of a
/// channel: LichenMap::mipRetained0, mipRetained1 or mipRetained2.
float lichenMipRetained(int mip, uvec4 bytes) {
  // Chosen, not indexed: a copied array that is indexed lives in memory on most devices.
  int byte = min(mip, LICHEN_MAX_MIPS - 1);
  uint word = byte < 8 ? (byte < 4 ? bytes.x : bytes.y) : (byte < 12 ? bytes.z : bytes.w);
  return float(int((word >> (8u * uint(byte & 3))) & 255u)) * (1.0 / 255.0);
}

#endif
