// SPDX-License-Identifier: MIT
// The images of layers as numbers: slots (layerSlot() in bundle/), and from LICHEN_FIRST_INDEX on
// the index maps. Included by lichen.glsl in place of the fetches of single images.

#define LICHEN_FIRST_INDEX 6

#define LICHEN_DECLARE_INDEX(node)                                                                 \
  layout(LICHEN_BINDING(LICHEN_BINDING_INDEX(node))) uniform texture2D lichenIndex##node
LICHEN_DECLARE_INDEX(0);
LICHEN_DECLARE_INDEX(1);
LICHEN_DECLARE_INDEX(2);

// Sets `texel` to FETCH(name) where the image is this one.
#define LICHEN_FROM_SLOT(slot, FETCH, name)                                                        \
  if (image == slot)                                                                               \
    texel = FETCH(name);
#define LICHEN_FROM_SLOTS(FETCH, prefix)                                                           \
  LICHEN_FROM_SLOT(0, FETCH, prefix##0)                                                            \
  LICHEN_FROM_SLOT(1, FETCH, prefix##1)                                                            \
  LICHEN_FROM_SLOT(2, FETCH, prefix##2)                                                            \
  LICHEN_FROM_SLOT(3, FETCH, prefix##3)                                                            \
  LICHEN_FROM_SLOT(4, FETCH, prefix##4)                                                            \
  LICHEN_FROM_SLOT(5, FETCH, prefix##5)
#define LICHEN_FROM_INDEX(node, FETCH, name)                                                       \
  if (node < LICHEN_LAYERS - 1 && image == LICHEN_FIRST_INDEX + node)                              \
    texel = FETCH(name);
#define LICHEN_FROM_IMAGES(FETCH)                                                                  \
  LICHEN_FROM_SLOTS(FETCH, lichenImage)                                                            \
  LICHEN_FROM_INDEX(0, FETCH, lichenIndex0)                                                        \
  LICHEN_FROM_INDEX(1, FETCH, lichenIndex1)                                                        \
  LICHEN_FROM_INDEX(2, FETCH, lichenIndex2)

#define LICHEN_SAMPLE_LEVEL(name) textureLod(sampler2D(name, lichenImageSampler), uv, level)
vec4 lichenSampleLayer(int image, vec2 uv, float level) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_IMAGES(LICHEN_SAMPLE_LEVEL)
  return texel;
}

#define LICHEN_SAMPLE_GRAD(name) textureGrad(sampler2D(name, lichenImageSampler), uv, uvX, uvY)
vec4 lichenSampleLayerGrad(int image, vec2 uv, vec2 uvX, vec2 uvY) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_IMAGES(LICHEN_SAMPLE_GRAD)
  return texel;
}

// Texel by texel: of cosines and kernels.
#define LICHEN_FETCH_TEXEL(name) texelFetch(sampler2D(name, lichenImageSampler), at, 0)
vec4 lichenFetchLayer(int image, ivec2 at) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_IMAGES(LICHEN_FETCH_TEXEL)
  return texel;
}

#define LICHEN_SAMPLE_TABLE(name) textureLod(sampler3D(name, lichenTableSampler), uvw, level)
vec4 lichenSampleLayerTable(int image, vec3 uvw, float level) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_SLOTS(LICHEN_SAMPLE_TABLE, lichenTable)
  return texel;
}

#define LICHEN_IMAGE_2D int
#define LICHEN_IMAGE_3D int
#define LICHEN_SAMPLE_2D(image, uv, level) lichenSampleLayer(image, uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY) lichenSampleLayerGrad(image, uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level) lichenSampleLayerTable(image, uvw, level)
#define LICHEN_FETCH_2D(image, texel) lichenFetchLayer(image, texel)
