// SPDX-License-Identifier: MIT
// Which method a noise has and how it is mapped, known at compile time where a host says so.
#ifndef LICHEN_METHOD_CHOICE_GLSL
#define LICHEN_METHOD_CHOICE_GLSL

#include "../interface/lichen_interface.h"
#include "material_parts.glsl"

// 0 where no noise is of this method. Literals, or the host's specialization constants. Where
// LICHEN_OMIT_TEXTONS is defined, textons are not called at all, and where
// LICHEN_OMIT_SURFACE_TEXTONS is, those on surfaces are not: some drivers take longer to drop the
// code of a constant that is false than to compile the rest.
#ifdef LICHEN_OMIT_TEXTONS
#define LICHEN_TEXTON_NOISES 0
#ifndef LICHEN_OMIT_SURFACE_TEXTONS
#define LICHEN_OMIT_SURFACE_TEXTONS
#endif
#endif
#ifdef LICHEN_OMIT_SURFACE_TEXTONS
#define LICHEN_SURFACE_TEXTONS 0
#endif
#ifndef LICHEN_TILING_NOISES
#define LICHEN_TILING_NOISES 1
#endif
#ifndef LICHEN_TEXTON_NOISES
#define LICHEN_TEXTON_NOISES 1
#endif
// 0 where no texton noise is mapped onto a surface. Likewise.
#ifndef LICHEN_SURFACE_TEXTONS
#define LICHEN_SURFACE_TEXTONS 1
#endif
// 0 where no material's mapping is triplanar. Likewise, and where LICHEN_OMIT_TRIPLANAR is defined
// it is not called at all.
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

/// Whether this is texton noise; known at compile time where a method is left out.
bool lichenIsTexton(LichenNoise noise) {
  // In variables: of a specialization constant negated here, glslang 11 makes invalid SPIR-V.
  bool hasTexton = bool(LICHEN_TEXTON_NOISES);
  bool hasTiling = bool(LICHEN_TILING_NOISES);
  return hasTexton && (!hasTiling || noise.method == uint(LICHEN_METHOD_TEXTON));
}

/// Whether texton noise is mapped onto a surface; known at compile time where none is.
bool lichenIsSurface(LichenMaterial material) {
  return bool(LICHEN_SURFACE_TEXTONS) && lichenTextonMaterial(material).surfaceCubeTexels > 0.0;
}

/// Whether the mapping is triplanar; known at compile time where none is, or all are.
bool lichenIsTriplanar(LichenMaterial material) {
  bool hasTriplanar = bool(LICHEN_TRIPLANAR); // in variables, as above
  bool hasOther = bool(LICHEN_OTHER_MAPPINGS);
  return hasTriplanar && (!hasOther || material.planeSharpness > 0.0);
}

#endif
