// SPDX-License-Identifier: MIT
// What a material holds for its noise's method: words -> the method's own struct.
#ifndef LICHEN_MATERIAL_PARTS_GLSL
#define LICHEN_MATERIAL_PARTS_GLSL

#include "../interface/lichen_interface.h"

LichenTilingMaterial lichenTilingMaterial(LichenMaterial material) {
  return LichenTilingMaterial(uintBitsToFloat(material.own0.x), material.own0.y);
}

LichenTextonMaterial lichenTextonMaterial(LichenMaterial material) {
  return LichenTextonMaterial(uintBitsToFloat(material.own0.x), material.own0.y,
                              uintBitsToFloat(material.own0.z), int(material.own0.w),
                              uintBitsToFloat(material.own1.x), uintBitsToFloat(material.own1.y),
                              uintBitsToFloat(material.own1.z));
}

#endif
