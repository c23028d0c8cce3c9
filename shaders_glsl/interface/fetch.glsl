// SPDX-License-Identifier: MIT
// All fetches of the library. By default images are combined samplers; a host that keeps images and
// samplers apart, or in arrays, defines these macros before it includes anything, all of them.
// docs/integration.md has both.
#ifndef LICHEN_FETCH_GLSL
#define LICHEN_FETCH_GLSL

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
// The red of four texels around texture coordinates, in textureGather's order.
#if defined(GL_ES) && __VERSION__ < 310
#define LICHEN_GATHER_2D(image, uv) lichenGather(image, uv)
/// textureGather of red, which GLSL ES 3.00 lacks.
vec4 lichenGather(sampler2D image, vec2 uv) {
  vec2 texel = 1.0 / vec2(textureSize(image, 0));
  vec2 near = (floor(uv / texel - 0.5) + 0.5) * texel;
  vec2 far = near + texel;
  return vec4(textureLod(image, vec2(near.x, far.y), 0.0).r, textureLod(image, far, 0.0).r,
              textureLod(image, vec2(far.x, near.y), 0.0).r, textureLod(image, near, 0.0).r);
}
#else
#define LICHEN_GATHER_2D(image, uv) textureGather(image, uv, 0)
#endif
#endif

// Quilting, whose cells all maps share, also needs LICHEN_SAMPLE_CELLS(uv, level), a vec4 of the
// noise's image of cells, and LICHEN_TILE_OFFSET(index), a uint of the offsets in its block.

#endif
