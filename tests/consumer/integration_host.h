/* SPDX-License-Identifier: MIT
 * The host of docs/integration.md, which quotes integration_host.c: C99, to be copied. */
#ifndef LICHEN_INTEGRATION_HOST_H
#define LICHEN_INTEGRATION_HOST_H

#include <lichen/lichen_vulkan.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the engine has anyway. */
typedef struct Host {
  VkInstance instance;
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  PFN_vkGetInstanceProcAddr getInstanceProcAddr;
  VkDescriptorPool pool;
  uint32_t framesInFlight;
  VkBuffer uniformBuffer; /* each slot has framesInFlight blocks of BLOCK_STRIDE bytes */
  unsigned char* mappedUniforms;
} Host;

/* A multiple of the device's minUniformBufferOffsetAlignment, which is 256 at most. */
#define BLOCK_STRIDE 256u

/* What it keeps of a bundle. */
typedef struct NoiseBundle {
  LichenBundle bundle; /* NULL after finishLoading() */
  LichenVulkanAssets assets;
} NoiseBundle;

/* What it keeps of a noise material in a bundle. */
typedef struct NoiseMaterial {
  uint32_t slot; /* of the uniform buffer */
  VkDescriptorSet set;
  LichenMaterialParameters parameters; /* change these two as you like */
  LichenPlacement placement;
} NoiseMaterial;

LichenResult createContext(const Host* host, LichenVulkanContext* context,
                           VkDescriptorSetLayout* setLayout, LichenDiagnostic* diagnostic);
LichenResult loadBundle(LichenVulkanContext context, const void* file, size_t fileBytes,
                        VkCommandBuffer commands, NoiseBundle* loaded,
                        LichenDiagnostic* diagnostic);
void finishLoading(NoiseBundle* loaded);
void unloadBundle(NoiseBundle* loaded, uint64_t lastFrame);
LichenResult addMaterial(const Host* host, const NoiseBundle* loaded, uint32_t index, uint32_t slot,
                         NoiseMaterial* material, LichenDiagnostic* diagnostic);
LichenResult updateMaterial(const Host* host, const NoiseMaterial* material, uint32_t frameInFlight,
                            uint32_t* dynamicOffset, LichenDiagnostic* diagnostic);

#ifdef __cplusplus
}
#endif

#endif
