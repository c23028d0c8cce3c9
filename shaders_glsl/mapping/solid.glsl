// SPDX-License-Identifier: MIT
// A noise in a solid: a point in space and its screen-space derivatives -> LichenShadingPoint.
// Needs neither texture coordinates nor normals. The exemplar lies as on the triplanar plane that
// looks along z. Slopes come out as a gradient in space, as in triplanar.glsl.

/// The shading point at `position` [metres, relative to the host's integer tile origin], with the
/// position's derivatives along the screen: usable in compute and in non-uniform control flow.
LichenShadingPoint lichenPointSolidGrad(vec3 position, vec3 positionGradientX,
                                        vec3 positionGradientY, LichenMaterial material,
                                        LichenNoise noise) {
  LichenShadingPoint shading;
  shading.material = material;
  shading.noise = noise;
#if LICHEN_HAS_SOLIDS
  float perTile = 1.0 / noise.tileSizeMetres;
  float perScale = length(vec2(material.uvToTileXX, material.uvToTileXY));
  vec3 offset = vec3(material.offsetX, material.offsetY, 0.0); // methods add their own along z
  // Texels are square in space.
  vec3 scale = perTile * vec3(1.0, noise.tileAspect, perScale);
  vec2 right = vec2(material.uvToTileXX, -material.uvToTileXY); // of x and y, as y points up
  vec2 down = vec2(material.uvToTileYX, -material.uvToTileYY);
  vec3 tile = vec3(dot(right, position.xy), dot(down, position.xy), position.z);
  vec3 tileX =
      vec3(dot(right, positionGradientX.xy), dot(down, positionGradientX.xy), positionGradientX.z);
  vec3 tileY =
      vec3(dot(right, positionGradientY.xy), dot(down, positionGradientY.xy), positionGradientY.z);
  shading.point =
      lichenPointInSolid(offset + scale * tile, scale * tileX, scale * tileY, material, noise);
#endif
  return shading;
}
