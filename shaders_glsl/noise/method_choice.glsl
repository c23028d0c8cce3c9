// SPDX-License-Identifier: MIT
// The methods that there are, which of them a noise has, and how it is mapped: known at compile
// time where a host says so.
#ifndef LICHEN_METHOD_CHOICE_GLSL
#define LICHEN_METHOD_CHOICE_GLSL

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
// Bit m: some noise has the method m, of those that are compiled. A literal, or the host's
// specialization constant; some drivers take longer to drop the code of such a constant than to
// compile the rest.
#ifndef LICHEN_USED_METHODS
#define LICHEN_USED_METHODS LICHEN_METHODS
#endif

// DO(name, Type, LICHEN_METHOD_...) for each method that is compiled: its member of LichenPoint,
// and the type of that, for which the method has the functions that method.glsl lists.
#define LICHEN_EACH_METHOD(DO)                                                                     \
  LICHEN_EACH_TILING(DO)                                                                           \
  LICHEN_EACH_TEXTON(DO)                                                                           \
  LICHEN_EACH_LOCAL_RANDOM_PHASE(DO)                                                               \
  LICHEN_EACH_MULTIPLE_KERNELS(DO)                                                                 \
  LICHEN_EACH_QUILTING(DO)
#if (LICHEN_METHODS & 1) != 0
#define LICHEN_EACH_TILING(DO) DO(tiling, LichenTilingTaps, LICHEN_METHOD_TILING)
#else
#define LICHEN_EACH_TILING(DO)
#endif
#if (LICHEN_METHODS & 2) != 0
#define LICHEN_HAS_TEXTONS
#define LICHEN_EACH_TEXTON(DO) DO(texton, LichenImpacts, LICHEN_METHOD_TEXTON)
#define LICHEN_SURFACE_TEXTON(DO) DO(texton, LichenSurfaceCubes, LICHEN_METHOD_TEXTON)
#else
#define LICHEN_EACH_TEXTON(DO)
#define LICHEN_SURFACE_TEXTON(DO)
#endif
#if (LICHEN_METHODS & 4) != 0
#define LICHEN_HAS_LOCAL_RANDOM_PHASE
#define LICHEN_EACH_LOCAL_RANDOM_PHASE(DO)                                                         \
  DO(localRandomPhase, LichenCosinesPoint, LICHEN_METHOD_LOCAL_RANDOM_PHASE)
#define LICHEN_SOLID_LOCAL_RANDOM_PHASE(DO)                                                        \
  DO(localRandomPhase, LichenSolidCosinesPoint, LICHEN_METHOD_LOCAL_RANDOM_PHASE)
#else
#define LICHEN_EACH_LOCAL_RANDOM_PHASE(DO)
#define LICHEN_SOLID_LOCAL_RANDOM_PHASE(DO)
#endif
#if (LICHEN_METHODS & 8) != 0
#define LICHEN_HAS_MULTIPLE_KERNELS
#define LICHEN_EACH_MULTIPLE_KERNELS(DO)                                                           \
  DO(multipleKernels, LichenKernelsPoint, LICHEN_METHOD_MULTIPLE_KERNELS)
#define LICHEN_SOLID_MULTIPLE_KERNELS(DO)                                                          \
  DO(multipleKernels, LichenSolidKernelsPoint, LICHEN_METHOD_MULTIPLE_KERNELS)
#define LICHEN_SURFACE_MULTIPLE_KERNELS(DO)                                                        \
  DO(multipleKernels, LichenSurfaceKernelsPoint, LICHEN_METHOD_MULTIPLE_KERNELS)
#else
#define LICHEN_EACH_MULTIPLE_KERNELS(DO)
#define LICHEN_SURFACE_MULTIPLE_KERNELS(DO)
#define LICHEN_SOLID_MULTIPLE_KERNELS(DO)
#endif
#if (LICHEN_METHODS & 16) != 0
#define LICHEN_HAS_QUILTING
#define LICHEN_EACH_QUILTING(DO) DO(quilting, LichenQuiltingPoint, LICHEN_METHOD_QUILTING)
#else
#define LICHEN_EACH_QUILTING(DO)
#endif

// Likewise, for each method that has solids: its member of LichenSolidPoint; see
// solid_method.glsl.
#define LICHEN_EACH_SOLID_METHOD(DO)                                                               \
  LICHEN_SOLID_LOCAL_RANDOM_PHASE(DO)                                                              \
  LICHEN_SOLID_MULTIPLE_KERNELS(DO)
#if (LICHEN_METHODS & 12) == 0 && !defined(LICHEN_OMIT_SOLID)
#define LICHEN_OMIT_SOLID
#endif
// Likewise, for each method that has surfaces; see surface_method.glsl.
#define LICHEN_EACH_SURFACE_METHOD(DO)                                                             \
  LICHEN_SURFACE_TEXTON(DO)                                                                        \
  LICHEN_SURFACE_MULTIPLE_KERNELS(DO)
#if (LICHEN_METHODS & 10) == 0 && !defined(LICHEN_OMIT_SURFACE)
#define LICHEN_OMIT_SURFACE
#endif

// 0 where no material's mapping is surface. A literal, or the host's specialization constant; where
// LICHEN_OMIT_SURFACE is defined it is not compiled.
#ifdef LICHEN_OMIT_SURFACE
#undef LICHEN_SURFACE
#define LICHEN_SURFACE 0
#endif
#ifndef LICHEN_SURFACE
#define LICHEN_SURFACE 1
#endif
// 0 where no material's mapping is solid. Likewise; LICHEN_OMIT_SOLID.
#ifdef LICHEN_OMIT_SOLID
#undef LICHEN_SOLID
#define LICHEN_SOLID 0
#endif
#ifndef LICHEN_SOLID
#define LICHEN_SOLID 1
#endif
// 0 where no material's mapping is triplanar. Likewise; LICHEN_OMIT_TRIPLANAR.
#ifdef LICHEN_OMIT_TRIPLANAR
#define LICHEN_TRIPLANAR 0
#endif
#ifndef LICHEN_TRIPLANAR
#define LICHEN_TRIPLANAR 1
#endif
// 0 where every material's mapping is triplanar. Likewise.
#ifndef LICHEN_OTHER_MAPPINGS
#define LICHEN_OTHER_MAPPINGS 1
#endif

/// Whether a noise has this method; known at compile time where there is only one, or not this.
bool lichenHasMethod(int method, LichenNoise noise) {
  int used = int(LICHEN_USED_METHODS);
  int bit = 1 << method;
  return used == bit || ((used & bit) != 0 && noise.method == uint(method));
}

/// Whether the mapping is surface; known at compile time where none is.
bool lichenIsSurface(LichenMaterial material, LichenNoise noise) {
  if (!bool(LICHEN_SURFACE))
    return false;
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    return lichenTextonMaterial(material).surfaceCubeTexels > 0.0;
  return lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise) &&
         lichenKernelsMaterial(material).isSurface != 0u;
}

/// Whether the mapping is solid; known at compile time where none is.
bool lichenIsSolid(LichenMaterial material, LichenNoise noise) {
  if (!bool(LICHEN_SOLID))
    return false;
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    return lichenCosinesMaterial(material).isSolid != 0u;
  return lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise) &&
         lichenKernelsMaterial(material).isSolid != 0u;
}

/// Whether the mapping is triplanar; known at compile time where none is, or all are.
bool lichenIsTriplanar(LichenMaterial material) {
  // In variables: of a specialization constant negated here, glslang 11 makes invalid SPIR-V.
  bool hasTriplanar = bool(LICHEN_TRIPLANAR);
  bool hasOther = bool(LICHEN_OTHER_MAPPINGS);
  return hasTriplanar && (!hasOther || material.planeSharpness > 0.0);
}

/// Whether slopes are a gradient in space, for lichenNormalFromGradient.
bool lichenHasSlopesInSpace(LichenMaterial material, LichenNoise noise) {
  return lichenIsTriplanar(material) || lichenIsSolid(material, noise);
}

#endif
