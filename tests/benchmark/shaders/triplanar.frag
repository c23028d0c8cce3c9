#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Triplanar tiling on a sphere, unrolled over the screen so that each part of it has as many pixels
// as any other of the same area. A pixel sees a texel, as in tiling.frag on a flat screen.

// The usual material, as in tiling.frag; all materials triplanar, as there none is.
#include "interface/lichen_interface.h"
#define LICHEN_METHODS 1
#define LICHEN_MAPPINGS 2
#define LICHEN_FEATURES (1u | LICHEN_FEATURE_TRIPLANAR | LICHEN_FEATURE_TABLES)
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  const vec2 kTilesPerScreen = vec2(1920.0, 1080.0) / 256.0;
  const float kPi = 3.14159265;
  const float kTexel = 0.999 / 256.0; // [tiles] a hair less: a pixel of more reads two mips
  // Archimedes: a cylinder around the sphere has its area, strip by strip.
  float radius = sqrt(kTilesPerScreen.x * kTilesPerScreen.y / (4.0 * kPi));
  float longitude = 2.0 * kPi * uv.x / kTilesPerScreen.x;
  float height = 2.0 * uv.y / kTilesPerScreen.y - 1.0;
  float around = sqrt(max(0.0, 1.0 - height * height));
  vec3 east = vec3(-sin(longitude), 0.0, cos(longitude));
  vec3 normal = vec3(around * cos(longitude), height, around * sin(longitude));
  float metres = lichenNoise.tileSizeMetres;
  LichenShadingPoint shading =
      LICHEN_POINT_TRIPLANAR(metres * radius * normal, metres * kTexel * east,
                             metres * kTexel * cross(normal, east), normal);
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
