/* SPDX-License-Identifier: MIT
 *
 * Lichen's engine plugin, plan layer: a noise bundle in memory -> images, copies, samplers,
 * bindings and uniform bytes, as plain data. No Vulkan call, no Vulkan header, no thread, no
 * static state. Engines with their own render hardware interface need nothing else;
 * lichen_vulkan.h does the rest for those that hand over a VkDevice.
 *
 * Every struct starts with type, size and next. Set type and size (LICHEN_INIT does, and zeroes the
 * rest, padding too), leave the rest zero for the defaults; next must be NULL.
 * ..._MAX_ENUM keeps enums 32 bits wide and is no value.
 * `reserved` members pad structs and must be 0; another value in an input is LICHEN_ERROR_VERSION.
 * A smaller struct comes from an older header: its missing members read as 0 and are not written. A
 * larger struct comes from a newer header: an input is refused if a member that this library does
 * not know is not 0; in outputs such members are not written.
 *
 * Functions that can fail return a LichenResult, and outputs are untouched where that is not
 * LICHEN_SUCCESS. Those with a `diagnostic` then write one line into it, unless it is NULL, that
 * says what is wrong and what was expected; those without fail for a NULL argument, an index
 * out of range or a struct without its type and size, all LICHEN_ERROR_USAGE, or a `next` that is
 * not NULL, LICHEN_ERROR_VERSION. Nothing throws, prints or aborts.
 *
 * A bundle is immutable: any number of threads may use one. Destroy it when none does.
 */
#ifndef LICHEN_H
#define LICHEN_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(LICHEN_PLUGIN_BUILD) && defined(_WIN32)
#define LICHEN_API __declspec(dllexport)
#elif defined(LICHEN_PLUGIN_BUILD) && defined(__GNUC__)
#define LICHEN_API __attribute__((visibility("default")))
#else
#define LICHEN_API
#endif

/* Major (high 16 bits): changes that break a host or the shaders that it has compiled, a new
 * LICHEN_INTERFACE_VERSION among them; a library of another is LICHEN_ERROR_VERSION. Minor:
 * additions. A host may be built with a newer or older minor version than the library's, and is
 * refused only where it asks for what the library does not know. Both count from the first release:
 * until then build host, shaders and library from one revision. */
#define LICHEN_HEADER_VERSION 0x00010000u

typedef enum LichenResult {
  LICHEN_SUCCESS = 0,
  LICHEN_ERROR_USAGE = 1,       /* an argument is outside its range */
  LICHEN_ERROR_VERSION = 2,     /* header or shaders do not fit the library */
  LICHEN_ERROR_BAD_BUNDLE = 3,  /* the bundle is at fault, or needs a newer library */
  LICHEN_ERROR_UNSUPPORTED = 4, /* the device cannot filter an image, or has no memory for it */
  LICHEN_ERROR_OUT_OF_HOST_MEMORY = 5,
  LICHEN_ERROR_OUT_OF_DEVICE_MEMORY = 6, /* or more allocations than the device allows */
  LICHEN_ERROR_OUT_OF_POOL_MEMORY = 7,   /* the descriptor pool is too small: give another */
  LICHEN_ERROR_DEVICE = 8,   /* another failure of a Vulkan call, such as a lost device */
  LICHEN_ERROR_INTERNAL = 9, /* a fault of this library */
  LICHEN_RESULT_MAX_ENUM = 0x7FFFFFFF
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
  LICHEN_STRUCTURE_MATERIAL_PARAMETERS = 9,
  LICHEN_STRUCTURE_VULKAN_INFO = 10,
  LICHEN_STRUCTURE_VULKAN_FUNCTIONS = 11,
  LICHEN_STRUCTURE_COPY = 12,
  LICHEN_STRUCTURE_BINDING = 13,
  LICHEN_STRUCTURE_DEVICE_ALLOCATOR = 14,
  LICHEN_STRUCTURE_MEMORY_REQUEST = 15,
  LICHEN_STRUCTURE_DEVICE_MEMORY = 16,
  LICHEN_STRUCTURE_PLACEMENT = 17,
  LICHEN_STRUCTURE_SHADER_SWITCHES = 18,
  LICHEN_STRUCTURE_MAX_ENUM = 0x7FFFFFFF
} LichenStructureType;

/* Sets a struct to its defaults: LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO); */
#define LICHEN_INIT(object, structureType)                                                         \
  (memset(&(object), 0, sizeof(object)), (object).type = (structureType),                          \
   (object).size = sizeof(object))

/* A message for people: one line of UTF-8, terminated, cut after a whole character where it does
 * not fit. Control characters and bytes that are no UTF-8, in names, are written \xNN. Written on
 * failure only. */
typedef struct LichenDiagnostic {
  LichenStructureType type;
  uint32_t size;
  void* next;
  char text[496];
} LichenDiagnostic;

/* The library's version, to compare with LICHEN_HEADER_VERSION. */
LICHEN_API uint32_t lichenGetVersion(void);

/* ---- Bundles ---------------------------------------------------------------------------- */

/* A parsed bundle; owns copies of everything that it needs of the file. */
typedef struct LichenBundle_T* LichenBundle;

typedef struct LichenParseInfo {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  uint32_t headerVersion; /* LICHEN_HEADER_VERSION */
  /* LICHEN_INTERFACE_VERSION of the lichen_interface.h with which the host's SPIR-V was compiled;
   * 0: shaders_glsl/ of the same release as this header. Another layout of the uniform block or the
   * bindings than this library's is LICHEN_ERROR_VERSION. */
  uint32_t interfaceVersion;
  /* a .glb, or a .gltf whose buffers are data URIs; needed for this call only */
  const void* bytes;
  size_t byteCount;
  const char* name; /* UTF-8, used in messages, needed for this call only; NULL: "bundle" */
} LichenParseInfo;

/* Reads a bundle and checks all of it; input may be hostile. Time and memory are in proportion to
 * its size. The caller owns *bundle. A glTF file without noises is a bundle with noiseCount 0.
 * Noises of a later revision than this library knows are left out, with what only they use: noises
 * and images are numbered without them, and LichenMaterialProperties says which materials lost
 * theirs. */
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
  uint32_t imageCount;    /* of all noises; maps may share one */
  uint32_t reserved;      /* 0 */
} LichenBundleProperties;

LICHEN_API LichenResult lichenGetBundleProperties(LichenBundle bundle,
                                                  LichenBundleProperties* properties);

/* How a noise is evaluated; bit numbers of the shader library's LICHEN_METHODS. */
typedef enum LichenNoiseMethod {
  LICHEN_NOISE_TILING = 0,             /* tiling and blending, [HN18] */
  LICHEN_NOISE_TEXTON = 1,             /* sparse convolution of a texton, [GLM17] */
  LICHEN_NOISE_LOCAL_RANDOM_PHASE = 2, /* windowed cosines with random phases, [LRP14] */
  LICHEN_NOISE_MULTIPLE_KERNELS = 3,   /* sparse convolution of several kernels, [MKN12] */
  LICHEN_NOISE_QUILTING = 4,           /* tiles cut along the outlines of what they show */
  LICHEN_NOISE_METHOD_MAX_ENUM = 0x7FFFFFFF
} LichenNoiseMethod;

#define LICHEN_NO_NOISE 0xFFFFFFFFu

typedef struct LichenNoiseProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  const char* name;      /* UTF-8, as long as the bundle lives */
  double tileSizeMetres; /* [1e-6, 1e6] metres, the width of one exemplar */
  uint32_t mapCount;     /* 1 to 6 */
  LichenNoiseMethod method;
  uint32_t mixSteps;     /* [2, 64] of a mix of textons, 1 of other noises */
  uint32_t mappings;     /* bit m: a material of the noise may have the LichenMapping m */
  uint32_t layerCount;   /* [2, 4] of a layered noise, 1 of others */
  /* The noises that are its layers, the first this one, and the noises of its layerCount - 1 index
   * maps; then LICHEN_NO_NOISE. All other members describe the first layer, but for `mappings`. */
  uint32_t layers[4];
  uint32_t indices[3];
  /* 1 if LichenMaterialParameters::tileRotation may be 4: tiles of tiling, in all layers, are
   * square. */
  uint32_t takesQuarterTurns;
  uint32_t reserved; /* 0 */
} LichenNoiseProperties;

/* noise < noiseCount. */
LICHEN_API LichenResult lichenGetNoiseProperties(LichenBundle bundle, uint32_t noise,
                                                 LichenNoiseProperties* properties);

typedef enum LichenMapTarget {
  LICHEN_TARGET_BASE_COLOR = 0, /* the numbers are the shader's roles */
  LICHEN_TARGET_NORMAL = 1,
  LICHEN_TARGET_OCCLUSION_ROUGHNESS_METALLIC = 2,
  LICHEN_TARGET_EMISSIVE = 3,
  LICHEN_TARGET_HEIGHT = 4,
  LICHEN_TARGET_OPACITY = 5,
  LICHEN_TARGET_MAX_ENUM = 0x7FFFFFFF
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
  LICHEN_CHANNEL_OPACITY = 9,
  LICHEN_CHANNEL_MAX_ENUM = 0x7FFFFFFF
} LichenChannel;

typedef struct LichenMapProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  LichenMapTarget target;
  uint32_t channelCount;     /* 1 to 3 */
  LichenChannel channels[3]; /* of the shader's x, y, z; the first channelCount are set */
  uint32_t image;            /* image indices, < imageCount: Gaussian image, texton or cosines */
  uint32_t tableImage; /* for a mix the table of its steps; for other maps without an inverse table
                        * a placeholder, which is not read */
  uint32_t reserved; /* 0 */
} LichenMapProperties;

/* noise < noiseCount, map < mapCount. In the shader maps have the number of their target, not this
 * one. */
LICHEN_API LichenResult lichenGetMapProperties(LichenBundle bundle, uint32_t noise, uint32_t map,
                                               LichenMapProperties* properties);

typedef enum LichenMapping {
  LICHEN_MAPPING_UV = 0,
  LICHEN_MAPPING_TRIPLANAR = 1,
  LICHEN_MAPPING_SURFACE = 2,
  LICHEN_MAPPING_SOLID = 3,
  LICHEN_MAPPING_MAX_ENUM = 0x7FFFFFFF
} LichenMapping;

/* For all mappings but LICHEN_MAPPING_UV, the space of the positions, normals and tangents that the
 * host gives the shader: the blocks are the same for both. */
typedef enum LichenSpace {
  LICHEN_SPACE_WORLD = 0,  /* one pattern runs from mesh to mesh */
  LICHEN_SPACE_OBJECT = 1, /* the mesh's own, before morph targets and skins: the pattern moves,
                            * rotates and scales with the object */
  LICHEN_SPACE_MAX_ENUM = 0x7FFFFFFF
} LichenSpace;

/* Where a material takes the weight of a mix from. LICHEN_POINT knows the first two; a host gives
 * the others by lichenMixByMask or lichenSetMix. */
typedef enum LichenMixSource {
  LICHEN_MIX_CONSTANT = 0, /* what a material of a noise that is no mix has too */
  LICHEN_MIX_DIRECTION = 1,
  LICHEN_MIX_TEXTURE = 2,
  LICHEN_MIX_VERTEX_COLOR = 3,
  LICHEN_MIX_SOURCE_MAX_ENUM = 0x7FFFFFFF
} LichenMixSource;

/* How the impacts of texton noise lie. */
typedef enum LichenPointProcess {
  LICHEN_POINT_PROCESS_STRATIFIED = 0, /* one in each cell of a grid */
  LICHEN_POINT_PROCESS_POISSON = 1,    /* a Poisson process */
  LICHEN_POINT_PROCESS_MAX_ENUM = 0x7FFFFFFF
} LichenPointProcess;

typedef struct LichenMaterialProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t noise; /* LICHEN_NO_NOISE for a material that has none */
  LichenMapping mapping;
  uint32_t texCoord; /* [0, 15], the TEXCOORD_n that the noise takes */
  /* 0, or at least 1 where this library does not know the method of the material's noise or its
   * revision, which this is: `noise` is LICHEN_NO_NOISE; draw the material with its core textures.
   */
  uint32_t unknownRevision;
  LichenMixSource mixSource;
  uint32_t mixTexture; /* of LICHEN_MIX_TEXTURE, the glTF texture; its stored value is the weight,
                        * whatever KHR_texture_transform it has is the host's to read */
  uint32_t mixSet;     /* [0, 15] of LICHEN_MIX_TEXTURE the TEXCOORD_n, of vertex colours COLOR_n */
  uint32_t mixChannel; /* [0, 3] of the texture or the colour, red to alpha */
  LichenSpace space;   /* world for LICHEN_MAPPING_UV */
  uint32_t reserved;   /* 0 */
} LichenMaterialProperties;

/* material < materialCount, the glTF index. */
LICHEN_API LichenResult lichenGetMaterialProperties(LichenBundle bundle, uint32_t material,
                                                    LichenMaterialProperties* properties);

/* ---- Images and samplers ---------------------------------------------------------------- */

typedef struct LichenImageProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  const char* name;              /* UTF-8, may be empty; as long as the bundle lives */
  uint32_t vkFormat;             /* the value of the VkFormat */
  uint32_t dimensionality;       /* 2 or 3: VK_IMAGE_TYPE_2D or _3D */
  uint32_t width, height, depth; /* texels of level 0; depth is 1 where dimensionality is 2 */
  uint32_t mipLevels;
  uint32_t texelBytes;
  uint32_t vkSwizzle[4]; /* the VkComponentSwizzle of the view's r, g, b and a; 0: identity */
  const void* bytes;     /* all levels, tightly packed, level 0 first, x fastest, rows top first, z
                          * slowest; as long as the bundle lives */
  size_t byteCount;
  uint32_t fetchedOnly; /* 1: the shader reads single texels, so the format needs no linear filter;
                         * nor may it be converted: bits of a float can be two numbers */
  uint32_t reserved;    /* 0 */
} LichenImageProperties;

/* image < imageCount. All inverse tables are 3-D images; tables of one and two dimensions have a
 * depth of 1. */
LICHEN_API LichenResult lichenGetImageProperties(LichenBundle bundle, uint32_t image,
                                                 LichenImageProperties* properties);

/* One buffer-to-image copy: level `mipLevel` from `offset` in the image's bytes. */
typedef struct LichenCopy {
  LichenStructureType type;
  uint32_t size;
  void* next;
  size_t offset; /* bytes */
  size_t byteCount;
  uint32_t mipLevel;
  uint32_t width, height, depth; /* texels */
} LichenCopy;

/* image < imageCount, mipLevel < mipLevels of the image. */
LICHEN_API LichenResult lichenGetCopy(LichenBundle bundle, uint32_t image, uint32_t mipLevel,
                                      LichenCopy* copy);

typedef enum LichenSamplerUse {
  LICHEN_SAMPLER_IMAGE = 0, /* of Gaussian images and textons: trilinear, repeat, all mips;
                               anisotropy: LichenPlacement */
  LICHEN_SAMPLER_TABLE = 1, /* trilinear, clamp to edge, all mips */
  LICHEN_SAMPLER_MAX_ENUM = 0x7FFFFFFF
} LichenSamplerUse;

typedef struct LichenSamplerProperties {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t vkFilter;        /* magnification and minification, a VkFilter */
  uint32_t vkMipmapMode;    /* a VkSamplerMipmapMode */
  uint32_t vkAddressMode;   /* all axes, a VkSamplerAddressMode */
  float maxLod;             /* minLod and mipLodBias are 0 */
  uint32_t takesAnisotropy; /* 1: maxAnisotropy of LichenPlacement may be this sampler's */
  uint32_t reserved;        /* 0 */
} LichenSamplerProperties;

LICHEN_API LichenResult lichenGetSamplerProperties(LichenSamplerUse use,
                                                   LichenSamplerProperties* properties);

typedef enum LichenBindingKind {
  LICHEN_BINDING_NOISE_BUFFER = 0,    /* uniform buffer: lichenGetNoiseConstants */
  LICHEN_BINDING_MATERIAL_BUFFER = 1, /* uniform buffer: lichenFillMaterial */
  LICHEN_BINDING_SAMPLER = 2,
  LICHEN_BINDING_SAMPLED_IMAGE = 3,
  LICHEN_BINDING_MAX_ENUM = 0x7FFFFFFF
} LichenBindingKind;

/* The bindings of a noise's descriptor set, the same for all noises: 2 uniform buffers, 2 samplers
 * and 13 sampled images, the last of which is a quilting noise's cells. */
#define LICHEN_SET_BINDINGS 17
#define LICHEN_SET_IMAGES 13

/* The same where shaders know layers (LICHEN_LAYERS above 1), and so no quilting: the images of
 * index maps are last. */
#define LICHEN_LAYERED_SET_BINDINGS 19
#define LICHEN_LAYERED_SET_IMAGES 15

/* One binding of a noise's descriptor set. */
typedef struct LichenBinding {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t binding; /* relative to LICHEN_FIRST_BINDING */
  LichenBindingKind kind;
  /* For LICHEN_BINDING_SAMPLER, that sampler; for LICHEN_BINDING_SAMPLED_IMAGE, the sampler that
   * the shader samples the image with. */
  LichenSamplerUse sampler;
  /* For LICHEN_BINDING_SAMPLED_IMAGE: an image index. If the noise does not have the map, it is a
   * placeholder that the shader does not read. */
  uint32_t image;
} LichenBinding;

/* noise < noiseCount, index < LICHEN_LAYERED_SET_BINDINGS. */
LICHEN_API LichenResult lichenGetBinding(LichenBundle bundle, uint32_t noise, uint32_t index,
                                         LichenBinding* binding);

/* ---- Parameters ------------------------------------------------------------------------- */

/* What the bundle fixes: LichenNoiseConstants in shaders_glsl/interface/lichen_interface.h, alike
 * in std140 and std430. Uploaded once. A multiple of 256, and so of any device's
 * minUniformBufferOffsetAlignment. */
#define LICHEN_NOISE_BYTES 2048
/* What a material says: LichenMaterial; may change each frame. */
#define LICHEN_MATERIAL_BYTES 128
/* The same of LICHEN_MAPPING_TRIPLANAR: LichenTriplanarMaterial. */
#define LICHEN_TRIPLANAR_MATERIAL_BYTES 192

/* The same of a layered noise, whatever the mapping: LichenLayeredMaterial. */
#define LICHEN_LAYERED_MATERIAL_BYTES 1344

/* Writes LICHEN_NOISE_BYTES to `destination`, of any alignment. noise < noiseCount. */
LICHEN_API LichenResult lichenGetNoiseConstants(LichenBundle bundle, uint32_t noise,
                                                void* destination);

/* How a material uses a noise. Get it, change what you like, fill the material's block with it: the
 * bundle need not live. */
typedef struct LichenMaterialParameters {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  /* Index of the noise in its bundle; written to the block for shaders that index the constants of
   * noises. A host that stores the constants of several bundles in one buffer adds the index of the
   * bundle's first noise in that buffer. */
  uint32_t noise;
  /* The shader must compute its point for the same mapping: with LICHEN_POINT for
   * LICHEN_MAPPING_UV, LICHEN_POINT_TRIPLANAR for LICHEN_MAPPING_TRIPLANAR, LICHEN_POINT_SURFACE
   * for LICHEN_MAPPING_SURFACE, and LICHEN_POINT_SOLID for
   * LICHEN_MAPPING_SOLID; LichenNoiseProperties::mappings says who has it. */
  LichenMapping mapping;
  uint32_t seed; /* any; another seed is another noise of the same look */
  /* For tiling: the number of angles by which tiles are rotated: 2 (half turns) or, where
   * LichenNoiseProperties::takesQuarterTurns, 4. 0 and 1: no rotation. */
  uint32_t tileRotation;
  double scale;          /* [1e-6, 1e6] texture-coordinate units that one exemplar spans */
  double offset[2];      /* [-1e9, 1e9] tiles, in float precision; for large ones, use tileOrigin */
  double rotation;       /* [-1e6, 1e6] radians, as KHR_texture_transform */
  double blendSharpness; /* [0.25, 16] of tiling: exponent of the blend weights */
  double contrast;       /* [0, 4] scale of the Gaussian value about its mean */
  double planeSharpness; /* [1, 64] of the mapping triplanar: exponent of the planes' weights */
  double impacts; /* [1, 1000] of texton noise: the mean number of impacts that reach a point, on
                   * surfaces twice as many; cost is proportional */
  LichenPointProcess pointProcess; /* of texton noise */
  /* For a mix: the weight of LICHEN_MIX_CONSTANT; the texture coordinates of 0 and 1 of
   * LICHEN_MIX_DIRECTION. */
  LichenMixSource mixSource;
  double mixWeight;              /* [0, 1] */
  double mixStart[2], mixEnd[2]; /* [-1e6, 1e6], of LICHEN_MIX_DIRECTION 1e-6 apart */
  /* What lichenFillMaterial and lichenGetShaderSwitches need of the noise. Leave it unchanged. */
  uint32_t noiseSummary[116];
} LichenMaterialParameters;

/* The use by a material that has a noise; material < materialCount. */
LICHEN_API LichenResult lichenGetMaterialParameters(LichenBundle bundle, uint32_t material,
                                                    LichenMaterialParameters* parameters);
/* The defaults for a noise that no material uses; noise < noiseCount. */
LICHEN_API LichenResult lichenGetDefaultParameters(LichenBundle bundle, uint32_t noise,
                                                   LichenMaterialParameters* parameters);

/* Where a material's noise lies, and how its images are sampled. */
typedef struct LichenPlacement {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  /* The host's origin in whole tiles, each within +-2^40, exact: a point's tile coordinate is this
   * plus what the shader computes, so that coordinates near the camera stay small. Texture
   * coordinates have x and y. For the other mappings it is a point in space, whose tiles are cubes
   * of `scale` times the noise's tileSizeMetres: the host gives the shader positions less
   * tileOrigin times that. */
  int64_t tileOrigin[3];
  /* The noise repeats after this many tiles: [1, 65536] each, a whole number where tileOrigin is
   * not 0. 0, 0: never, as of all mappings but LICHEN_MAPPING_UV. */
  double periodTiles[2];
  /* [0, 64] VkSamplerCreateInfo::maxAnisotropy of the images' sampler. 0 and 1: it is
   * trilinear, the default, which is what the reference pictures and the tests show. Above 1 the
   * shaders must be compiled with LICHEN_ANISOTROPIC 1 and the sampler must be made with the same
   * value: the level of the inverse table follows the footprint that the sampler filters, and where
   * the three do not agree, minified noise has too much or too little contrast. How exactly an
   * anisotropic footprint is filtered is the driver's choice. */
  float maxAnisotropy;
  uint32_t reserved; /* 0 */
} LichenPlacement;

/* Writes LICHEN_MATERIAL_BYTES, of the mapping triplanar LICHEN_TRIPLANAR_MATERIAL_BYTES, of a
 * layered noise LICHEN_LAYERED_MATERIAL_BYTES, to `destination` (any alignment, may be mapped
 * memory: it is written once, in order, and not read). Cheap enough for every frame: no allocation.
 * `placement` NULL: at the origin. */
LICHEN_API LichenResult lichenFillMaterial(const LichenMaterialParameters* parameters,
                                           const LichenPlacement* placement, void* destination,
                                           LichenDiagnostic* diagnostic);

/* The switches of the shader library that fit some materials: what none of them needs is left out.
 * `methods`, `mappings` and `layers` are literals of a shader; it may also have been compiled with
 * more bits, or more layers than 1. `roles` and `features` may be specialization constants.
 * shaders_glsl/README.md says what each is. */
typedef struct LichenShaderSwitches {
  LichenStructureType type;
  uint32_t size;
  void* next;
  uint32_t methods;     /* LICHEN_METHODS */
  uint32_t mappings;    /* LICHEN_MAPPINGS: bit m for LICHEN_MAPPING_... m */
  uint32_t layers;      /* LICHEN_LAYERS */
  uint32_t roles;       /* LICHEN_ROLES */
  uint32_t features;    /* LICHEN_FEATURES */
  uint32_t anisotropic; /* LICHEN_ANISOTROPIC, a literal */
  /* All of them as one line of arguments for a compiler, such as
   * "-DLICHEN_METHODS=1 -DLICHEN_MAPPINGS=1 ...", terminated. */
  char text[232];
} LichenShaderSwitches;

/* The materials may be of several bundles. Of `placement`, which stands for all of theirs, it reads
 * periodTiles and maxAnisotropy; NULL: none repeats, and sampling is trilinear. A change of
 * mapping, pointProcess, tileRotation or blendSharpness may need other switches. LICHEN_ERROR_USAGE
 * also where one material is of a layered noise and another of a quilting one or on a surface: each
 * needs a shader of its own. */
LICHEN_API LichenResult lichenGetShaderSwitches(const LichenMaterialParameters* const* materials,
                                                uint32_t materialCount,
                                                const LichenPlacement* placement,
                                                LichenShaderSwitches* switches,
                                                LichenDiagnostic* diagnostic);

#ifdef __cplusplus
}
#endif

#endif
