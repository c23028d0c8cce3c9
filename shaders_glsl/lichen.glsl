// SPDX-License-Identifier: MIT
// The one file that a host includes (with `shaders_glsl/` on its include path and
// GL_GOOGLE_include_directive enabled). Everything is prefixed lichen, Lichen or LICHEN_.
//
// Images as arguments: include this file and call the functions; interface/fetch.glsl says what an
// image is. docs/integration.md has both ways.
// Descriptors declared here: define, before the include,
//   LICHEN_SET            the descriptor set that the plugin fills
//   LICHEN_FIRST_BINDING  its first binding (0)
//   LICHEN_ROLES          bit r: some noise has a map of role r (63, all); others are never there
//   LICHEN_LAYERS         most layers of a noise, 1 to 4 (1, no noise is layered)
// which gives lichenNoise, lichenMaps[role] and lichenMaterial,
// LICHEN_POINT(uv, gradientX, gradientY), where the noise is evaluated, or of other mappings
// LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, normal),
// LICHEN_POINT_SURFACE(position, gradientX, gradientY, normal, tangent) and
// LICHEN_POINT_SOLID(position, gradientX, gradientY),
// LICHEN_HAS(role), whether the noise has that map,
// LICHEN_VALUE(role, point), its value there, whatever the noise's method,
// LICHEN_GRADIENT(role, uv, gradientX, gradientY), a value and its derivatives for bumps (without
// layers), LICHEN_SHADING_POINT, the type of a point, and
// LICHEN_IMAGE(role) and LICHEN_TABLE(role), which other functions take (likewise).
// With LICHEN_LAYERS above 1 there are base colour, normals, and occlusion, roughness and metallic,
// no surfaces and no quilting; LICHEN_POINT_ANYWHERE(uv, uvGradientX, uvGradientY, position, gradientX,
// gradientY, normal) is a point of a material with any mapping.
//
// A host that knows more at compile time leaves out what it does not need: less code to run. The
// switches are in README.md.
#ifndef LICHEN_GLSL
#define LICHEN_GLSL

#include "interface/lichen_interface.h"

#ifdef LICHEN_SET
#ifndef LICHEN_FIRST_BINDING
#define LICHEN_FIRST_BINDING 0
#endif
#ifndef LICHEN_ROLES
#define LICHEN_ROLES 63
#endif

layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING +
                                   LICHEN_BINDING_IMAGE_SAMPLER) uniform sampler lichenImageSampler;
layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING +
                                   LICHEN_BINDING_TABLE_SAMPLER) uniform sampler lichenTableSampler;
#ifndef LICHEN_LAYERS
#define LICHEN_LAYERS 1
#endif
#if LICHEN_LAYERS > 1
#ifndef LICHEN_OMIT_SURFACE
#define LICHEN_OMIT_SURFACE
#endif
#include "interface/layer_images.glsl"
#else
#define LICHEN_IMAGE_2D texture2D
#define LICHEN_IMAGE_3D texture3D
#define LICHEN_SAMPLE_2D(image, uv, level)                                                         \
  textureLod(sampler2D(image, lichenImageSampler), uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY)                                                 \
  textureGrad(sampler2D(image, lichenImageSampler), uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level)                                                        \
  textureLod(sampler3D(image, lichenTableSampler), uvw, level)
#define LICHEN_FETCH_2D(image, texel) texelFetch(sampler2D(image, lichenImageSampler), texel, 0)
#define LICHEN_GATHER_2D(image, uv) textureGather(sampler2D(image, lichenImageSampler), uv, 0)
#endif
#endif

#ifdef LICHEN_SET
layout(std140, set = LICHEN_SET,
       binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_NOISE) uniform LichenNoiseBlock {
  LichenNoise lichenNoise;
  LichenMap lichenMaps[LICHEN_MAX_MAPS];
  LichenLayers lichenLayers;
  LichenNoise lichenLayerNoises[LICHEN_MAX_LAYERS - 1];
  LichenNoise lichenIndexNoises[LICHEN_MAX_LAYER_NODES];
  LichenMap lichenIndexMaps[LICHEN_MAX_LAYER_NODES];
  uvec4 lichenOffsets[LICHEN_MAX_OFFSETS / 4];
};
#if LICHEN_LAYERS == 1
layout(set = LICHEN_SET,
       binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_CELLS) uniform texture2D lichenCells;
#define LICHEN_SAMPLE_CELLS(uv, level)                                                             \
  textureLod(sampler2D(lichenCells, lichenImageSampler), uv, level)
#define LICHEN_TILE_OFFSET(index) lichenOffsets[(index) >> 2u][(index) & 3u]
#endif
#endif

#include "mapping/mix.glsl"
#include "mapping/solid.glsl"
#include "mapping/surface.glsl"
#include "mapping/triplanar.glsl"
#include "mapping/uv.glsl"

#ifdef LICHEN_SET
layout(std140, set = LICHEN_SET,
       binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_MATERIAL) uniform LichenMaterialBlock {
  LichenMaterial lichenMaterial;
#if !defined(LICHEN_OMIT_TRIPLANAR) || LICHEN_LAYERS > 1
  LichenPlane lichenPlaneY, lichenPlaneZ;
#endif
#if LICHEN_LAYERS > 1
  LichenTriplanarMaterial lichenLayerMaterials[LICHEN_MAX_LAYERS - 1];
  LichenTriplanarMaterial lichenIndexMaterials[LICHEN_MAX_LAYER_NODES];
#endif
};

#define LICHEN_DECLARE_ROLE(role)                                                                  \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_IMAGE(role))            \
      uniform texture2D lichenImage##role;                                                         \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_TABLE(role))            \
      uniform texture3D lichenTable##role

#if LICHEN_LAYERS == 1
#if (LICHEN_ROLES & 1) != 0
LICHEN_DECLARE_ROLE(0);
#endif
#if (LICHEN_ROLES & 2) != 0
LICHEN_DECLARE_ROLE(1);
#endif
#if (LICHEN_ROLES & 4) != 0
LICHEN_DECLARE_ROLE(2);
#endif
#if (LICHEN_ROLES & 8) != 0
LICHEN_DECLARE_ROLE(3);
#endif
#if (LICHEN_ROLES & 16) != 0
LICHEN_DECLARE_ROLE(4);
#endif
#if (LICHEN_ROLES & 32) != 0
LICHEN_DECLARE_ROLE(5);
#endif
#endif

#if LICHEN_LAYERS > 1
#define LICHEN_VALUE_ROLES (LICHEN_ROLES & 7)
#include "mapping/layered.glsl"
#define LICHEN_VALUE_HERE(role, shading) shading.values[role]
#define LICHEN_SHADING_POINT LichenLayeredPoint
#define LICHEN_POINT(uv, gradientX, gradientY) lichenLayeredUv(uv, gradientX, gradientY)
#define LICHEN_POINT_ANYWHERE(uv, uvGradientX, uvGradientY, position, gradientX, gradientY,        \
                              normal)                                                              \
  lichenLayeredAnywhere(uv, uvGradientX, uvGradientY, position, gradientX, gradientY, normal)
#define LICHEN_POINT_SOLID(position, gradientX, gradientY)                                         \
  lichenLayeredInSpace(position, gradientX, gradientY, vec3(0.0))
#define LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, normal)                             \
  lichenLayeredInSpace(position, gradientX, gradientY, normal)
#else
#define LICHEN_VALUE_ROLES LICHEN_ROLES
#define LICHEN_VALUE_HERE(role, shading)                                                           \
  lichenValue(lichenImage##role, lichenTable##role, shading, lichenMapOf(role, lichenMaps[role]))
#define LICHEN_SHADING_POINT LichenShadingPoint

#define LICHEN_POINT(uv, gradientX, gradientY)                                                     \
  lichenPointUvGrad(uv, gradientX, gradientY, lichenMaterial, lichenNoise)

#define LICHEN_GRADIENT(role, uv, gradientX, gradientY)                                            \
  lichenGradientUvGrad(LICHEN_IMAGE(role), LICHEN_TABLE(role), uv, gradientX, gradientY,           \
                       lichenMaterial, lichenNoise, lichenMaps[role])

#define LICHEN_POINT_SURFACE(position, gradientX, gradientY, normal, tangent)                      \
  lichenPointSurfaceGrad(position, gradientX, gradientY, normal, tangent, lichenMaterial,          \
                         lichenNoise)

#ifndef LICHEN_OMIT_SOLID
#define LICHEN_POINT_SOLID(position, gradientX, gradientY)                                         \
  lichenPointSolidGrad(position, gradientX, gradientY, lichenMaterial, lichenNoise)
#endif

#ifndef LICHEN_OMIT_TRIPLANAR
#define LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, normal)                             \
  lichenPointTriplanarGrad(position, gradientX, gradientY, normal,                                 \
                           LichenTriplanarMaterial(lichenMaterial, lichenPlaneY, lichenPlaneZ),    \
                           lichenNoise)
#endif
#endif

#if (LICHEN_VALUE_ROLES & 1) != 0
#define LICHEN_VALUE_0(shading) LICHEN_VALUE_HERE(0, shading)
#else
#define LICHEN_VALUE_0(shading) vec4(0.0)
#endif
#if (LICHEN_VALUE_ROLES & 2) != 0
#define LICHEN_VALUE_1(shading) LICHEN_VALUE_HERE(1, shading)
#else
#define LICHEN_VALUE_1(shading) vec4(0.0)
#endif
#if (LICHEN_VALUE_ROLES & 4) != 0
#define LICHEN_VALUE_2(shading) LICHEN_VALUE_HERE(2, shading)
#else
#define LICHEN_VALUE_2(shading) vec4(0.0)
#endif
#if (LICHEN_VALUE_ROLES & 8) != 0
#define LICHEN_VALUE_3(shading) LICHEN_VALUE_HERE(3, shading)
#else
#define LICHEN_VALUE_3(shading) vec4(0.0)
#endif
#if (LICHEN_VALUE_ROLES & 16) != 0
#define LICHEN_VALUE_4(shading) LICHEN_VALUE_HERE(4, shading)
#else
#define LICHEN_VALUE_4(shading) vec4(0.0)
#endif
#if (LICHEN_VALUE_ROLES & 32) != 0
#define LICHEN_VALUE_5(shading) LICHEN_VALUE_HERE(5, shading)
#else
#define LICHEN_VALUE_5(shading) vec4(0.0)
#endif

#define LICHEN_HAS(role)                                                                           \
  ((((lichenNoise.roles & uint(LICHEN_VALUE_ROLES)) >> uint(role)) & 1u) != 0u)

// Twice, so that a role's name becomes its number before it is pasted.
#define LICHEN_IMAGE(role) LICHEN_IMAGE_OF(role)
#define LICHEN_TABLE(role) LICHEN_TABLE_OF(role)
#define LICHEN_IMAGE_OF(role) lichenImage##role
#define LICHEN_TABLE_OF(role) lichenTable##role

// Occlusion, roughness and metallic; those that the noise does not have from a vec3.
#define LICHEN_ORM(shading, absent)                                                                \
  lichenOrm(LICHEN_VALUE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC, shading).rgb, absent,                \
            lichenMaps[LICHEN_OCCLUSION_ROUGHNESS_METALLIC])

#define LICHEN_VALUE(role, shading) LICHEN_VALUE_OF(role, shading)
#define LICHEN_VALUE_OF(role, shading) LICHEN_VALUE_##role(shading)
#endif

#endif
