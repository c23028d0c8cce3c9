#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Uses every struct of the interface, in a uniform block and in a storage buffer, so that their
// std140 and std430 layouts can be read from the SPIR-V.
#include "interface/lichen_interface.h"

layout(local_size_x = 1) in;
struct Interface {
  LichenNoiseConstants constants;
  LichenTriplanarMaterial material;
  LichenLayeredMaterial layered;
  LichenTilingMaterial tiling;
  LichenTextonMaterial texton;
  LichenCosinesMaterial cosines;
  LichenTilingNoise tilingNoise;
  LichenTextonNoise textonNoise;
  LichenCosinesNoise cosinesNoise;
  LichenKernelsNoise kernelsNoise;
  LichenQuiltingNoise quiltingNoise;
};

layout(std140, set = 0, binding = 0) uniform Std140 { Interface std140; };
layout(std430, set = 0, binding = 1) buffer Std430 { Interface std430; };

void main() { std430 = std140; }
