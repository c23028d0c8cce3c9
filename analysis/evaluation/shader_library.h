// SPDX-License-Identifier: MIT
// The shader library as C++: its structs and functions are members of ShaderLibrary, its fetches
// read tables in memory, and what a host declares beside it are data members. Each method's
// evaluate.cpp includes this once, for its own method alone (LICHEN_METHODS), so that compilers see
// constants. [PBRT4] compiles one source for CPU and GPU in the same way.
#pragma once

#include "glsl.h"

#include <lichen_interface.h>

#define LICHEN_OUT(Type) Type&
#define LICHEN_INOUT(Type) Type&
#define LICHEN_IMAGE_2D const RepeatingImage&
#define LICHEN_IMAGE_3D const ClampedVolume&
#define LICHEN_SAMPLE_2D(image, uv, level) sampled(image, uv, level)
#define LICHEN_SAMPLE_3D(table, uvw, level) sampled(table, uvw, level)
#define LICHEN_FETCH_2D(image, coordinate) fetched(image, coordinate)
#define LICHEN_SAMPLE_CELLS(uv, level) sampled(*cells, uv, level)
#define LICHEN_TILE_OFFSET(index) tileOffsets[index]
#define LICHEN_NEAREST_TABLE_LEVEL nearestTableLevel
#define LICHEN_LAYERS LICHEN_MAX_LAYERS // index maps are decoded too

// Constructors: Type(a, b) -> Type{a, b}, since clang 14 has no parenthesised ones of aggregates.
#define LichenTilingMaterial(...)                                                                  \
  LichenTilingMaterial { __VA_ARGS__ }
#define LichenTextonMaterial(...)                                                                  \
  LichenTextonMaterial { __VA_ARGS__ }
#define LichenTextonNoise(...)                                                                     \
  LichenTextonNoise { __VA_ARGS__ }
#define LichenCosinesMaterial(...)                                                                 \
  LichenCosinesMaterial { __VA_ARGS__ }
#define LichenCosinesNoise(...)                                                                    \
  LichenCosinesNoise { __VA_ARGS__ }
#define LichenKernelsMaterial(...)                                                                 \
  LichenKernelsMaterial { __VA_ARGS__ }
#define LichenKernelsNoise(...)                                                                    \
  LichenKernelsNoise { __VA_ARGS__ }
#define LichenQuiltingNoise(...)                                                                   \
  LichenQuiltingNoise { __VA_ARGS__ }
#define LichenGaussian(...)                                                                        \
  LichenGaussian { __VA_ARGS__ }
#define LichenKernelRow(...)                                                                       \
  LichenKernelRow { __VA_ARGS__ }
#define LichenKernelColors(...)                                                                    \
  LichenKernelColors { __VA_ARGS__ }
#define LichenPattern(...)                                                                         \
  LichenPattern { __VA_ARGS__ }
#define LichenPlanePoint(...)                                                                      \
  LichenPlanePoint { __VA_ARGS__ }
#define LichenRetained(...)                                                                        \
  LichenRetained { __VA_ARGS__ }
#define LichenSolidFootprint(...)                                                                  \
  LichenSolidFootprint { __VA_ARGS__ }
#define LichenSolidSum(...)                                                                        \
  LichenSolidSum { __VA_ARGS__ }
#define LichenSolidKernelSums(...)                                                                 \
  LichenSolidKernelSums { __VA_ARGS__ }
#define LichenLayerSum(...)                                                                        \
  LichenLayerSum { __VA_ARGS__ }

// Swizzles.
#define xy xy()
#define yx yx()
#define xz xz()
#define yw yw()
#define zw zw()
#define xyz xyz()
#define yzz yzz()
#define rg rg()
#define rgb rgb()

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wundef"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wkeyword-macro"
#endif
namespace lichen::glsl {
namespace { // each method's file has its own

#define float Float
#define int Int
#define bool Truth
struct ShaderLibrary {
#include "interface/structs.glsl"

  const RepeatingImage* cells = nullptr;      // of quilting
  const std::uint32_t* tileOffsets = nullptr; // LICHEN_MAX_OFFSETS of them
  Truth nearestTableLevel = false;

#include "library.glsl"
#ifndef LICHEN_WIDE // it indexes vectors
#include "noise/layers.glsl"
#endif
};
#undef float
#undef int
#undef bool

} // namespace
} // namespace lichen::glsl
#pragma GCC diagnostic pop

#undef xy
#undef yx
#undef xz
#undef yw
#undef zw
#undef xyz
#undef yzz
#undef rg
#undef rgb
