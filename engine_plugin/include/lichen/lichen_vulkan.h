/* SPDX-License-Identifier: MIT
 *
 * Lichen's engine plugin, Vulkan layer: a parsed bundle -> sampled images and descriptor sets on
 * the host's device. It calls only the functions that the host hands in; it creates no device,
 * queue or pipeline, and never submits or waits.
 *
 *   lichenVulkanCreateContext   once per device
 *   lichenVulkanCreateAssets    once per bundle: images, constants, a filled staging buffer
 *   lichenVulkanRecordUpload    into a command buffer of the host's, which it submits
 *   lichenVulkanReleaseStaging  when that submission has completed
 *   lichenVulkanAllocateSet     from a pool of the host's; or lichenVulkanGetDescriptors
 *   lichenVulkanDestroyAssets   when no submission uses them any more; or lichenVulkanRetireAssets
 *
 * Assets are immutable: a changed bundle makes new ones, and the old retire. Vulkan 1.0 is enough;
 * no extension and no optional feature is used unless `info` asks for it.
 *
 * Threads: many may create assets of one context at once, where the host's device allocator can be
 * called by many. Calls on one LichenVulkanAssets object, and lichenVulkanRetireAssets,
 * lichenVulkanFrameCompleted and lichenVulkanDestroyContext on one context, are the host's to
 * order, as Vulkan's own calls on a pool or a command buffer are.
 */
#ifndef LICHEN_VULKAN_H
#define LICHEN_VULKAN_H

#include <lichen/lichen.h>

#include <vulkan/vulkan_core.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Everything that the plugin calls. Device functions may come from the loader or from the one
 * device. The functions of memory may be NULL with a deviceAllocator, and the functions of sets
 * where the host writes its own descriptors: a context without them has no set layout. */
typedef struct LichenVulkanFunctions {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  PFN_vkGetPhysicalDeviceFormatProperties getPhysicalDeviceFormatProperties;
  PFN_vkGetPhysicalDeviceImageFormatProperties getPhysicalDeviceImageFormatProperties;
  PFN_vkCreateBuffer createBuffer;
  PFN_vkDestroyBuffer destroyBuffer;
  PFN_vkGetBufferMemoryRequirements getBufferMemoryRequirements;
  PFN_vkBindBufferMemory bindBufferMemory;
  PFN_vkCreateImage createImage;
  PFN_vkDestroyImage destroyImage;
  PFN_vkGetImageMemoryRequirements getImageMemoryRequirements;
  PFN_vkBindImageMemory bindImageMemory;
  PFN_vkCreateImageView createImageView;
  PFN_vkDestroyImageView destroyImageView;
  PFN_vkCreateSampler createSampler;
  PFN_vkDestroySampler destroySampler;
  PFN_vkCmdPipelineBarrier cmdPipelineBarrier;
  PFN_vkCmdCopyBufferToImage cmdCopyBufferToImage;
  PFN_vkCmdCopyBuffer cmdCopyBuffer;
  /* memory */
  PFN_vkGetPhysicalDeviceMemoryProperties getPhysicalDeviceMemoryProperties;
  PFN_vkAllocateMemory allocateMemory;
  PFN_vkFreeMemory freeMemory;
  PFN_vkMapMemory mapMemory;
  /* sets */
  PFN_vkCreateDescriptorSetLayout createDescriptorSetLayout;
  PFN_vkDestroyDescriptorSetLayout destroyDescriptorSetLayout;
  PFN_vkAllocateDescriptorSets allocateDescriptorSets;
  PFN_vkUpdateDescriptorSets updateDescriptorSets;
} LichenVulkanFunctions;

/* What the plugin asks of the host's allocator: memory for one buffer, or for several images of a
 * bundle, packed one after another. A request for images is at most 1 GiB, unless a single image is
 * larger. */
typedef struct LichenMemoryRequest {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  VkMemoryRequirements requirements;
  VkMemoryPropertyFlags properties; /* all are needed; with HOST_VISIBLE, `mapped` is too */
  /* VK_TRUE for the images: bufferImageGranularity between the two kinds is the host's to keep. */
  VkBool32 optimalTiling;
} LichenMemoryRequest;

/* A piece of device memory. */
typedef struct LichenDeviceMemory {
  LichenStructureType type;
  uint32_t size;
  void* next;
  VkDeviceMemory memory;
  VkDeviceSize offset; /* bytes, aligned as asked */
  void* mapped;        /* of this piece, where asked for: not of the start of `memory` */
  void* handle;        /* the host's own, handed back on release */
} LichenDeviceMemory;

/* The host's allocator of device memory. Called only inside lichenVulkanCreateAssets (allocate,
 * release), lichenVulkanReleaseStaging, and what destroys assets (release), on their thread.
 * Neither may throw: `allocate` returns a VkResult, `release` cannot fail. */
typedef struct LichenDeviceAllocator {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  void* userData;
  /* Fills what follows `next` in `memory`. VK_SUCCESS or the reason why not. */
  VkResult (*allocate)(void* userData, const LichenMemoryRequest* request,
                       LichenDeviceMemory* memory);
  void (*release)(void* userData, const LichenDeviceMemory* memory);
} LichenDeviceAllocator;

typedef enum LichenVulkanFlags {
  /* The material's block is a VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC: one set serves all frames
   * in flight, each with its own offset. */
  LICHEN_VULKAN_DYNAMIC_UNIFORMS = 1,
  /* Sets have LICHEN_LAYERED_SET_BINDINGS, for shaders with LICHEN_LAYERS above 1. Without it,
   * layered noises have no sets. */
  LICHEN_VULKAN_LAYERS = 2
} LichenVulkanFlags;

typedef struct LichenVulkanInfo {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  uint32_t headerVersion; /* LICHEN_HEADER_VERSION */
  uint32_t flags;         /* LichenVulkanFlags; no other bit is valid */
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  /* Either the functions, or the loader's vkGetInstanceProcAddr and the device's instance. */
  const LichenVulkanFunctions* functions;
  PFN_vkGetInstanceProcAddr getInstanceProcAddr;
  VkInstance instance;
  /* For host memory of every object that the plugin creates; copied. NULL: the driver's own. */
  const VkAllocationCallbacks* allocationCallbacks;
  /* Copied. NULL: the plugin allocates one block for a bundle's images, one for its constants and
   * one for its staging buffer; more where the images take more than 1 GiB. */
  const LichenDeviceAllocator* deviceAllocator;
  /* [0, 64] of the images' sampler. 0 and 1: trilinear. Above 1 only when the
   * samplerAnisotropy feature is enabled, at most the device's limit, and with the same value in
   * LichenPlacement, which says what else follows. */
  float maxAnisotropy;
  uint32_t firstBinding;     /* LICHEN_FIRST_BINDING of the shaders; layouts begin there */
  VkShaderStageFlags stages; /* that read the noise; 0: fragment and compute */
  uint32_t reserved;         /* 0 */
} LichenVulkanInfo;

typedef struct LichenVulkanContext_T* LichenVulkanContext;
typedef struct LichenVulkanAssets_T* LichenVulkanAssets;

/* Creates two samplers and a set layout. The structs that `info` points to may go after the call;
 * the device must outlive the context. */
LICHEN_API LichenResult lichenVulkanCreateContext(const LichenVulkanInfo* info,
                                                  LichenVulkanContext* context,
                                                  LichenDiagnostic* diagnostic);
/* After all its assets but the retired ones, which it destroys. NULL is ignored. */
LICHEN_API void lichenVulkanDestroyContext(LichenVulkanContext context);

/* Creates the bundle's images and fills a staging buffer; the bundle may be destroyed after. Takes
 * device memory for the images and, until lichenVulkanReleaseStaging, as much for the buffer.
 * LICHEN_ERROR_UNSUPPORTED names the table that the device cannot filter, or the use for which it
 * has no memory type. */
LICHEN_API LichenResult lichenVulkanCreateAssets(LichenVulkanContext context, LichenBundle bundle,
                                                 LichenVulkanAssets* assets,
                                                 LichenDiagnostic* diagnostic);
/* When no command buffer that may still run uses them. NULL is ignored. */
LICHEN_API void lichenVulkanDestroyAssets(LichenVulkanAssets assets);

/* Records the copies and their barriers. `commandBuffer` is recording, is outside a render pass,
 * and belongs to the queue family that will sample the images. The images are
 * VK_SHARING_MODE_EXCLUSIVE; to upload on another family, use lichenVulkanRecordTransfer. Later
 * commands in submission order on that queue may sample the images in any stage without a barrier;
 * other queues of the family wait for a semaphore. Submit it once.
 * This function and the next two record all of their commands or none. They fail only with
 * LICHEN_ERROR_USAGE (a NULL argument, equal families, or a staging buffer that is released) and
 * LICHEN_ERROR_OUT_OF_HOST_MEMORY. */
LICHEN_API LichenResult lichenVulkanRecordUpload(LichenVulkanAssets assets,
                                                 VkCommandBuffer commandBuffer);
/* The same on a queue of another family, such as one that can only transfer. `commandBuffer` is of
 * `transferFamily`: it copies, and releases images and constants to `family`. */
LICHEN_API LichenResult lichenVulkanRecordTransfer(LichenVulkanAssets assets,
                                                   VkCommandBuffer commandBuffer,
                                                   uint32_t transferFamily, uint32_t family);
/* `commandBuffer` is of `family`: it acquires what lichenVulkanRecordTransfer released. Give both
 * the same families. Its submission waits for a semaphore that the transfer's submission signals;
 * the wait stage may be any but BOTTOM_OF_PIPE, since the acquisition waits for ALL_COMMANDS. Later
 * commands in submission order on that queue may sample the images, as after
 * lichenVulkanRecordUpload. Needs no staging buffer. */
LICHEN_API LichenResult lichenVulkanRecordAcquire(LichenVulkanAssets assets,
                                                  VkCommandBuffer commandBuffer,
                                                  uint32_t transferFamily, uint32_t family);
/* Frees the staging buffer, when the upload has completed. May be called again; what destroys the
 * assets does it too. NULL is ignored. */
LICHEN_API void lichenVulkanReleaseStaging(LichenVulkanAssets assets);

/* Hot reload: create assets of the changed bundle, upload them, take sets from them, and retire the
 * old ones instead of destroying them. Frames have numbers of the host's that grow; `lastFrame` is
 * the last whose commands may use the old assets, which this call takes. NULL is ignored. */
LICHEN_API void lichenVulkanRetireAssets(LichenVulkanAssets assets, uint64_t lastFrame);
/* The device has completed `frame` and all before it: destroys what was retired up to there. */
LICHEN_API void lichenVulkanFrameCompleted(LichenVulkanContext context, uint64_t frame);

/* The layout of every noise's set, whatever its maps, owned by the context: LICHEN_SET_BINDINGS
 * from firstBinding on, with LICHEN_VULKAN_LAYERS LICHEN_LAYERED_SET_BINDINGS. LICHEN_ERROR_USAGE
 * where the host has given no functions for sets. A set takes from a pool 2 uniform buffers (with
 * LICHEN_VULKAN_DYNAMIC_UNIFORMS one of them dynamic), 2 samplers and LICHEN_SET_IMAGES or
 * LICHEN_LAYERED_SET_IMAGES sampled images. */
LICHEN_API LichenResult lichenVulkanGetSetLayout(LichenVulkanContext context,
                                                 VkDescriptorSetLayout* layout);

/* The samplers of all images and of all tables, for hosts with descriptors of their own. They live
 * as long as the context. */
LICHEN_API LichenResult lichenVulkanGetSamplers(LichenVulkanContext context, VkSampler* images,
                                                VkSampler* tables);

/* A set from the host's pool, written with the noise's constants and images, and with `material`: a
 * uniform buffer's range of at least LICHEN_MATERIAL_BYTES, where shaders know triplanar noise
 * LICHEN_TRIPLANAR_MATERIAL_BYTES, and where they know layers LICHEN_LAYERED_MATERIAL_BYTES. Once
 * for each material, not each frame. The pool needs no FREE_DESCRIPTOR_SET; the set is the host's.
 * noise < noiseCount. LICHEN_ERROR_OUT_OF_POOL_MEMORY where the pool is too small; on Vulkan 1.0
 * without VK_KHR_maintenance1 drivers need not notice. */
LICHEN_API LichenResult lichenVulkanAllocateSet(LichenVulkanAssets assets, uint32_t noise,
                                                VkDescriptorPool pool,
                                                const VkDescriptorBufferInfo* material,
                                                VkDescriptorSet* set, LichenDiagnostic* diagnostic);

/* For hosts that write descriptors themselves: where the noise's constants are, and its
 * LICHEN_SET_IMAGES images, first of all roles and then their tables, without samplers; with
 * LICHEN_VULKAN_LAYERS LICHEN_LAYERED_SET_IMAGES images, the index maps' last. They live as long as
 * the assets. The buffer may also be read as a storage buffer, in which all noises of the bundle
 * follow each other. noise < noiseCount. */
LICHEN_API LichenResult lichenVulkanGetDescriptors(LichenVulkanAssets assets, uint32_t noise,
                                                   VkDescriptorBufferInfo* constants,
                                                   VkDescriptorImageInfo* images);

#ifdef __cplusplus
}
#endif

#endif
