// SPDX-License-Identifier: MIT
// How the exemplar lies against the coordinates that a material maps: rotated and scaled.

/// The linear part of the mapping from texture to tile coordinates.
vec2 lichenUvToTile(vec2 uv, LichenMaterial material) {
  return vec2(material.uvToTileXX * uv.x + material.uvToTileXY * uv.y,
              material.uvToTileYX * uv.x + material.uvToTileYY * uv.y);
}

/// Slopes as the map holds them (in the exemplar's frame) -> in the frame of the texture
/// coordinates, whose tangent space the mesh supplies. Y points up, against v.
vec2 lichenSlopesToUv(vec2 slopes, LichenMaterial material) {
  vec2 direction = normalize(vec2(material.uvToTileXX, material.uvToTileXY)); // (cos, sin)
  return vec2(direction.x * slopes.x + direction.y * slopes.y,
              direction.x * slopes.y - direction.y * slopes.x);
}
