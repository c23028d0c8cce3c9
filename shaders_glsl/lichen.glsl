// SPDX-License-Identifier: MIT
// The one file that a host includes (with `shaders_glsl/` on its include path and
// GL_GOOGLE_include_directive enabled). Everything is prefixed lichen, Lichen or LICHEN_.
//
// Samplers as arguments: include this file and call the functions. docs/integration.md has both.
// Descriptors declared here: define, before the include,
//   LICHEN_SET            the descriptor set that the plugin fills
//   LICHEN_FIRST_BINDING  its first binding (0)
//   LICHEN_MAP_COUNT      maps of the noise, 1 to LICHEN_MAX_MAPS
// which gives lichenUniforms.noise, lichenUniforms.maps[k], lichenGaussian0, lichenTable0, ... and
// LICHEN_TILING(k, taps), the value of map k.
//
// A host that knows more at compile time may define LICHEN_PERIODIC_LATTICE, LICHEN_BLEND_SHARPNESS,
// LICHEN_JOINT_TABLES, LICHEN_SEPARABLE_TABLES and LICHEN_GAUSSIAN_ONLY as 0 (noise/): less code to
// run.
#ifndef LICHEN_GLSL
#define LICHEN_GLSL

#include "interface/lichen_interface.h"
#include "mapping/uv.glsl"
#include "noise/tiling.glsl"

#ifdef LICHEN_SET
#ifndef LICHEN_MAP_COUNT
#error lichen.glsl with LICHEN_SET needs LICHEN_MAP_COUNT, the number of maps of the noise, 1 to 6
#elif LICHEN_MAP_COUNT < 1 || LICHEN_MAP_COUNT > LICHEN_MAX_MAPS
#error LICHEN_MAP_COUNT is the number of maps of the noise, 1 to 6
#endif
#ifndef LICHEN_FIRST_BINDING
#define LICHEN_FIRST_BINDING 0
#endif

layout(std140, set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_NOISE)
    uniform LichenUniformBlock {
  LichenNoise noise;
  LichenMap maps[LICHEN_MAX_MAPS];
} lichenUniforms;

#define LICHEN_DECLARE_MAP(map)                                                                    \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_GAUSSIAN(map))          \
      uniform sampler2D lichenGaussian##map;                                                       \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_TABLE(map))             \
      uniform sampler3D lichenTable##map

LICHEN_DECLARE_MAP(0);
#if LICHEN_MAP_COUNT > 1
LICHEN_DECLARE_MAP(1);
#endif
#if LICHEN_MAP_COUNT > 2
LICHEN_DECLARE_MAP(2);
#endif
#if LICHEN_MAP_COUNT > 3
LICHEN_DECLARE_MAP(3);
#endif
#if LICHEN_MAP_COUNT > 4
LICHEN_DECLARE_MAP(4);
#endif
#if LICHEN_MAP_COUNT > 5
LICHEN_DECLARE_MAP(5);
#endif

#define LICHEN_TILING(map, taps)                                                                   \
  lichenTiling(lichenGaussian##map, lichenTable##map, taps, lichenUniforms.noise,                  \
               lichenUniforms.maps[map])
#endif

#endif
