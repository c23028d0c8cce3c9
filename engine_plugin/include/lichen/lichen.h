/* SPDX-License-Identifier: MIT
 *
 * Lichen's engine plugin, plan layer: a noise bundle in memory -> images, copies, samplers,
 * bindings and uniform bytes, as plain data. No Vulkan call, no Vulkan header, no thread, no
 * static state. Engines with their own render hardware interface need nothing else;
 * lichen_vulkan.h does the rest for those that hand over a VkDevice.
 *
 * Structs start with type, size and next. Set type and size (LICHEN_INIT does), leave the rest
 * zero for the defaults; next must be NULL. A struct smaller than the library's is an older
 * header's: what it lacks is zero. A larger one is refused unless what the library does not know
 * is zero.
 *
 * Functions that can fail return a LichenResult and, where `diagnostic` is not NULL, write one
 * line that says what is wrong and what would be accepted. On failure outputs are untouched.
 * Objects are immutable: any number of threads may use one; destroy it when none does.
 */
#ifndef LICHEN_H
#define LICHEN_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(LICHEN_PLUGIN_BUILD)
#define LICHEN_API __attribute__((visibility("default")))
#else
#define LICHEN_API
#endif

/* Major (high 16 bits): changes that break a host. Minor: additions. */
#define LICHEN_HEADER_VERSION 0x00010000u

typedef enum LichenResult {
  LICHEN_SUCCESS = 0,
  LICHEN_ERROR_USAGE = 1,       /* an argument is outside its range */
  LICHEN_ERROR_VERSION = 2,     /* header and library, or library and bundle, do not fit */
  LICHEN_ERROR_BAD_BUNDLE = 3,  /* the bundle cannot be used */
  LICHEN_ERROR_UNSUPPORTED = 4, /* the device lacks something, such as a format */
  LICHEN_ERROR_OUT_OF_HOST_MEMORY = 5,
  LICHEN_ERROR_OUT_OF_DEVICE_MEMORY = 6, /* also a descriptor pool that is too small */
  LICHEN_ERROR_DEVICE = 7                /* another failure of a Vulkan call */
} LichenResult;

typedef enum LichenStructureType {
  LICHEN_STRUCTURE_DIAGNOSTIC = 1,
  LICHEN_STRUCTURE_PARSE_INFO = 2,
  LICHEN_STRUCTURE_BUNDLE_PROPERTIES = 3,
  LICHEN_STRUCTURE_NOISE_PROPERTIES = 4,
  LICHEN_STRUCTURE_MAP_PROPERTIES = 5,
  LICHEN_STRUCTURE_MATERIAL_PROPERTIES = 6,
  LICHEN_STRUCTURE_IMAGE_PROPERTIES = 7,
  LICHEN_STRUCTURE_SAMPLER_PROPERTIES = 8,
  LICHEN_STRUCTURE_UNIFORM_INFO = 9,
  LICHEN_STRUCTURE_VULKAN_INFO = 10,
  LICHEN_STRUCTURE_VULKAN_FUNCTIONS = 11
} LichenStructureType;

/* Sets a struct to its defaults: LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO); */
#define LICHEN_INIT(object, structureType)                                                         \
  (memset(&(object), 0, sizeof(object)), (object).type = (structureType),                          \
   (object).size = sizeof(object))

/* A message for people, always terminated. */
typedef struct LichenDiagnostic {
  LichenStructureType type;
  uint32_t size;
  void* next;
  char text[496];
} LichenDiagnostic;

/* The library's version, to compare with LICHEN_HEADER_VERSION. */
LICHEN_API uint32_t lichenGetVersion(void);

/* ---- Bundles ---------------------------------------------------------------------------- */

typedef struct LichenBundle_T* LichenBundle;

typedef struct LichenParseInfo {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  uint32_t headerVersion; /* LICHEN_HEADER_VERSION */
  uint32_t reserved;
  const void* bytes; /* a .glb, or a .gltf whose buffers are data URIs; needed for this call only */
  size_t byteCount;
  const char* name; /* used in messages; NULL: "bundle" */
} LichenParseInfo;

/* Reads a bundle and checks all of it. Time and memory are in proportion to its size. */
LICHEN_API LichenResult lichenParseBundle(const LichenParseInfo* info, LichenBundle* bundle,
                                          LichenDiagnostic* diagnostic);
/* NULL is ignored. */
LICHEN_API void lichenDestroyBundle(LichenBundle bundle);

typedef struct LichenBundleProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t noiseCount;
  uint32_t materialCount; /* as many as the glTF file has */
  uint32_t imageCount;
} LichenBundleProperties;

LICHEN_API LichenResult lichenGetBundleProperties(LichenBundle bundle,
                                                  LichenBundleProperties* properties);

typedef struct LichenNoiseProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  const char* name;  /* lives as long as the bundle */
  uint32_t mapCount; /* LICHEN_MAP_COUNT of the shader, 1 to 6 */
  float tileSizeMetres;
  /* What one descriptor set of this noise takes from a pool. */
  uint32_t uniformBufferCount;
  uint32_t combinedImageSamplerCount;
} LichenNoiseProperties;

/* noise < noiseCount. */
LICHEN_API LichenResult lichenGetNoiseProperties(LichenBundle bundle, uint32_t noise,
                                                 LichenNoiseProperties* properties);

typedef enum LichenMapTarget {
  LICHEN_TARGET_BASE_COLOR = 0,
  LICHEN_TARGET_NORMAL = 1,
  LICHEN_TARGET_OCCLUSION_ROUGHNESS_METALLIC = 2,
  LICHEN_TARGET_EMISSIVE = 3,
  LICHEN_TARGET_HEIGHT = 4,
  LICHEN_TARGET_OPACITY = 5
} LichenMapTarget;

/* What a component of the shader's value means. */
typedef enum LichenChannel {
  LICHEN_CHANNEL_RED = 0, /* of light, linear */
  LICHEN_CHANNEL_GREEN = 1,
  LICHEN_CHANNEL_BLUE = 2,
  LICHEN_CHANNEL_SLOPE_X = 3, /* -nx/nz of the tangent-space normal */
  LICHEN_CHANNEL_SLOPE_Y = 4, /* -ny/nz */
  LICHEN_CHANNEL_OCCLUSION = 5,
  LICHEN_CHANNEL_ROUGHNESS = 6,
  LICHEN_CHANNEL_METALLIC = 7,
  LICHEN_CHANNEL_HEIGHT = 8,
  LICHEN_CHANNEL_OPACITY = 9
} LichenChannel;

typedef struct LichenMapProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  LichenMapTarget target;
  uint32_t channelCount; /* 1 to 3 */
  LichenChannel channels[3];
  uint32_t gaussianImage; /* image indices */
  uint32_t tableImage;
} LichenMapProperties;

/* noise < noiseCount, map < mapCount; map k is lichenUniforms.maps[k] in the shader. */
LICHEN_API LichenResult lichenGetMapProperties(LichenBundle bundle, uint32_t noise, uint32_t map,
                                               LichenMapProperties* properties);

#define LICHEN_NO_NOISE 0xFFFFFFFFu

typedef enum LichenMapping {
  LICHEN_MAPPING_UV = 0,
  LICHEN_MAPPING_TRIPLANAR = 1,
  LICHEN_MAPPING_SURFACE = 2,
  LICHEN_MAPPING_SOLID = 3
} LichenMapping;

typedef struct LichenMaterialProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t noise; /* LICHEN_NO_NOISE for a material that has none */
  LichenMapping mapping;
  uint32_t texCoord; /* the TEXCOORD_n that the noise takes */
} LichenMaterialProperties;

/* material < materialCount, the glTF index. */
LICHEN_API LichenResult lichenGetMaterialProperties(LichenBundle bundle, uint32_t material,
                                                    LichenMaterialProperties* properties);

/* ---- Images and samplers ---------------------------------------------------------------- */

typedef struct LichenImageProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  const char* name;
  uint32_t vkFormat;       /* the value of the VkFormat */
  uint32_t dimensionality; /* 2 or 3 */
  uint32_t width, height, depth;
  uint32_t mipLevels;
  uint32_t texelBytes;
  const void* bytes; /* all levels, tightly packed, level 0 first; lives as long as the bundle */
  size_t byteCount;
} LichenImageProperties;

/* image < imageCount. Inverse tables of one and two channels are 3-D images too, with a slab for
 * each level: the shader filters between levels with the third coordinate. */
LICHEN_API LichenResult lichenGetImageProperties(LichenBundle bundle, uint32_t image,
                                                 LichenImageProperties* properties);

/* One buffer-to-image copy: level `mipLevel` from `offset` in the image's bytes. */
typedef struct LichenCopy {
  size_t offset;
  size_t byteCount;
  uint32_t mipLevel;
  uint32_t width, height, depth;
} LichenCopy;

/* mipLevel < mipLevels of the image. */
LICHEN_API LichenResult lichenGetCopy(LichenBundle bundle, uint32_t image, uint32_t mipLevel,
                                      LichenCopy* copy);

typedef enum LichenSamplerUse {
  LICHEN_SAMPLER_GAUSSIAN = 0, /* linear, repeat, all mips, anisotropy as the host likes */
  LICHEN_SAMPLER_TABLE = 1     /* linear, clamp to edge, one mip */
} LichenSamplerUse;

typedef struct LichenSamplerProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t vkFilter;      /* magnification and minification, a VkFilter */
  uint32_t vkMipmapMode;  /* a VkSamplerMipmapMode */
  uint32_t vkAddressMode; /* all axes, a VkSamplerAddressMode */
  float maxLod;
  uint32_t takesAnisotropy; /* 1: maxAnisotropy of the uniforms applies */
} LichenSamplerProperties;

LICHEN_API LichenResult lichenGetSamplerProperties(LichenSamplerUse use,
                                                   LichenSamplerProperties* properties);

typedef enum LichenBindingKind {
  LICHEN_BINDING_UNIFORM_BUFFER = 0,
  LICHEN_BINDING_COMBINED_IMAGE_SAMPLER = 1
} LichenBindingKind;

/* One binding of a noise's descriptor set. */
typedef struct LichenBinding {
  uint32_t binding; /* relative to LICHEN_FIRST_BINDING */
  LichenBindingKind kind;
  LichenSamplerUse sampler; /* of a combined image sampler */
  uint32_t image;           /* of a combined image sampler */
} LichenBinding;

/* index < 1 + 2 * mapCount: the uniform block, then each map's Gaussian image and table. */
LICHEN_API LichenResult lichenGetBinding(LichenBundle bundle, uint32_t noise, uint32_t index,
                                         LichenBinding* binding);

/* ---- Uniforms --------------------------------------------------------------------------- */

/* Bytes of the uniform block, LichenUniforms in shaders_glsl/interface/lichen_interface.h. */
#define LICHEN_UNIFORM_BYTES 768

/* Which members of LichenUniformInfo replace the material's own values. */
typedef enum LichenOverride {
  LICHEN_OVERRIDE_SCALE = 1,
  LICHEN_OVERRIDE_OFFSET = 2,
  LICHEN_OVERRIDE_ROTATION = 4,
  LICHEN_OVERRIDE_SEED = 8,
  LICHEN_OVERRIDE_BLEND_SHARPNESS = 16,
  LICHEN_OVERRIDE_CONTRAST = 32,
  LICHEN_OVERRIDE_NOISE = 64 /* `noise` with default parameters; `material` is not read */
} LichenOverride;

typedef struct LichenUniformInfo {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  uint32_t material;  /* glTF index, of a material that has a noise */
  uint32_t overrides; /* LichenOverride bits */
  uint32_t noise;
  uint32_t seed;
  double scale;          /* > 0, texture-coordinate units that one exemplar spans */
  double offset[2];      /* tiles */
  double rotation;       /* radians, as KHR_texture_transform */
  double blendSharpness; /* [0.25, 16] */
  double contrast;       /* [0, 4] */
  /* The host's origin in whole tiles, exact within +-2^40: a point's tile coordinate is this plus
   * what the shader computes, so that coordinates near the camera stay small. */
  int64_t tileOrigin[2];
  /* The noise repeats after this many tiles, at least 1 each and a whole number where tileOrigin
   * is not 0. 0, 0: never. */
  double periodTiles[2];
  float maxAnisotropy; /* of the Gaussian sampler; 0 and 1: anisotropy off */
} LichenUniformInfo;

/* Writes LICHEN_UNIFORM_BYTES of std140 to `destination` (any alignment, may be mapped memory: it
 * is written once, in order). Cheap enough for every frame. */
LICHEN_API LichenResult lichenFillUniforms(LichenBundle bundle, const LichenUniformInfo* info,
                                           void* destination, LichenDiagnostic* diagnostic);

#ifdef __cplusplus
}
#endif

#endif
