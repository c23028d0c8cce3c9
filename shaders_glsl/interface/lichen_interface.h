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

// Binding numbers, relative to the host's first binding: the uniform block, then for each map of
// the noise, in order, its Gaussian image and its inverse table.
#define LICHEN_BINDING_NOISE 0
#define LICHEN_BINDING_GAUSSIAN(map) (1 + 2 * (map))
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

/// How one material uses one noise. May change every frame.
struct LichenNoise {
  // Tile coordinate = offset + (uvToTileXX uvToTileXY; uvToTileYX uvToTileYY) uv. [tiles]
  float uvToTileXX, uvToTileXY, uvToTileYX, uvToTileYY;
  float offsetX, offsetY;
  float blendSharpness; // [0.25, 16] exponent of the blend weights
  float contrast;       // [0, 4] scale of the Gaussian value about its mean
  // The lattice: cells per tile, and where the host's integer tile origin lies inside its cell.
  float columnsPerTile, rowsPerTile;
  float fractionI, fractionJ;       // [0, 1)
  int cellI, cellJ;                 // the cell of the tile origin, modulo 2^32
  int periodColumns, periodRows;    // 0, 0 when the lattice is infinite; rows even
  float periodTilesX, periodTilesY; // the period in tiles; unused when infinite
  float offsetStepX, offsetStepY;   // [tiles] between neighbouring offsets of a tile
  uint offsetCountX, offsetCountY;  // of different offsets on each axis, [1, 2^14]
  uint seedWord;                    // latticeSeed(seed, plane 0)
  uint seed;                        // as the material gives it; triplanar derives its planes
  float maxAnisotropy; // [1, 64] of the Gaussian images' sampler; read with LICHEN_ANISOTROPIC 1
  float tileSizeMetres;
  float reserved0, reserved1; // 0, as is reserved2: they bring the block to 512 bytes
  vec4 reserved2;
};

/// The constants of one map of a noise. Fixed by the bundle.
struct LichenMap {
  float widthTexels, heightTexels; // of the Gaussian image's level 0
  uint dimensions;                 // D of the Gaussian image, 1 to 3
  uint mipCount;                   // [1, LICHEN_MAX_MIPS]
  uint alignedMips;        // how many of the first mips' texels all taps meet at the same place
  uint tableLevels;        // L, the slabs of the inverse table; 0 without a table
  uint padding0, padding1; // to a multiple of 16 bytes
  vec4 mean;               // of the decoded values; w is 1
  uvec4 mipKept; // amplitude that mip m keeps, sqrt(1 - lost variance): unorm byte m of sixteen
};

/// The uniform block.
struct LichenUniforms {
  LichenNoise noise;
  LichenMap maps[LICHEN_MAX_MAPS];
};

#ifdef __cplusplus
} // namespace lichen::shader
#endif

#endif
