// SPDX-License-Identifier: MIT
// Structs, limits and binding numbers shared by C++ and GLSL. Only vec4, uvec4, ivec4, mat4 and
// groups of four scalars, so that std140, std430 and C++ agree without padding.
#ifndef LICHEN_INTERFACE_H
#define LICHEN_INTERFACE_H

// Of the structs, limits and bindings below. lichenParseBundle refuses a host whose SPIR-V was
// compiled with another (LichenParseInfo::interfaceVersion).
#define LICHEN_INTERFACE_VERSION 1

// Maps of one noise: baseColor, normal, occlusionRoughnessMetallic, emissive, height, opacity.
#define LICHEN_MAX_MAPS 6
#define LICHEN_MAX_MIPS 16

// LichenMap::encoding, of the stored values.
#define LICHEN_ENCODING_ROOT 0 // square roots of light
#define LICHEN_ENCODING_LINEAR 1
#define LICHEN_ENCODING_SLOPE 2
#define LICHEN_ENCODING_LOG2 3

// LichenMap::decoding, from the Gaussian to the decoded value.
#define LICHEN_DECODING_JOINT 0    // one table over all dimensions
#define LICHEN_DECODING_GAUSSIAN 1 // an affine map to the stored value, no table

// LichenNoise::method.
#define LICHEN_METHOD_TILING 0
#define LICHEN_METHOD_TEXTON 1

// LichenTexton::pointProcess.
#define LICHEN_POINTS_STRATIFIED 0 // one impact in each cell
#define LICHEN_POINTS_POISSON 1    // a Poisson number of impacts, 1 in the mean

// Rows (z) of a mix's table, whose columns (x) are its steps.
#define LICHEN_MIX_MEAN 0      // of stored values, less that of the first step
#define LICHEN_MIX_DEVIATION 1 // times six, over what a texel is multiplied with
#define LICHEN_MIX_KEPT 2      // and up: amplitudes that mip 0, 1, ... keeps of each channel
#define LICHEN_MIX_ROWS 18     // LICHEN_MIX_KEPT + LICHEN_MAX_MIPS

// Binding numbers, relative to the host's first binding: the uniform block, then for each map of
// the noise, in order, its image (Gaussian image or texton) and its inverse table.
#define LICHEN_BINDING_NOISE 0
#define LICHEN_BINDING_IMAGE(map) (1 + 2 * (map))
#define LICHEN_BINDING_TABLE(map) (2 + 2 * (map))

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

/// A plane of triplanar noise, which has a lattice of its own: as LichenNoise has it for the plane
/// of texture coordinates, at the host's tile origin in space.
struct LichenPlane {
  int cellI, cellJ;
  float offsetX, offsetY; // [tiles]
  uint seedWord;          // latticeSeed(seed, plane)
  uint reserved0, reserved1, reserved2; // 0: to a multiple of 16 bytes
};

/// How one material uses one noise. May change every frame.
struct LichenNoise {
  // Tile coordinate = offset + (uvToTileXX uvToTileXY; uvToTileYX uvToTileYY) uv. [tiles]
  float uvToTileXX, uvToTileXY, uvToTileYX, uvToTileYY;
  float offsetX, offsetY;
  float blendSharpness; // [0.25, 16] exponent of the blend weights
  float contrast;       // [0, 4] scale of the Gaussian value about its mean
  // The lattice of tiling, or the grid of impacts of texton noise: cells per tile. Cells of surface
  // noise are cubes, columnsPerTile of them to the width of a tile.
  float columnsPerTile, rowsPerTile;
  int cellI, cellJ;                 // the cell of the tile origin, modulo 2^32
  int periodColumns, periodRows;    // 0, 0 when the lattice is infinite; rows of tiling even
  float periodTilesX, periodTilesY; // the period in tiles; unused when infinite
  float offsetStepX, offsetStepY;   // [tiles] between neighbouring offsets of a tile
  uint seedWord;                    // latticeSeed(seed, plane 0), of surface noise plane 3
  uint seed;                        // as the material gives it
  float maxAnisotropy; // [1, 64] of the images' sampler; read with LICHEN_ANISOTROPIC 1
  float tileSizeMetres;
  uint method;          // LICHEN_METHOD_*
  int cellK;            // of surface noise: the third of cellI and cellJ
  float planeSharpness; // [1, 64] exponent of the planes' weights; 0 but for triplanar noise
  float tileAspect;     // width over height of a tile in space
  float tileTexelsX, tileTexelsY; // of the widest and the highest map
  uint tileRotation; // [0, 65536] of tiling: steps of a turn that tiles lie in; 0 and 1: none
  uint reserved0, reserved1, reserved2; // 0: to a multiple of 16 bytes
  LichenPlane planeX, planeY, planeZ; // of triplanar noise: looking along x, y, z
};

/// The constants of one map of a noise. Fixed by the bundle.
struct LichenMap {
  float widthTexels, heightTexels; // of the image's level 0
  uint dimensions;                 // D of the Gaussian image, channels of a texton, 1 to 3
  uint mipCount;                   // [1, LICHEN_MAX_MIPS]
  float levelOffset; // of tiling: log2 of the map's width over that of the widest
  float interpolationLoss; // of tiling: share of the variance that fetches of level 0 lose
  uint encoding;    // LICHEN_ENCODING_*
  uint decoding;    // LICHEN_DECODING_*
  vec4 mean;        // of the decoded values; w is 1. Slopes: z is the variance of a slope
  // Of textons: amplitude that mip m keeps of channel 0, 1, 2, sqrt(1 - lost variance): unorm byte m
  // of sixteen. A channel that is absent or does not vary keeps nothing.
  uvec4 mipKept0, mipKept1, mipKept2;
  // The affine map of Gaussian decoding: channel c is dot(row c, (value, 1)), value the Gaussian
  // value less its mean. Lower triangular: row0.yz and row1.z are 0.
  vec4 row0, row1, row2;
  vec4 sumFactor; // of textons: Gaussian value = 1/2 + sumFactor sum, 1 but inside a mix; w unused
};

/// What the textons of all maps of a noise share; zeros for tiling.
struct LichenTexton {
  float texelsPerTileX, texelsPerTileY; // size of the exemplar
  int coefficientsX, coefficientsY;     // in the top left corner of a frame
  int frameX, frameY;                   // [texels] the rest of which is zero
  uint order;                           // of the B-spline between coefficients: 0, 1 or 3
  uint mipCount;                        // of the textons' images
  uint steps;                           // frames of an image, one above the other
  uint pointProcess;                    // LICHEN_POINTS_*
  float amplitude;         // [texels] of one impact; of surface noise, of one in the tangent plane
  float surfaceCubeTexels; // side of the cubes of surface noise, 0 of noise in a plane
  // Of a mix, weight = mixWeight + mixPerU u + mixPerV v: of a constant or a direction, 0 where a
  // mask or vertex colours say it.
  float mixWeight, mixPerU, mixPerV;
  float reserved0; // 0: to a multiple of 16 bytes
};

/// The uniform block.
struct LichenUniforms {
  LichenNoise noise;
  LichenMap maps[LICHEN_MAX_MAPS];
  LichenTexton texton;
  vec4 reserved[2]; // 0: to 1280 bytes
};

#ifdef __cplusplus
} // namespace lichen::shader
#endif

#endif
