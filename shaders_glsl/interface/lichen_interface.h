// SPDX-License-Identifier: MIT
// Limits and binding numbers shared by C, C++ and GLSL, and the structs of the latter two.
#ifndef LICHEN_INTERFACE_H
#define LICHEN_INTERFACE_H

// The version of the structs, limits and bindings below. lichenParseBundle refuses a host whose
// SPIR-V was compiled with another (LichenParseInfo::interfaceVersion).
#define LICHEN_INTERFACE_VERSION 1

// Maps of one noise, one for each role.
#define LICHEN_MAX_MAPS 6
// Noises of one layered noise, and the index maps that choose between them.
#define LICHEN_MAX_LAYERS 4
#define LICHEN_MAX_LAYER_NODES 3
#define LICHEN_MAX_MIPS 16

// Bits of LICHEN_FEATURES, beside bit m for the method m: what some noise or material has.
#define LICHEN_FEATURE_UV 0x20u // a mapping, as the next three
#define LICHEN_FEATURE_TRIPLANAR 0x40u
#define LICHEN_FEATURE_SURFACE 0x80u
#define LICHEN_FEATURE_SOLID 0x100u
#define LICHEN_FEATURE_TABLES 0x200u          // a map with an inverse table
#define LICHEN_FEATURE_GAUSSIAN_ONLY 0x400u   // a map without one
#define LICHEN_FEATURE_VALUES_ABOVE_ONE 0x800u // the encoding log2
#define LICHEN_FEATURE_PERIOD 0x1000u          // a periodic lattice
#define LICHEN_FEATURE_GRAIN 0x2000u           // of tiling: a lattice stretched along a grain,
#define LICHEN_FEATURE_BLEND_SHARPNESS 0x4000u // an exponent of the weights, rotated tiles
#define LICHEN_FEATURE_TILE_ROTATION 0x8000u
#define LICHEN_FEATURE_CUBIC_TEXTONS 0x10000u // textons of order 3, of order 0, mixes of textons
#define LICHEN_FEATURE_NEAREST_TEXTONS 0x20000u
#define LICHEN_FEATURE_MIXES 0x40000u
#define LICHEN_FEATURE_POISSON_POINTS 0x80000u // of textons: a Poisson process
#define LICHEN_FEATURE_STRUCTURES 0x100000u    // of local random phase
#define LICHEN_FEATURE_RING_KERNELS 0x200000u  // of multiple kernels
#define LICHEN_FEATURE_SQUARE_KERNELS 0x400000u
#define LICHEN_FEATURE_PATTERNS 0x800000u

// LichenMap::encoding, of the stored values.
#define LICHEN_ENCODING_ROOT 0 // square roots of light
#define LICHEN_ENCODING_LINEAR 1
#define LICHEN_ENCODING_SLOPE 2
#define LICHEN_ENCODING_LOG2 3
#define LICHEN_ENCODING_INDEX 4 // of index maps: Gaussian values, which are not decoded

// LichenMap::decoding, from the Gaussian to the decoded value.
#define LICHEN_DECODING_JOINT 0    // one table over all dimensions
#define LICHEN_DECODING_GAUSSIAN 1 // an affine map to the stored value, no table
#define LICHEN_DECODING_NONE 2     // values are as decoded, less their mean, plus 1/2

// LichenNoise::method.
#define LICHEN_METHOD_TILING 0
#define LICHEN_METHOD_TEXTON 1
#define LICHEN_METHOD_LOCAL_RANDOM_PHASE 2
#define LICHEN_METHOD_MULTIPLE_KERNELS 3
#define LICHEN_METHOD_QUILTING 4

// The longest list of offsets of a quilting noise.
#define LICHEN_MAX_OFFSETS 24

// LichenTilingNoise::grain and LichenQuiltingNoise::grain.
#define LICHEN_GRAIN_NONE 0
#define LICHEN_GRAIN_X 1
#define LICHEN_GRAIN_Y 2

// Octaves of the lattice of local random-phase noise.
#define LICHEN_MAX_OCTAVES 12

// LichenKernelsNoise::window.
#define LICHEN_WINDOW_GABOR 0
#define LICHEN_WINDOW_SINC 1
#define LICHEN_WINDOW_GAUSSIAN_SINC 2
// Tiles along each axis that hold whole cells of all kernels.
#define LICHEN_KERNEL_TILES 8

// LichenTextonMaterial::pointProcess.
#define LICHEN_POINTS_STRATIFIED 0 // one impact in each cell
#define LICHEN_POINTS_POISSON 1    // a Poisson number of impacts, 1 in the mean

// Rows (z) of a mix's table, whose columns (x) are its steps.
#define LICHEN_MIX_MEAN 0      // the mean of stored values, less the first step's mean
#define LICHEN_MIX_DEVIATION 1 // times six, over what a texel is multiplied with
#define LICHEN_MIX_RETAINED 2  // and up: amplitudes that mip 0, 1, ... keeps of each channel
#define LICHEN_MIX_ROWS 18     // LICHEN_MIX_RETAINED + LICHEN_MAX_MIPS

// Maps by role. Where a noise has no map of a role, a placeholder is bound (LICHEN_HAS).
#define LICHEN_BASE_COLOR 0
#define LICHEN_NORMAL 1
#define LICHEN_OCCLUSION_ROUGHNESS_METALLIC 2
#define LICHEN_EMISSIVE 3
#define LICHEN_HEIGHT 4
#define LICHEN_OPACITY 5

// Binding numbers, relative to the host's first binding: two uniform blocks, the samplers of all
// images and of all tables, and for each role its image (Gaussian image or texton) and its table.
#define LICHEN_BINDING_NOISE 0
#define LICHEN_BINDING_MATERIAL 1
#define LICHEN_BINDING_IMAGE_SAMPLER 2
#define LICHEN_BINDING_TABLE_SAMPLER 3
#define LICHEN_BINDING_IMAGE(role) (4 + (role))
#define LICHEN_BINDING_TABLE(role) (10 + (role))
#define LICHEN_BINDING_CELLS 16 // the image of a quilting noise's cells
#define LICHEN_BINDING_COUNT 17
// Where shaders know layers (LICHEN_LAYERS above 1), and so no quilting: the image of each node's
// index map.
#define LICHEN_BINDING_INDEX(node) (16 + (node))
#define LICHEN_LAYERED_BINDING_COUNT 19

// C hosts have the numbers above, and the sizes of the blocks in lichen.h.
#ifdef __cplusplus
#include <cstdint>
namespace lichen::shader {
using uint = std::uint32_t;
struct vec4 {
  float x, y, z, w;
};
struct uvec4 {
  uint x, y, z, w;
};
#include "structs.glsl"
} // namespace lichen::shader
#elif !(defined(__STDC__) || defined(_MSC_VER))
#include "structs.glsl"
// Parameters that a function writes.
#define LICHEN_OUT(Type) out Type
#define LICHEN_INOUT(Type) inout Type
#endif

#endif
