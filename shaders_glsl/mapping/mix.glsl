// SPDX-License-Identifier: MIT
// The weight of a mix of textons where a host has it: from a mask, from vertex colours, or its own.
// LichenPoint + weight and its derivative, or a mask's values -> LichenPoint. The library
// fetches no mask, since each host binds images in its own way. Constants and directions are in the
// uniform block, and the functions of uv.glsl use them.
#ifndef LICHEN_MIX_GLSL
#define LICHEN_MIX_GLSL

#include "../noise/noise.glsl"

/// Half the size of a texton [tiles].
vec2 lichenImpactReach(LichenNoise noise) {
  return 0.5 * lichenTextonCoefficients(noise) / vec2(noise.tileTexelsX, noise.tileTexelsY);
}

/// Where a mask is fetched beside the point itself: at its texture coordinates plus and minus each
/// column, which lie along x and y of tile space. The columns of `uvGradients` are the screen-space
/// gradients of those coordinates, of `tileGradients` the tile coordinate's.
mat2 lichenMaskReach(mat2 uvGradients, mat2 tileGradients, LichenNoise noise) {
  // As wide as the impacts lie: differences of neighbouring texels would jump at the mask's texels,
  // and what lies between two of them is often as wide as a texton.
  float area = determinant(tileGradients);
  mat2 uvPerTile = area != 0.0 ? uvGradients * inverse(tileGradients) : mat2(0.0);
  vec2 reach = lichenImpactReach(noise);
  return mat2(reach.x * uvPerTile[0], reach.y * uvPerTile[1]);
}

/// From a mask: its value at the point, and for each column of lichenMaskReach the value at plus
/// the column less that at minus the column.
void lichenMixByMask(LICHEN_INOUT(LichenPoint) point, float weight, vec2 differences,
                     LichenNoise noise) {
  lichenSetMix(point, weight, differences / (2.0 * lichenImpactReach(noise)));
}

#endif
