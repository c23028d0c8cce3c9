#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The parts of tiling and textons, each over an array: questions[k] -> answers[3 k ... 3 k + 2].
#include "lichen.glsl"

const int kHash = 0;        // (i, j, seedWord, seed) -> pcg3d, offset and steps, seed and pcg
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
    second.xy =
        lichenTileOffsetIndex(int(question.x), int(question.y), question.z, uvec2(64u, 75u));
    second.z = lichenTileRotationStep(int(question.x), int(question.y), question.z, 7u);
    second.w = lichenTileRotationStep(int(question.x), int(question.y), question.z, 65536u);
    third.xy = uvec2(lichenLatticeSeed(question.w, question.z & 3u), lichenPcg(question.x));
  } else if (kFunction == kTriangle) {
    LichenNoise noise;
    noise.columnsPerTile = 3.4641016;
    noise.rowsPerTile = 4.0;
    noise.fractionI = 0.375;
    noise.fractionJ = 0.0;
    noise.cellI = int(question.z);
    noise.cellJ = int(question.w);
    LichenTriangle triangle = lichenTriangleAt(uintBitsToFloat(question.xy), noise);
    first.xyz = uvec3(triangle.i);
    second.xyz = uvec3(triangle.j);
    third.xyz = floatBitsToUint(triangle.weights);
  } else if (kFunction == kCdf) {
    first.xyz = floatBitsToUint(lichenGaussianCdf(uintBitsToFloat(question.xyz)));
  } else if (kFunction == kFloorDivide) {
    first.xyz = uvec3(lichenFloorDivide(ivec3(question.xyz), int(question.w)));
  } else {
    int period = int(question.w);
    vec3 cells = uintBitsToFloat(question.xyz);
    first.xyz = uvec3(lichenWrapped(lichenCellNumber(cells.x, period), period),
                      lichenWrapped(lichenCellNumber(cells.y, period), period),
                      lichenWrapped(lichenCellNumber(cells.z, period), period));
  }
  answers[3u * index] = first;
  answers[3u * index + 1u] = second;
  answers[3u * index + 2u] = third;
}
