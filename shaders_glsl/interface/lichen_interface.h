// SPDX-License-Identifier: MIT
// Limits and binding numbers shared by C, C++ and GLSL, and structs of the latter two. Only vec4,
// uvec4, ivec4, mat4 and groups of four scalars, so that std140, std430 and C++ agree without
// padding.
#ifndef LICHEN_INTERFACE_H
#define LICHEN_INTERFACE_H

// Of the structs, limits and bindings below. lichenParseBundle refuses a host whose SPIR-V was
// compiled with another (LichenParseInfo::interfaceVersion).
#define LICHEN_INTERFACE_VERSION 1

// Maps of one noise, one for each role.
#define LICHEN_MAX_MAPS 6
// Noises of one layered noise, and the index maps that choose between them.
#define LICHEN_MAX_LAYERS 4
#define LICHEN_MAX_LAYER_NODES 3
#define LICHEN_MAX_MIPS 16

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

// Of the list of a quilting noise.
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
#define LICHEN_MIX_MEAN 0      // of stored values, less that of the first step
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
#if defined(__cplusplus) || !(defined(__STDC__) || defined(_MSC_VER))

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
#endif

/// How one material uses one noise. May change every frame. 128 bytes.
struct LichenMaterial {
  // Tile coordinate = offset + (uvToTileXX uvToTileXY; uvToTileYX uvToTileYY) uv. [tiles]
  float uvToTileXX, uvToTileXY, uvToTileYX, uvToTileYY;
  float offsetX, offsetY;
  float contrast;       // [0, 4] scale of the Gaussian value about its mean
  float planeSharpness; // [1, 64] exponent of the planes' weights; 0 but for triplanar noise
  // Cells per tile: of the lattice of tiling, of the first octave of cosines, or of the impacts of
  // textons. Cells of surface and of solid noise are cubes, columnsPerTile of them to the width of a
  // tile.
  float columnsPerTile, rowsPerTile;
  int cellI, cellJ;                 // the cell of the tile origin, modulo 2^32
  float periodTilesX, periodTilesY; // the period in tiles; unused when infinite
  int periodColumns, periodRows;    // 0, 0 when the cells do not repeat; lattices: even rows
  uint seedWord;          // latticeSeed(seed, plane): 0, of surface noise 3, of solid noise 4
  uint seed;                        // as the material gives it
  float maxAnisotropy;    // [1, 64] of the images' sampler; read with LICHEN_ANISOTROPIC 1
  uint noise;             // index of the noise in its bundle
  uvec4 own0, own1, own2; // of the method: Lichen...Material below
};

/// A plane of triplanar noise, which has a lattice of its own, at the host's tile origin in space.
/// That of the plane that looks along x is the material's.
struct LichenPlane {
  int cellI, cellJ;
  float offsetX, offsetY;               // [tiles]
  uint seedWord;                        // latticeSeed(seed, plane)
  uint reserved0, reserved1, reserved2; // 0: to a multiple of 16 bytes
};

/// A material with its planes. 192 bytes.
struct LichenTriplanarMaterial {
  LichenMaterial material;
  LichenPlane planeY, planeZ; // looking along y, z
};

/// What only tiling has of a material: own0 to own2.
struct LichenTilingMaterial {
  float blendSharpness; // [0.25, 16] exponent of the blend weights
  uint tileRotation;    // angles that tiles take: 2 or, of square tiles, 4; 0 and 1: none
};

/// What only textons have of a material: own0 to own2.
struct LichenTextonMaterial {
  float amplitude;         // [texels] of one impact; of surface noise, of one in the tangent plane
  uint pointProcess;       // LICHEN_POINTS_*
  float surfaceCubeTexels; // side of the cubes of surface noise, 0 of noise in a plane
  int cellK;               // of surface noise: the third of cellI and cellJ
  // Of a mix, weight = mixWeight + mixPerU u + mixPerV v: of a constant or a direction, 0 where a
  // mask or vertex colours say it.
  float mixWeight, mixPerU, mixPerV;
};

/// What only local random-phase noise has of a material: own0 to own2.
struct LichenCosinesMaterial {
  // Octave of the lattice of columnsPerTile and rowsPerTile, which octaves below it share: 0 unless
  // the lattice is periodic and its period short.
  int firstOctave;
  uint guided; // 1: tiles of the structure have the offsets of its list, if there is one
  // Of solid noise: the third of cellI and cellJ and of offsetX and offsetY [tile widths].
  uint isSolid; // 0 of noise in a plane
  int cellK;
  float offsetZ;
};

/// What only multiple-kernels noise has of a material: own0 to own2.
struct LichenKernelsMaterial {
  uint isSolid, isSurface; // 0 of noise in a plane
  // Otherwise the third of cellI and cellJ and of offsetX and offsetY [tile widths].
  int cellK;
  float offsetZ;
};

/// What only tiling has of a noise: own0 and own1.
struct LichenTilingNoise {
  uint grain; // LICHEN_GRAIN_*; shaders find it in columnsPerTile and rowsPerTile
};

/// What only textons have of a noise: own0 and own1.
struct LichenTextonNoise {
  int coefficientsX, coefficientsY; // in the top left corner of a frame
  int frameX, frameY;               // [texels] the rest of which is zero
  uint order;                       // of the B-spline between coefficients: 0, 1 or 3
  uint mipCount;                    // of the textons' images
  uint steps;                       // frames of an image, one above the other
  uint reserved0;                   // 0: to a multiple of 16 bytes
};

/// What only local random-phase noise has of a noise: own0 and own1.
struct LichenCosinesNoise {
  uint octaves0, octaves1, octaves2; // the number of octave k's cosines: byte k of twelve
  uint variants;                     // vectors of a cosine, a power of two
  uint columns, rows;                // of octave 0 in eight tiles
  uint cosines;                      // of all octaves; even, as is the number of each
  // log2 of columns and of rows (4 bits each), offsets (8), turbulence in 65,535ths (16); 0: no
  // structure.
  uint structure;
};

/// What only multiple-kernels noise has of a noise: own0 and own1.
struct LichenKernelsNoise {
  uint kernels;   // the first rows of an image
  uint rings;     // the last so many of them
  uint window;    // LICHEN_WINDOW_*
  uint cosines;   // of the pattern in the rows below
};

/// What only quilting has of a noise: own0 and own1.
struct LichenQuiltingNoise {
  float reach;           // [tiles] of the image of cells
  float correlation;     // [0, 1] of two tiles close up
  float cellLevelOffset; // as levelOffset of a map, of the image of cells
  uint offsets;          // of the list in the noise's block, 0: none
  uint grain;            // LICHEN_GRAIN_*; shaders find it in columnsPerTile and rowsPerTile
};

/// What all maps of a noise share. Fixed by the bundle.
struct LichenNoise {
  float tileTexelsX, tileTexelsY; // of the exemplar: of tiling, of its widest and its highest map
  float tileAspect;               // width over height of a tile in space
  float tileSizeMetres;           // width of a tile
  uint method;                    // LICHEN_METHOD_*
  uint roles;                     // bit r: the map of role r is there
  float offsetStepX, offsetStepY; // of tiling and quilting: between neighbouring offsets of a tile [tiles]
  uvec4 own0, own1; // of the method: Lichen...Noise above
};

/// The constants of one map of a noise. Fixed by the bundle.
struct LichenMap {
  // Of LICHEN_OCCLUSION_ROUGHNESS_METALLIC: which of the three the value's channels are, in this
  // order. Bit 0 occlusion, 1 roughness, 2 metallic.
  uint ormChannels;
  uint reserved0; // 0
  uint dimensions;                 // D of the Gaussian image, channels of a texton, 1 to 3
  uint mipCount;                   // [1, LICHEN_MAX_MIPS]
  float levelOffset;               // of tiling, quilting: half of log2 of its texels over a tile's
  float interpolationLoss;         // of tiling: share of the variance that fetches of level 0 lose
  uint encoding;                   // LICHEN_ENCODING_*
  uint decoding;                   // LICHEN_DECODING_*
  vec4 mean; // of the decoded values; w is 1. Slopes: z is the variance of a slope
  // Of textons: amplitude that mip m keeps of channel 0, 1, 2, sqrt(1 - lost variance): unorm byte
  // m of sixteen. A channel that is absent or does not vary keeps nothing. Of a structure, in
  // mipRetained0: the deviation of level m over that of the noise.
  uvec4 mipRetained0, mipRetained1, mipRetained2;
  // The affine map of Gaussian decoding: channel c is dot(row c, (value, 1)), value the Gaussian
  // value less its mean. Lower triangular: row0.yz and row1.z are 0. With a table, of slopes of
  // methods that have solids: the linear part of that, not triangular.
  vec4 row0, row1, row2;
  // Of textons: Gaussian value = 1/2 + sumFactor sum, 1 but inside a mix. Of a structure: what its
  // integers are multiplied with. w unused.
  vec4 sumFactor;
};

/// How a layered noise chooses between its layers: a binary tree of nodes, each with an index map.
struct LichenLayers {
  uint count; // of layers; 0 of a noise that is not layered
  uint nodes; // count - 1
  uint reserved0, reserved1; // 0
  // Of the node x, y, z: where its upper side begins, and the deviation of the transition, both in
  // deviations of the index map.
  vec4 threshold, softness;
  // Of the layer x, y, z, w: the side on which it lies of node n, bits 2n and 2n + 1: 1 below,
  // 2 above, 0 neither.
  uvec4 sides;
};

/// The block of a noise. 2,048 bytes, fixed by the bundle. The members after `maps` are 0 but for
/// layered noises, and for the offsets of quilting.
struct LichenNoiseConstants {
  LichenNoise noise;
  LichenMap maps[LICHEN_MAX_MAPS]; // by role; of layered noises by slot (mapping/layered.glsl)
  LichenLayers layers;
  LichenNoise layerNoises[LICHEN_MAX_LAYERS - 1]; // `noise` is the first layer
  LichenNoise indexNoises[LICHEN_MAX_LAYER_NODES];
  LichenMap indexMaps[LICHEN_MAX_LAYER_NODES];
  // Of quilting: where tiles are taken from [65,536ths of a tile], x in the lower 16 bits. 24 words.
  uvec4 offsets[LICHEN_MAX_OFFSETS / 4];
};

/// A material of a layered noise. 1,344 bytes.
struct LichenLayeredMaterial {
  LichenTriplanarMaterial first; // of the first layer
  LichenTriplanarMaterial layers[LICHEN_MAX_LAYERS - 1];
  LichenTriplanarMaterial indices[LICHEN_MAX_LAYER_NODES];
};

#ifdef __cplusplus
} // namespace lichen::shader
#endif

#endif

#endif
