// SPDX-License-Identifier: MIT
// The methods, mappings and features that a shader has: literals and constants that a host defines
// before the include (README.md, Switches), and what follows from them for a noise and a material.
#ifndef LICHEN_SWITCHES_GLSL
#define LICHEN_SWITCHES_GLSL

#include "../interface/lichen_interface.h"
#include "method_parts.glsl"

// Bit m: the method m (LICHEN_METHOD_...) is compiled. A literal. Quilting needs
// LICHEN_SAMPLE_CELLS and LICHEN_TILE_OFFSET (interface/fetch.glsl).
#ifndef LICHEN_METHODS
#ifdef LICHEN_SAMPLE_CELLS
#define LICHEN_METHODS 31
#else
#define LICHEN_METHODS 15
#endif
#endif
// Bit m: the mapping m (LICHEN_MAPPING_... of the plugin) is compiled: texture coordinates,
// triplanar, surface, solid. A literal.
#ifndef LICHEN_MAPPINGS
#define LICHEN_MAPPINGS 15
#endif
// The layers that a noise may have; 1 where no noise is layered. A literal.
#ifndef LICHEN_LAYERS
#define LICHEN_LAYERS 1
#endif
#define LICHEN_HAS_TRIPLANAR ((LICHEN_MAPPINGS & 2) != 0)
#define LICHEN_HAS_SURFACES ((LICHEN_MAPPINGS & 4) != 0 && (LICHEN_METHODS & 10) != 0)
#define LICHEN_HAS_SOLIDS ((LICHEN_MAPPINGS & 8) != 0 && (LICHEN_METHODS & 12) != 0)

// Bits LICHEN_FEATURE_...: what some noise or material has. Others are then silently wrong. A
// literal, or the host's specialization constant; some drivers take longer to drop the code of such
// a constant than to compile the rest.
#ifndef LICHEN_FEATURES
#define LICHEN_FEATURES 0xFFFFFFFFu
#endif
#define LICHEN_USES(feature) ((uint(LICHEN_FEATURES) & (feature)) != 0u)

/// Whether a noise has this method; known at compile time where there is only one, or not this.
bool lichenHasMethod(int method, LichenNoise noise) {
  uint used = uint(LICHEN_FEATURES) & uint(LICHEN_METHODS);
  uint bit = 1u << uint(method);
  return used == bit || ((used & bit) != 0u && noise.method == uint(method));
}

/// Whether the mapping is triplanar; known at compile time where none is, or all are.
bool lichenIsTriplanar(LichenMaterial material) {
  // In variables: of a specialization constant negated here, glslang 11 makes invalid SPIR-V.
  bool hasTriplanar = LICHEN_HAS_TRIPLANAR && LICHEN_USES(LICHEN_FEATURE_TRIPLANAR);
  bool hasOther = (LICHEN_MAPPINGS & 13) != 0 &&
                  LICHEN_USES(LICHEN_FEATURE_UV | LICHEN_FEATURE_SURFACE | LICHEN_FEATURE_SOLID);
  return hasTriplanar && (!hasOther || material.planeSharpness > 0.0);
}

/// Whether the mapping is surface; known at compile time where none is.
bool lichenIsSurface(LichenMaterial material, LichenNoise noise) {
  bool hasSurfaces = LICHEN_HAS_SURFACES && LICHEN_USES(LICHEN_FEATURE_SURFACE); // as above
  if (!hasSurfaces)
    return false;
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    return lichenTextonMaterial(material).surfaceCubeTexels > 0.0;
  return lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise) &&
         lichenKernelsMaterial(material).isSurface != 0u;
}

/// Whether the mapping is solid; known at compile time where none is.
bool lichenIsSolid(LichenMaterial material, LichenNoise noise) {
  bool hasSolids = LICHEN_HAS_SOLIDS && LICHEN_USES(LICHEN_FEATURE_SOLID); // as above
  if (!hasSolids)
    return false;
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    return lichenCosinesMaterial(material).isSolid != 0u;
  return lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise) &&
         lichenKernelsMaterial(material).isSolid != 0u;
}

/// Whether slopes are a gradient in space, for lichenNormalFromGradient.
bool lichenHasSlopesInSpace(LichenMaterial material, LichenNoise noise) {
  return lichenIsTriplanar(material) || lichenIsSolid(material, noise);
}

/// Whether the cells repeat; known at compile time where none do.
bool lichenIsPeriodic(LichenMaterial material) {
  return LICHEN_USES(LICHEN_FEATURE_PERIOD) && material.periodRows != 0;
}

#endif
