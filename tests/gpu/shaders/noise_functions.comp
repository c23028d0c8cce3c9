#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The parts of tiling and textons, each over an array: questions[k] -> answers[3 k ... 3 k + 2].
#include "lichen.glsl"

const int kHash = 0;        // (i, j, seedWord, seed) -> pcg3d; offset, vertex hash; seed, pcg, turn
const int kTriangle = 1;    // (position as float bits, cell) -> i, j, weights as float bits
const int kCdf = 2;         // float bits -> float bits
const int kFloorDivide = 3; // (value, period) -> quotient
const int kCellNumber = 4;  // (float bits, period) -> numbers of cells of a texton's grid
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
  } else if (kFunction == kTriangle) {
    LichenMaterial material;
    material.cellI = int(question.z);
    material.cellJ = int(question.w);
    material.columnsPerTile = 3.5;
    material.rowsPerTile = 4.0;
    vec2 skewed = lichenSkewed(uintBitsToFloat(question.xy), material);
    LichenTriangle triangle = lichenTriangle(skewed, material);
    first.xyz = uvec3(triangle.vertex0.x, triangle.vertex1.x, triangle.vertex2.x);
    second.xyz = uvec3(triangle.vertex0.y, triangle.vertex1.y, triangle.vertex2.y);
    third.xyz = floatBitsToUint(triangle.weights);
  } else if (kFunction == kCdf) {
    first.xyz = floatBitsToUint(lichenGaussianCdf(uintBitsToFloat(question.xyz)));
  } else if (kFunction == kFloorDivide) {
    int period = int(question.w);
    first.xyz = uvec3(ivec3(lichenFloorDivide(int(question.x), period),
                            lichenFloorDivide(int(question.y), period),
                            lichenFloorDivide(int(question.z), period)));
  } else {
    int period = int(question.w);
    vec3 cells = uintBitsToFloat(question.xyz);
    first.xyz = uvec3(lichenWrapped(int(lichenCellNumber(cells.x, period)), period),
                      lichenWrapped(int(lichenCellNumber(cells.y, period)), period),
                      lichenWrapped(int(lichenCellNumber(cells.z, period)), period));
  }
  answers[3u * index] = first;
  answers[3u * index + 1u] = second;
  answers[3u * index + 2u] = third;
}
