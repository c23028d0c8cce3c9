// SPDX-License-Identifier: MIT
// Latitude-longitude panoramas; sky.h has the same function.
#ifndef PANORAMA_GLSL
#define PANORAMA_GLSL

/// Where a unit direction is in a panorama: +y at its top, -z in its middle.
vec2 panoramaCoordinate(vec3 direction) {
  const float kPi = 3.14159265358979;
  return vec2(0.5 + atan(direction.x, -direction.z) / (2.0 * kPi),
              acos(clamp(direction.y, -1.0, 1.0)) / kPi);
}

#endif
