// SPDX-License-Identifier: MIT
// The one file that a host includes (with `shaders_glsl/` on its include path and
// GL_GOOGLE_include_directive enabled). Everything is prefixed lichen, Lichen or LICHEN_.
//
// Samplers as arguments: include this file and call the functions. docs/integration.md has both.
// Descriptors declared here: define, before the include,
//   LICHEN_SET            the descriptor set that the plugin fills
//   LICHEN_FIRST_BINDING  its first binding (0)
//   LICHEN_MAP_COUNT      maps of the noise, 1 to LICHEN_MAX_MAPS
// which gives lichenUniforms.noise, .maps[k] and .texton, lichenImage0, lichenTable0, ...,
// LICHEN_PLACE(uv, gradientX, gradientY), where the noise is evaluated, or of other mappings
// LICHEN_PLACE_TRIPLANAR(position, gradientX, gradientY, normal) and
// LICHEN_PLACE_SURFACE(position, gradientX, gradientY, normal, tangent), and
// LICHEN_NOISE(k, place), the value of map k there, whatever the noise's method.
//
// A host that knows more at compile time leaves out what it does not need: less code to run. The
// switches are in README.md.
#ifndef LICHEN_GLSL
#define LICHEN_GLSL

#include "interface/lichen_interface.h"
#include "mapping/mix.glsl"
#include "mapping/surface.glsl"
#include "mapping/triplanar.glsl"
#include "mapping/uv.glsl"
#include "noise/method.glsl"

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
  LichenTexton texton;
} lichenUniforms;

#define LICHEN_DECLARE_MAP(map)                                                                    \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_IMAGE(map))          \
      uniform sampler2D lichenImage##map;                                                          \
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

#define LICHEN_PLACE(uv, gradientX, gradientY)                                                     \
  lichenPlaceUvGrad(uv, gradientX, gradientY, lichenUniforms.noise, lichenUniforms.texton)

#define LICHEN_PLACE_SURFACE(position, gradientX, gradientY, normal, tangent)                      \
  lichenPlaceSurfaceGrad(position, gradientX, gradientY, normal, tangent, lichenUniforms.noise,    \
                         lichenUniforms.texton)

#define LICHEN_PLACE_TRIPLANAR(position, gradientX, gradientY, normal)                             \
  lichenPlaceTriplanarGrad(position, gradientX, gradientY, normal, lichenUniforms.noise,           \
                           lichenUniforms.texton)

#define LICHEN_NOISE(map, place)                                                                   \
  lichenValue(lichenImage##map, lichenTable##map, place, lichenUniforms.noise,                     \
              lichenUniforms.maps[map], lichenUniforms.texton)
#endif

#endif
