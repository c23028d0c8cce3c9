// SPDX-License-Identifier: MIT
// The weight of a mix of textons where a host has it: from a mask, from vertex colours, or its own.
// LichenImpacts + weight (and mask, screen-space gradients) -> LichenImpacts. Constants and
// directions are in the uniform block, and the functions of uv.glsl use them.
#ifndef LICHEN_MIX_GLSL
#define LICHEN_MIX_GLSL

#include "../noise/texton_mix.glsl"

/// `weight` 0 is the first step, 1 the last. `gradient` is its derivative along x and y of tile
/// space [1 / tile], which tells the weight at impacts around; it must not jump from point to point
/// where the weight does not. 0 where it may, as of vertex colours, which bend at every edge: all
/// impacts then have the point's own weight, and steps are near enough for that.
void lichenSetMix(inout LichenImpacts impacts, float weight, vec2 gradient) {
  impacts.mixWeight = weight;
  impacts.mixGradient = gradient;
}

/// From a channel (a unit vector) of a mask at `uv`, whose screen-space gradients are the columns
/// of `uvGradients`; those of `tileGradients` are the tile coordinate's.
void lichenMixByMask(inout LichenImpacts impacts, sampler2D mask, vec4 channel, vec2 uv,
                     mat2 uvGradients, mat2 tileGradients, LichenNoise noise) {
  // Differences as wide as the impacts lie: those of neighbouring texels would jump at the mask's
  // texels, and what lies between two of them is often as wide as a texton.
  vec2 reach = 0.5 * vec2(ivec2(noise.texton.coefficientsX, noise.texton.coefficientsY)) /
               vec2(noise.tileTexelsX, noise.tileTexelsY);
  float area = determinant(tileGradients);
  mat2 uvPerTile = area != 0.0 ? uvGradients * inverse(tileGradients) : mat2(0.0);
  vec2 alongX = reach.x * uvPerTile[0];
  vec2 alongY = reach.y * uvPerTile[1];
  vec2 dx = uvGradients[0];
  vec2 dy = uvGradients[1];
  vec2 rise = vec2(
      dot(channel, textureGrad(mask, uv + alongX, dx, dy) - textureGrad(mask, uv - alongX, dx, dy)),
      dot(channel,
          textureGrad(mask, uv + alongY, dx, dy) - textureGrad(mask, uv - alongY, dx, dy)));
  lichenSetMix(impacts, dot(channel, textureGrad(mask, uv, dx, dy)), rise / (2.0 * reach));
}

#endif
