// SPDX-License-Identifier: MIT
// evaluate.glsl for the mapping uv and the method that LICHEN_METHODS names.
#define LICHEN_MAPPINGS 1
#define LICHEN_SET 0
#include "../lichen.glsl"

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
  vec4 mixWeight; // weight, its derivatives per tile; w is 0 where the material says them
};

LichenShadingPoint pointOf(Point point) {
  LichenShadingPoint shading =
      LICHEN_POINT(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy);
  if (point.mixWeight.w != 0.0)
    lichenSetMix(shading.point, point.mixWeight.x, point.mixWeight.yz);
  return shading;
}

vec4 gradientOf(texture2D image, texture3D table, Point point, LichenMap map) {
  vec2 uv = point.uvAndGradientX.xy;
  bool hasOwn = point.mixWeight.w != 0.0;
  return vec4(
      lichenGradientAt(image, table,
                       vec2(lichenMaterial.offsetX, lichenMaterial.offsetY) +
                           lichenUvToTile(uv, lichenMaterial),
                       lichenUvToTile(point.uvAndGradientX.zw, lichenMaterial),
                       lichenUvToTile(point.gradientY.xy, lichenMaterial),
                       hasOwn ? point.mixWeight.x : lichenMixWeight(uv, lichenMaterial),
                       hasOwn ? point.mixWeight.yz : lichenMixGradient(lichenMaterial),
                       lichenMaterial, lichenNoise, map),
      0.0);
}

#include "evaluate.glsl"
