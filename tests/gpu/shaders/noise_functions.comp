#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The integer functions of the library, each over an array: questions[k] -> answers[3 k ... 3 k + 2].
#include "lichen.glsl"

const int kHash = 0;        // (i, j, seedWord, seed) -> pcg3d; offset, vertex hash; seed, pcg, turn
const int kFloorDivide = 1; // (value, period) -> quotient
layout(constant_id = 0) const int kFunction = kHash;

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Questions { uvec4 questions[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { uvec4 answers[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(questions.length()))
    return;
  uvec4 question = questions[index];
  uvec4 first = uvec4(0u), second = uvec4(0u), third = uvec4(0u);
  if (kFunction == kHash) {
    first.xyz = lichenPcg3d(question.xyz);
    LichenMaterial material;
    material.seedWord = question.z;
    LichenNoise noise;
    noise.offsetStepX = 1.0;
    noise.offsetStepY = 1.0;
    uvec2 vertex = question.xy;
    second.xy = uvec2(ivec2(lichenTileOffset(vertex, material, noise)));
    second.z = lichenVertexHash(vertex.x, vertex.y, question.z);
    material.own0.y = 2u;
    first.w = floatBitsToUint(lichenTileRotationAt(vertex, material).x);
    material.own0.y = 4u;
    third.zw = floatBitsToUint(lichenTileRotationAt(vertex, material));
    third.xy = uvec2(lichenLatticeSeed(question.w, question.z & 3u), lichenPcg(question.x));
  } else {
    int period = int(question.w);
    first.xyz = uvec3(ivec3(lichenFloorDivide(int(question.x), period),
                            lichenFloorDivide(int(question.y), period),
                            lichenFloorDivide(int(question.z), period)));
  }
  answers[3u * index] = first;
  answers[3u * index + 1u] = second;
  answers[3u * index + 2u] = third;
}
