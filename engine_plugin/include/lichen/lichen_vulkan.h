/* SPDX-License-Identifier: MIT
 *
 * Lichen's engine plugin, Vulkan layer: a parsed bundle -> sampled images and descriptor sets on
 * the host's device. It calls only the functions that the host hands in; it creates no device,
 * queue or pipeline, and never submits or waits.
 *
 *   lichenVulkanCreateContext   once per device
 *   lichenVulkanCreateAssets    once per bundle: images, views, layouts, a filled staging buffer
 *   lichenVulkanRecordUpload    into a command buffer of the host's, which it submits
 *   lichenVulkanReleaseStaging  when that submission has completed
 *   lichenVulkanAllocateSet     from a pool of the host's; or lichenVulkanGetImageInfos
 *   lichenVulkanDestroyAssets   when no submission uses them any more
 *
 * A context may be used by many threads. Calls on one LichenAssets object are the host's to order.
 */
#ifndef LICHEN_VULKAN_H
#define LICHEN_VULKAN_H

#include <lichen/lichen.h>

#include <vulkan/vulkan_core.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Everything that the plugin calls. */
typedef struct LichenVulkanFunctions {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  PFN_vkGetPhysicalDeviceMemoryProperties getPhysicalDeviceMemoryProperties;
  PFN_vkGetPhysicalDeviceFormatProperties getPhysicalDeviceFormatProperties;
  PFN_vkGetPhysicalDeviceImageFormatProperties getPhysicalDeviceImageFormatProperties;
  PFN_vkAllocateMemory allocateMemory;
  PFN_vkFreeMemory freeMemory;
  PFN_vkMapMemory mapMemory;
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
  PFN_vkCreateDescriptorSetLayout createDescriptorSetLayout;
  PFN_vkDestroyDescriptorSetLayout destroyDescriptorSetLayout;
  PFN_vkAllocateDescriptorSets allocateDescriptorSets;
  PFN_vkUpdateDescriptorSets updateDescriptorSets;
  PFN_vkCmdPipelineBarrier cmdPipelineBarrier;
  PFN_vkCmdCopyBufferToImage cmdCopyBufferToImage;
} LichenVulkanFunctions;

/* A piece of device memory that the host gives. */
typedef struct LichenDeviceMemory {
  VkDeviceMemory memory;
  VkDeviceSize offset; /* aligned as asked */
  void* mapped;        /* of this piece, where asked for: not of the start of `memory` */
  void* handle;        /* the host's own, handed back on release */
} LichenDeviceMemory;

/* The host's allocator of device memory. Called only inside lichenVulkanCreateAssets (allocate,
 * release), lichenVulkanReleaseStaging and lichenVulkanDestroyAssets (release). */
typedef struct LichenDeviceAllocator {
  void* userData;
  /* Memory for one buffer (with HOST_VISIBLE and HOST_COHERENT in `properties`, mapped) or for
   * optimally tiled images (DEVICE_LOCAL). VK_SUCCESS or the reason why not. */
  VkResult (*allocate)(void* userData, const VkMemoryRequirements* requirements,
                       VkMemoryPropertyFlags properties, LichenDeviceMemory* memory);
  void (*release)(void* userData, const LichenDeviceMemory* memory);
} LichenDeviceAllocator;

typedef enum LichenVulkanFlags {
  /* The uniform block is a VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC. */
  LICHEN_VULKAN_DYNAMIC_UNIFORMS = 1
} LichenVulkanFlags;

typedef struct LichenVulkanInfo {
  LichenStructureType type;
  uint32_t size;
  const void* next;
  uint32_t headerVersion; /* LICHEN_HEADER_VERSION */
  uint32_t flags;         /* LichenVulkanFlags */
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  /* Either the functions, or the loader's vkGetInstanceProcAddr and the device's instance. */
  const LichenVulkanFunctions* functions;
  PFN_vkGetInstanceProcAddr getInstanceProcAddr;
  VkInstance instance;
  const VkAllocationCallbacks* allocationCallbacks; /* of host memory; NULL: the driver's own */
  /* NULL: the plugin allocates one block for a bundle's images, of at least 1 MiB, and one for
   * its staging buffer. */
  const LichenDeviceAllocator* deviceAllocator;
  /* Above 1 only when the samplerAnisotropy feature is enabled, and at most the device's limit;
   * lichenFillUniforms wants the same value, the shaders LICHEN_ANISOTROPIC 1. 0 and 1: off. */
  float maxAnisotropy;
  uint32_t firstBinding;     /* LICHEN_FIRST_BINDING of the shaders */
  VkShaderStageFlags stages; /* that read the noise; 0: fragment and compute */
} LichenVulkanInfo;

typedef struct LichenVulkanContext_T* LichenVulkanContext;
typedef struct LichenVulkanAssets_T* LichenVulkanAssets;

/* Nothing that `info` points to is needed after the call, but for what its members stand for. */
LICHEN_API LichenResult lichenVulkanCreateContext(const LichenVulkanInfo* info,
                                                  LichenVulkanContext* context,
                                                  LichenDiagnostic* diagnostic);
/* After all its assets. NULL is ignored. */
LICHEN_API void lichenVulkanDestroyContext(LichenVulkanContext context);

/* Creates the bundle's images and fills a staging buffer; the bundle may be destroyed after. */
LICHEN_API LichenResult lichenVulkanCreateAssets(LichenVulkanContext context, LichenBundle bundle,
                                                 LichenVulkanAssets* assets,
                                                 LichenDiagnostic* diagnostic);
/* NULL is ignored. */
LICHEN_API void lichenVulkanDestroyAssets(LichenVulkanAssets assets);

/* Records the copies and their barriers, outside a render pass, in a command buffer of a queue
 * that can transfer. What runs later on that queue may sample the images in any stage. */
LICHEN_API LichenResult lichenVulkanRecordUpload(LichenVulkanAssets assets,
                                                 VkCommandBuffer commandBuffer);
/* Frees the staging buffer. May be called again; lichenVulkanDestroyAssets does it too. */
LICHEN_API void lichenVulkanReleaseStaging(LichenVulkanAssets assets);

/* The layout of a noise's set, owned by the assets. Noises with as many maps have compatible
 * ones. noise < noiseCount. */
LICHEN_API LichenResult lichenVulkanGetSetLayout(LichenVulkanAssets assets, uint32_t noise,
                                                 VkDescriptorSetLayout* layout);

/* A set from the host's pool, written with the noise's images and with `uniforms`: a uniform
 * buffer's range of at least LICHEN_UNIFORM_BYTES. The pool needs no FREE_DESCRIPTOR_SET; the set
 * is the host's. */
LICHEN_API LichenResult lichenVulkanAllocateSet(LichenVulkanAssets assets, uint32_t noise,
                                                VkDescriptorPool pool,
                                                const VkDescriptorBufferInfo* uniforms,
                                                VkDescriptorSet* set, LichenDiagnostic* diagnostic);

/* For hosts that write descriptors themselves: the noise's 2 * mapCount combined image samplers,
 * each map's Gaussian image and then its table, written to imageInfos[0 ... 2 * mapCount). */
LICHEN_API LichenResult lichenVulkanGetImageInfos(LichenVulkanAssets assets, uint32_t noise,
                                                  VkDescriptorImageInfo* imageInfos);

#ifdef __cplusplus
}
#endif

#endif
