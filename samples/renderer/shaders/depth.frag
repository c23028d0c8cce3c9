#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Depth alone; fragments that an alpha mask takes away cast no shadow.
#include "scene_interface.h"

layout(std140, set = SET_MATERIAL, binding = BINDING_MATERIAL) uniform MaterialBlock {
  MaterialData material;
};
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_BASE_COLOR)
    uniform sampler2D baseColorTexture;

layout(location = 0) in vec4 texCoords;
layout(location = 1) in float vertexAlpha;

void main() {
  vec3 uv = vec3(material.texCoords.x == 0 ? texCoords.xy : texCoords.zw, 1.0);
  vec2 place = vec2(dot(material.transformRows[2 * TEXTURE_BASE_COLOR].xyz, uv),
                    dot(material.transformRows[2 * TEXTURE_BASE_COLOR + 1].xyz, uv));
  if (material.baseColor.a * vertexAlpha * texture(baseColorTexture, place).a < material.emissive.w)
    discard;
}
