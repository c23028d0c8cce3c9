// SPDX-License-Identifier: MIT
// What a noise and a material hold for their method: words -> the method's own structs.

LichenTilingMaterial lichenTilingMaterial(LichenMaterial material) {
  return LichenTilingMaterial(uintBitsToFloat(material.own0.x), material.own0.y);
}

LichenTextonMaterial lichenTextonMaterial(LichenMaterial material) {
  return LichenTextonMaterial(uintBitsToFloat(material.own0.x), material.own0.y,
                              uintBitsToFloat(material.own0.z), int(material.own0.w),
                              uintBitsToFloat(material.own1.x), uintBitsToFloat(material.own1.y),
                              uintBitsToFloat(material.own1.z));
}

LichenTextonNoise lichenTextonNoise(LichenNoise noise) {
  return LichenTextonNoise(int(noise.own0.x), int(noise.own0.y), int(noise.own0.z),
                           int(noise.own0.w), noise.own1.x, noise.own1.y, noise.own1.z, 0u);
}

/// The size of a texton [coefficients], and of its image [texels].
vec2 lichenTextonCoefficients(LichenNoise noise) { return vec2(ivec2(noise.own0.xy)); }
vec2 lichenTextonImageSize(LichenNoise noise) {
  LichenTextonNoise texton = lichenTextonNoise(noise);
  return vec2(ivec2(texton.frameX, texton.frameY * int(texton.steps)));
}

LichenCosinesMaterial lichenCosinesMaterial(LichenMaterial material) {
  return LichenCosinesMaterial(int(material.own0.x), material.own0.y, int(material.own0.z),
                               uintBitsToFloat(material.own0.w));
}

LichenKernelsMaterial lichenKernelsMaterial(LichenMaterial material) {
  return LichenKernelsMaterial(int(material.own0.x), uintBitsToFloat(material.own0.y));
}

LichenKernelsNoise lichenKernelsNoise(LichenNoise noise) {
  return LichenKernelsNoise(noise.own0.x, noise.own0.y, noise.own0.z, noise.own0.w);
}

LichenQuiltingNoise lichenQuiltingNoise(LichenNoise noise) {
  return LichenQuiltingNoise(uintBitsToFloat(noise.own0.x), uintBitsToFloat(noise.own0.y),
                             uintBitsToFloat(noise.own0.z), noise.own0.w, noise.own1.x);
}

LichenCosinesNoise lichenCosinesNoise(LichenNoise noise) {
  return LichenCosinesNoise(noise.own0.x, noise.own0.y, noise.own0.z, noise.own0.w, noise.own1.x,
                            noise.own1.y, noise.own1.z, noise.own1.w);
}
