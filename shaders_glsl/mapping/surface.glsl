// SPDX-License-Identifier: MIT
// A noise on a surface without texture coordinates: a point in space, its screen-space derivatives,
// the normal and the tangent there -> LichenShadingPoint. Slopes lie in
// the exemplar's directions, as on texture coordinates: lichenSlopesToUv rotates them.
// [GLM17] Galerne, Leclaire and Moisan 2017, section 6: a frame that turns little along the
// surface.

/// The columns point to the right, down and outward in the exemplar as it lies on the surface:
/// orthonormal, whatever interpolation has made of the vertices' directions. `tangent` is glTF's,
/// its w the side on which the bitangent lies.
mat3 lichenSurfaceFrame(vec3 normal, vec4 tangent) {
  vec3 outward = normalize(normal);
  vec3 right = tangent.xyz - dot(tangent.xyz, outward) * outward;
  // Between directions that cancel, as around a singularity, any will do.
  const float kLeastLength2 = 1e-12;
  if (dot(right, right) < kLeastLength2)
    right =
        abs(outward.z) < 0.5 ? vec3(-outward.y, outward.x, 0.0) : vec3(0.0, -outward.z, outward.y);
  right = normalize(right);
  float handedness = tangent.w < 0.0 ? -1.0 : 1.0;
  return mat3(right, -handedness * cross(outward, right), outward);
}

/// The shading point at `position` [metres, relative to the host's integer tile origin], with the
/// position's derivatives along the screen: usable in compute and in non-uniform control flow.
LichenShadingPoint lichenPointSurfaceGrad(vec3 position, vec3 positionGradientX,
                                          vec3 positionGradientY, vec3 normal, vec4 tangent,
                                          LichenMaterial material, LichenNoise noise) {
  LichenShadingPoint shading;
  shading.material = material;
  shading.noise = noise;
#if LICHEN_HAS_SURFACES
  // As on texture coordinates, the exemplar is rotated against the surface, and scaled.
  vec2 rotation = vec2(material.uvToTileXX, material.uvToTileXY); // (cos, sin) / scale
  float perScale = length(rotation);
  rotation /= perScale;
  mat3 frame = lichenSurfaceFrame(normal, tangent);
  vec3 right = rotation.x * frame[0] + rotation.y * frame[1];
  vec3 down = rotation.x * frame[1] - rotation.y * frame[0];
  float tilesPerMetre = perScale / noise.tileSizeMetres;
  // Texels are square: a tile is as many high as wide, in tiles of its own height.
  vec2 tiles = tilesPerMetre * vec2(1.0, noise.tileAspect);
  mat3x2 toTiles = mat3x2(tiles * vec2(right.x, down.x), tiles * vec2(right.y, down.y),
                          tiles * vec2(right.z, down.z));
  shading.point = lichenPointAt(vec2(0.0), toTiles * positionGradientX, toTiles * positionGradientY,
                                material, noise);
  lichenSetMix(shading.point, lichenMixWeight(vec2(0.0), material), vec2(0.0));
  lichenSetOnSurface(shading.point, tilesPerMetre * position, mat3(right, down, frame[2]), material,
                     noise);
#endif
  return shading;
}
