// SPDX-License-Identifier: MIT
// The one file that a host includes (with `shaders_glsl/` on its include path and
// GL_GOOGLE_include_directive enabled). Everything is prefixed lichen, Lichen or LICHEN_.
//
// Images as arguments: include this file and call the functions of mapping/ and lichenValue;
// interface/fetch.glsl says what an image is. docs/integration.md has both ways.
// Descriptors declared here: define LICHEN_SET, the descriptor set that the plugin fills, before
// the include. That gives lichenNoise, lichenMaps[role] and lichenMaterial, and
//   LICHEN_POINT(uv, gradientX, gradientY)        where the noise is evaluated, by the material's
//   LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, normal)                        mapping
//   LICHEN_POINT_SURFACE(position, gradientX, gradientY, normal, tangent)
//   LICHEN_POINT_SOLID(position, gradientX, gradientY)
//   LICHEN_HAS(role)                              whether the noise has that map
//   LICHEN_VALUE(role, point)                     its value there, whatever the noise's method; 0
//                                                 without such a map
//   LICHEN_GRADIENT(role, uv, gradientX, gradientY) a value and its derivatives, for bumps
//   LICHEN_SHADING_POINT                          the type of a point
//   LICHEN_IMAGE(role), LICHEN_TABLE(role)        the images, for other functions
// With LICHEN_LAYERS above 1 there are base colour, normals, and occlusion, roughness and metallic,
// no gradients, no surfaces and no quilting; LICHEN_POINT_ANYWHERE(uv, uvGradientX, uvGradientY,
// position, gradientX, gradientY, normal) is a point of a material with any mapping.
//
// A host that knows more at compile time leaves out what it does not need: less code to run. The
// switches are in README.md.
#ifndef LICHEN_GLSL
#define LICHEN_GLSL

#include "interface/lichen_interface.h"
#include "noise/switches.glsl"

#ifdef LICHEN_SET
#ifndef LICHEN_FIRST_BINDING
#define LICHEN_FIRST_BINDING 0
#endif
// Bit r: some noise has a map of role r. Others are never there. A literal, or the host's
// specialization constant.
#ifndef LICHEN_ROLES
#define LICHEN_ROLES 63
#endif
#define LICHEN_BINDING(number) set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + number

layout(LICHEN_BINDING(LICHEN_BINDING_IMAGE_SAMPLER)) uniform sampler lichenImageSampler;
layout(LICHEN_BINDING(LICHEN_BINDING_TABLE_SAMPLER)) uniform sampler lichenTableSampler;
layout(std140, LICHEN_BINDING(LICHEN_BINDING_NOISE)) uniform LichenNoiseBlock {
  LichenNoise lichenNoise;
  LichenMap lichenMaps[LICHEN_MAX_MAPS];
  LichenLayers lichenLayers;
  LichenNoise lichenLayerNoises[LICHEN_MAX_LAYERS - 1];
  LichenNoise lichenIndexNoises[LICHEN_MAX_LAYER_NODES];
  LichenMap lichenIndexMaps[LICHEN_MAX_LAYER_NODES];
  uvec4 lichenOffsets[LICHEN_MAX_OFFSETS / 4];
};
layout(std140, LICHEN_BINDING(LICHEN_BINDING_MATERIAL)) uniform LichenMaterialBlock {
  LichenMaterial lichenMaterial;
#if LICHEN_HAS_TRIPLANAR || LICHEN_LAYERS > 1
  LichenPlane lichenPlaneY, lichenPlaneZ;
#endif
#if LICHEN_LAYERS > 1
  LichenTriplanarMaterial lichenLayerMaterials[LICHEN_MAX_LAYERS - 1];
  LichenTriplanarMaterial lichenIndexMaterials[LICHEN_MAX_LAYER_NODES];
#endif
};

#define LICHEN_DECLARE_ROLE(role)                                                                  \
  layout(LICHEN_BINDING(LICHEN_BINDING_IMAGE(role))) uniform texture2D lichenImage##role;          \
  layout(LICHEN_BINDING(LICHEN_BINDING_TABLE(role))) uniform texture3D lichenTable##role
LICHEN_DECLARE_ROLE(0);
LICHEN_DECLARE_ROLE(1);
LICHEN_DECLARE_ROLE(2);
LICHEN_DECLARE_ROLE(3);
LICHEN_DECLARE_ROLE(4);
LICHEN_DECLARE_ROLE(5);

#if LICHEN_LAYERS > 1
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
layout(LICHEN_BINDING(LICHEN_BINDING_CELLS)) uniform texture2D lichenCells;
#define LICHEN_SAMPLE_CELLS(uv, level)                                                             \
  textureLod(sampler2D(lichenCells, lichenImageSampler), uv, level)
#define LICHEN_TILE_OFFSET(index) lichenOffsets[(index) >> 2u][(index) & 3u]
#endif
#endif

#include "library.glsl"

#ifdef LICHEN_SET
// In two steps, so that a role's name becomes its number before it is pasted.
#define LICHEN_IMAGE(role) LICHEN_IMAGE_OF(role)
#define LICHEN_TABLE(role) LICHEN_TABLE_OF(role)
#define LICHEN_IMAGE_OF(role) lichenImage##role
#define LICHEN_TABLE_OF(role) lichenTable##role

#if LICHEN_LAYERS > 1
#include "noise/layers.glsl"
#include "mapping/layered.glsl"
#define LICHEN_HAS(role)                                                                           \
  ((((lichenNoise.roles & uint(LICHEN_ROLES) & 7u) >> uint(role)) & 1u) != 0u)
#define LICHEN_VALUE(role, shading)                                                                \
  (LICHEN_HAS(role) ? shading.values[(role) < 3 ? (role) : 0] : vec4(0.0))
#define LICHEN_SHADING_POINT LichenLayeredPoint
#define LICHEN_POINT_ANYWHERE(uv, uvGradientX, uvGradientY, position, gradientX, gradientY,        \
                              normal)                                                              \
  lichenLayeredAt(uv, uvGradientX, uvGradientY, position, gradientX, gradientY, normal)
#define LICHEN_POINT(uv, gradientX, gradientY)                                                     \
  lichenLayeredAt(uv, gradientX, gradientY, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0))
#define LICHEN_POINT_SOLID(position, gradientX, gradientY)                                         \
  LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, vec3(0.0))
#define LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, normal)                             \
  lichenLayeredAt(vec2(0.0), vec2(0.0), vec2(0.0), position, gradientX, gradientY, normal)
#else
#define LICHEN_HAS(role) ((((lichenNoise.roles & uint(LICHEN_ROLES)) >> uint(role)) & 1u) != 0u)
#define LICHEN_VALUE(role, shading)                                                                \
  (LICHEN_HAS(role) ? lichenValue(LICHEN_IMAGE(role), LICHEN_TABLE(role), shading,                 \
                                  lichenMapOf(role, lichenMaps[role]))                             \
                    : vec4(0.0))
#define LICHEN_GRADIENT(role, uv, gradientX, gradientY)                                            \
  lichenGradientUvGrad(LICHEN_IMAGE(role), LICHEN_TABLE(role), uv, gradientX, gradientY,           \
                       lichenMaterial, lichenNoise, lichenMaps[role])
#define LICHEN_SHADING_POINT LichenShadingPoint
#define LICHEN_POINT(uv, gradientX, gradientY)                                                     \
  lichenPointUvGrad(uv, gradientX, gradientY, lichenMaterial, lichenNoise)
#define LICHEN_POINT_SURFACE(position, gradientX, gradientY, normal, tangent)                      \
  lichenPointSurfaceGrad(position, gradientX, gradientY, normal, tangent, lichenMaterial,          \
                         lichenNoise)
#define LICHEN_POINT_SOLID(position, gradientX, gradientY)                                         \
  lichenPointSolidGrad(position, gradientX, gradientY, lichenMaterial, lichenNoise)
#define LICHEN_POINT_TRIPLANAR(position, gradientX, gradientY, normal)                             \
  lichenPointTriplanarGrad(position, gradientX, gradientY, normal,                                 \
                           LichenTriplanarMaterial(lichenMaterial, lichenPlaneY, lichenPlaneZ),    \
                           lichenNoise)
#endif

// Occlusion, roughness and metallic; those that the noise does not have from a vec3.
#define LICHEN_ORM(shading, absent)                                                                \
  lichenOrm(LICHEN_VALUE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC, shading).rgb, absent,                \
            lichenMaps[LICHEN_OCCLUSION_ROUGHNESS_METALLIC])
#endif

#endif
