// SPDX-License-Identifier: MIT
// The library's files, each after those that it uses. lichen.glsl includes this for shaders, and
// analysis/evaluation/shader_library.h for C++, which compiles the same functions.
#include "interface/fetch.glsl"
#include "noise/switches.glsl"
#include "noise/method_parts.glsl"
#include "noise/decode.glsl"
#include "noise/hash.glsl"
#include "noise/lattice.glsl"
#include "noise/tile_frame.glsl"
#include "noise/footprint_level.glsl"
#include "noise/wave.glsl"
#include "noise/solid_footprint.glsl"

#include "noise/tiling.glsl"

#include "noise/surface_cubes.glsl"
#include "noise/impacts.glsl"
#include "noise/texton_mix.glsl"
#include "noise/texton.glsl"

#include "noise/cosine_vertices.glsl"
#include "noise/structure.glsl"
#include "noise/local_random_phase.glsl"
#include "noise/solid_vertices.glsl"
#include "noise/solid_cosines.glsl"

#include "noise/kernels.glsl"
#include "noise/kernel_pattern.glsl"
#include "noise/multiple_kernels.glsl"
#include "noise/solid_kernels.glsl"
#include "noise/surface_kernels.glsl"

#include "noise/quilting.glsl"

#include "noise/noise.glsl"
#include "noise/triplanar.glsl"
#include "noise/shading_point.glsl"
#include "mapping/solid.glsl"
#include "mapping/surface.glsl"
#include "mapping/triplanar.glsl"
#include "mapping/uv.glsl"
