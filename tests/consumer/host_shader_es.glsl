#version 300 es
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A host's fragment shader in GLSL ES 3.00, as WebGL 2 has it, with every mapping. OWN_CELLS: also
// with quilting.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
#include "interface/lichen_interface.h"
layout(std140) uniform Noise { LichenNoiseConstants noise; };
#ifdef OWN_CELLS
uniform sampler2D cells;
#define LICHEN_SAMPLE_CELLS(uv, level) textureLod(cells, uv, level)
#define LICHEN_TILE_OFFSET(index) noise.offsets[(index) >> 2u][(index) & 3u]
#endif
#include "lichen.glsl"

layout(std140) uniform Material { LichenTriplanarMaterial material; };
uniform sampler2D image;
uniform sampler3D table;
uniform int mapping;

in vec2 uv;
in vec3 position, normal;
in vec4 tangent;
out vec4 color;

void main() {
  vec2 uvX = dFdx(uv), uvY = dFdy(uv);
  vec3 positionX = dFdx(position), positionY = dFdy(position);
  LichenMap map = noise.maps[LICHEN_BASE_COLOR];
  LichenShadingPoint shading;
  if (mapping == 0)
    shading = lichenPointUvGrad(uv, uvX, uvY, material.material, noise.noise);
  else if (mapping == 1)
    shading =
        lichenPointTriplanarGrad(position, positionX, positionY, normal, material, noise.noise);
  else if (mapping == 2)
    shading = lichenPointSurfaceGrad(position, positionX, positionY, normal, tangent,
                                     material.material, noise.noise);
  else
    shading =
        lichenPointSolidGrad(position, positionX, positionY, material.material, noise.noise);
  color = lichenValue(image, table, shading, map);
  color.xyz +=
      lichenGradientUvGrad(image, table, uv, uvX, uvY, material.material, noise.noise, map);
}
