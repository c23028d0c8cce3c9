// SPDX-License-Identifier: MIT
// The structs of uniform blocks, in GLSL and in C++. Only vec4, uvec4, ivec4, mat4 and groups of
// four scalars, so that std140, std430 and C++ agree without padding. Included by lichen_interface.h;
// without a guard, since C++ includes it again to compile the shader library itself.

/// How one material uses one noise. May change every frame. 128 bytes.
struct LichenMaterial {
  // Tile coordinate = offset + (uvToTileXX uvToTileXY; uvToTileYX uvToTileYY) uv. [tiles]
  float uvToTileXX, uvToTileXY, uvToTileYX, uvToTileYY;
  float offsetX, offsetY;
  float contrast;       // [0, 4] scale of the Gaussian value about its mean
  float planeSharpness; // [1, 64] exponent of the planes' weights, of triplanar noise
  // Cells per tile: of the lattice of tiling, of the first octave of cosines, or of the impacts of
  // textons. Cells of surface and of solid noise are cubes, columnsPerTile of them to the width of a
  // tile.
  float columnsPerTile, rowsPerTile;
  int cellI, cellJ;                 // the cell of the tile origin, modulo 2^32
  float periodTilesX, periodTilesY; // the period in tiles; unused when infinite
  int periodColumns, periodRows;    // 0, 0 when the cells do not repeat; lattices: even rows
  uint seedWord;          // latticeSeed(seed, plane): 0, of surface noise 3, of solid noise 4
  uint mapping;           // LICHEN_FEATURE_UV, _TRIPLANAR, _SURFACE or _SOLID
  float maxAnisotropy;    // [1, 64] of the images' sampler; read with LICHEN_ANISOTROPIC 1
  uint noise;             // index of the noise in its bundle
  uvec4 own0, own1, own2; // of the method: Lichen...Material below
};

/// A plane of triplanar noise, which has a lattice of its own, at the host's tile origin in space.
/// The material itself holds the plane that looks along x.
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
  uint tileRotation;    // angles that tiles take: 2, or 4 where they are square; 0 and 1: none
};

/// What only textons have of a material: own0 to own2.
struct LichenTextonMaterial {
  float amplitude;         // [texels] of one impact; of surface noise, of one in the tangent plane
  uint pointProcess;       // LICHEN_POINTS_*
  float surfaceCubeTexels; // side of the cubes of surface noise
  int cellK;               // of surface noise: the third of cellI and cellJ
  // A mix has the weight mixWeight + mixPerU u + mixPerV v if it is a constant or goes along a
  // direction; all three are 0 if a mask or vertex colours say it.
  float mixWeight, mixPerU, mixPerV;
};

/// What only local random-phase noise has of a material: own0 to own2.
struct LichenCosinesMaterial {
  // Octave of the lattice of columnsPerTile and rowsPerTile, which octaves below it share: 0 unless
  // the lattice is periodic and its period short.
  int firstOctave;
  uint guided; // 1: tiles of the structure have the offsets of its list, if there is one
  // In solids: what cellI, cellJ and offsetX, offsetY are along z [tile widths].
  int cellK;
  float offsetZ;
};

/// What only multiple-kernels noise has of a material: own0 to own2.
struct LichenKernelsMaterial {
  // On surfaces and in solids: cellI and cellJ, offsetX and offsetY along z [tile widths].
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
  // LICHEN_OCCLUSION_ROUGHNESS_METALLIC: which of the three the value's channels are, in this
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
  // Textons: amplitude that mip m keeps of channel 0, 1, 2, sqrt(1 - lost variance): unorm byte m
  // of sixteen. A channel that is absent or does not vary keeps nothing. A structure, in mipRetained0:
  // the deviation of level m over the deviation of the noise.
  uvec4 mipRetained0, mipRetained1, mipRetained2;
  // The affine map of Gaussian decoding: channel c is dot(row c, (value, 1)), value the Gaussian
  // value less its mean. Lower triangular: row0.yz and row1.z are 0. Slopes with a table, in
  // methods that have solids: the linear part of the table, not triangular.
  vec4 row0, row1, row2;
  // Textons: Gaussian value = 1/2 + sumFactor sum, 1 but inside a mix. A structure: the factor on
  // its integers. w unused.
  vec4 sumFactor;
};

/// How a layered noise chooses between its layers: a binary tree of nodes, each with an index map.
struct LichenLayers {
  uint count; // of layers; 0 of a noise that is not layered
  uint nodes; // count - 1
  uint reserved0, reserved1; // 0
  // For node 0, 1, 2: where its upper side begins, and the deviation of the transition, both in
  // deviations of the index map.
  vec4 threshold, softness;
  // For layer 0 to 3: its side of node n in bits 2n and 2n + 1: 1 below, 2 above, 0 neither.
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
  // Quilting: where tiles are taken from [65,536ths of a tile], x in the lower 16 bits. 24 words.
  uvec4 offsets[LICHEN_MAX_OFFSETS / 4];
};

/// A material of a layered noise. 1,344 bytes.
struct LichenLayeredMaterial {
  LichenTriplanarMaterial first; // of the first layer
  LichenTriplanarMaterial layers[LICHEN_MAX_LAYERS - 1];
  LichenTriplanarMaterial indices[LICHEN_MAX_LAYER_NODES];
};
