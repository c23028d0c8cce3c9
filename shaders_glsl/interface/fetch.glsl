// SPDX-License-Identifier: MIT
// All fetches of the library. By default images are combined samplers; a host that keeps images and
// samplers apart, or in arrays, defines these macros before it includes anything, all of them.
// docs/integration.md has both.

#ifndef LICHEN_IMAGE_2D
// Types of what functions are handed: Gaussian images, textons and cosines, and tables.
#define LICHEN_IMAGE_2D sampler2D
#define LICHEN_IMAGE_3D sampler3D
// vec4 at texture coordinates and a mip level, or with derivatives of the coordinates.
#define LICHEN_SAMPLE_2D(image, uv, level) textureLod(image, uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY) textureGrad(image, uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level) textureLod(image, uvw, level)
// vec4 of one texel of level 0, unfiltered.
#define LICHEN_FETCH_2D(image, texel) texelFetch(image, texel, 0)
#endif

// Quilting, whose cells all maps share, also needs LICHEN_SAMPLE_CELLS(uv, level), a vec4 of the
// noise's image of cells, and LICHEN_TILE_OFFSET(index), a uint of the offsets in its block.
