// SPDX-License-Identifier: MIT
// Structs and binding numbers shared by the renderer's C++ and GLSL. Uses only vec4, ivec4 and
// mat4. World positions are relative to an origin near the camera, FrameInputs::origin.
#ifndef SCENE_INTERFACE_H
#define SCENE_INTERFACE_H

#define MAX_LIGHTS 16
// Maximum number of sky directions per frame.
#define MAX_SKY_DIRECTIONS 16

#define SET_FRAME 0
#define BINDING_FRAME 0
#define BINDING_SPECULAR 1
#define BINDING_DIFFUSE 2
#define BINDING_BRDF 3
#define BINDING_PANORAMA 4
#define BINDING_SUN_DEPTH 5
#define BINDING_SKY_DEPTH 6
#define FRAME_BINDINGS 7

#define SET_MATERIAL 1
#define BINDING_MATERIAL 0
// Texture k of a material has binding BINDING_TEXTURES + k.
#define BINDING_TEXTURES 1
#define TEXTURE_BASE_COLOR 0
#define TEXTURE_METALLIC_ROUGHNESS 1
#define TEXTURE_NORMAL 2
#define TEXTURE_OCCLUSION 3
#define TEXTURE_EMISSIVE 4
#define TEXTURE_MIX 5
#define MATERIAL_TEXTURES 6

#define SET_NOISE 2 // the plugin's

// Source of the weight of a mix: the noise's uniform block, a mask or the vertices.
#define MIX_FROM_BLOCK 0
#define MIX_FROM_MASK 1
#define MIX_FROM_VERTICES 2

#define LIGHT_DIRECTIONAL 0
#define LIGHT_POINT 1
#define LIGHT_SPOT 2

#define ALPHA_OPAQUE 0
#define ALPHA_MASK 1
#define ALPHA_BLEND 2

#define DEBUG_NONE 0
#define DEBUG_NORMALS 1
#define DEBUG_BASE_COLOR 2
#define DEBUG_WEIGHTS 3
#define DEBUG_LATTICE 4
#define DEBUG_MIP_LEVEL 5
#define DEBUG_GAUSSIAN 6
#define DEBUG_IMPACTS 7
#define DEBUG_PLANES 8
#define DEBUG_ROUGHNESS 9
#define DEBUG_METALLIC 10
#define DEBUG_OCCLUSION 11

#ifdef __cplusplus
#include <glm/glm.hpp>
namespace lichen::renderer::shader {
using glm::ivec4;
using glm::mat4;
using glm::vec4;
#endif

struct LightData {
  vec4 positionAndKind;   // world; w is LIGHT_*
  vec4 directionAndRange; // direction in which light travels; w is 0 for an unlimited range
  vec4 color;             // times intensity; w unused
  vec4 cone;              // x cosine of the outer angle, y 1 / (inner - outer cosine); zw unused
};

struct FrameData {
  mat4 clipFromWorld;
  mat4 worldFromClip; // for a camera at the origin
  mat4 sunFromWorld;  // to [0, 1]^3 of the sun's depth map
  mat4 skyFromWorld[MAX_SKY_DIRECTIONS];
  vec4 skyDirection[MAX_SKY_DIRECTIONS]; // toward the sky
  vec4 cameraPosition;                   // w is 0 for an orthographic camera
  vec4 cameraForward;
  // x 1 / distance at which haze absorbs 63 %, 0 for no haze; y last level of the specular cube
  // map; z scale of texture gradients; w 1 if light 0 is the sun, whose depth map exists.
  vec4 environment;
  vec4 shadow;  // x, y world size of a texel of the sun's and the sky's depth maps; zw unused
  ivec4 counts; // x number of lights; y number of sky directions; zw unused
  LightData lights[MAX_LIGHTS];
};

struct MaterialData {
  vec4 baseColor;
  vec4 emissive;   // w is the alpha cutoff, 0 without one
  vec4 factors;    // metallic, roughness, normal scale, occlusion strength
  ivec4 texCoords; // of textures 0 to 3
  ivec4 flags;     // x texCoord of texture 4, y ALPHA_*, z unused, w texCoord of the noise
  ivec4 mixSource; // x MIX_*, y texCoord of the mask, z its channel;
                   // w 1 for a noise in the space of the object, 0 in the world
  // offset from the renderer's origin to the noise's tile origin, added to positions; w world units
  // by which the height 1 of the noise moves the surface, 0 without displacement
  vec4 fromTileOrigin;
  vec4 transformRows[2 * MATERIAL_TEXTURES]; // of KHR_texture_transform: uv' = rows * (u, v, 1)
};

struct DrawData {
  mat4 worldFromObject;
};

struct DepthData {
  mat4 clipFromObject;
  mat4 worldFromObject;
};

struct DisplacedData {
  mat4 clipFromWorld;
  vec4 worldRows[3]; // of worldFromObject
  vec4 footprint; // x world units that the footprint of a height measures at clip w 1
};

#ifdef __cplusplus
} // namespace lichen::renderer::shader
#endif

#endif
