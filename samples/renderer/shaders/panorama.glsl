// SPDX-License-Identifier: MIT
// Latitude-longitude panoramas; same function as in sky.h.
#ifndef PANORAMA_GLSL
#define PANORAMA_GLSL

/// Texture coordinate of a unit direction in a panorama with +y at its top and -z in its middle.
vec2 panoramaCoordinate(vec3 direction) {
  const float kPi = 3.14159265358979;
  return vec2(0.5 + atan(direction.x, -direction.z) / (2.0 * kPi),
              acos(clamp(direction.y, -1.0, 1.0)) / kPi);
}

#endif
