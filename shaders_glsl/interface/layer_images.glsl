// SPDX-License-Identifier: MIT
// The images of layers as numbers: slots (layerSlot() in bundle/), and from LICHEN_FIRST_INDEX on
// the index maps. Included by lichen.glsl in place of the fetches of single images.
#ifndef LICHEN_LAYER_IMAGES_GLSL
#define LICHEN_LAYER_IMAGES_GLSL

#include "../interface/lichen_interface.h"
#include "../noise/method_choice.glsl"

#define LICHEN_FIRST_INDEX 6

// Bit m: some layer has the method m, of LICHEN_USED_METHODS; index maps have multiple kernels. A
// literal, or the host's specialization constant.
#ifndef LICHEN_LAYER_METHODS
#define LICHEN_LAYER_METHODS LICHEN_USED_METHODS
#endif
// Bit s: some layer has an image in slot s. A literal, or the host's specialization constant.
#ifndef LICHEN_LAYER_SLOTS
#define LICHEN_LAYER_SLOTS 63
#endif

#define LICHEN_DECLARE_SLOT(slot)                                                                  \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_IMAGE(slot))            \
      uniform texture2D lichenImage##slot;                                                         \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_TABLE(slot))            \
      uniform texture3D lichenTable##slot
#define LICHEN_DECLARE_INDEX(node)                                                                 \
  layout(set = LICHEN_SET, binding = LICHEN_FIRST_BINDING + LICHEN_BINDING_INDEX(node))            \
      uniform texture2D lichenIndex##node
LICHEN_DECLARE_SLOT(0);
LICHEN_DECLARE_SLOT(1);
LICHEN_DECLARE_SLOT(2);
LICHEN_DECLARE_SLOT(3);
LICHEN_DECLARE_SLOT(4);
LICHEN_DECLARE_SLOT(5);
LICHEN_DECLARE_INDEX(0);
LICHEN_DECLARE_INDEX(1);
LICHEN_DECLARE_INDEX(2);

// Sets `texel` to FETCH(name) where the image is this one.
#define LICHEN_FROM_SLOT(slot, FETCH, name)                                                        \
  if (((int(LICHEN_LAYER_SLOTS) >> slot) & 1) != 0 && image == slot)                               \
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

#define LICHEN_SAMPLE_LEVEL(name) textureLod(sampler2D(name, lichenImageSampler), uv, level)
vec4 lichenSampleLayer(int image, vec2 uv, float level) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_SLOTS(LICHEN_SAMPLE_LEVEL, lichenImage)
  return texel;
}

#define LICHEN_SAMPLE_GRAD(name) textureGrad(sampler2D(name, lichenImageSampler), uv, uvX, uvY)
vec4 lichenSampleLayerGrad(int image, vec2 uv, vec2 uvX, vec2 uvY) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_SLOTS(LICHEN_SAMPLE_GRAD, lichenImage)
  return texel;
}

// Texel by texel: of index maps, and of layers with cosines or kernels.
#define LICHEN_FETCH_TEXEL(name) texelFetch(sampler2D(name, lichenImageSampler), at, 0)
vec4 lichenFetchLayer(int image, ivec2 at) {
  vec4 texel = vec4(0.0);
  if ((int(LICHEN_LAYER_METHODS) & 12) != 0) {
    LICHEN_FROM_SLOTS(LICHEN_FETCH_TEXEL, lichenImage)
  }
  LICHEN_FROM_INDEX(0, LICHEN_FETCH_TEXEL, lichenIndex0)
  LICHEN_FROM_INDEX(1, LICHEN_FETCH_TEXEL, lichenIndex1)
  LICHEN_FROM_INDEX(2, LICHEN_FETCH_TEXEL, lichenIndex2)
  return texel;
}

#define LICHEN_GATHER_RED(name) textureGather(sampler2D(name, lichenImageSampler), uv, 0)
vec4 lichenGatherLayer(int image, vec2 uv) {
  vec4 texel = vec4(0.0);
  LICHEN_FROM_SLOTS(LICHEN_GATHER_RED, lichenImage)
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
#define LICHEN_GATHER_2D(image, uv) lichenGatherLayer(image, uv)

#endif
