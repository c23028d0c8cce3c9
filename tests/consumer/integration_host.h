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
  VkBuffer uniformBuffer; /* a block of LICHEN_UNIFORM_BYTES for each frame in flight */
  unsigned char* mappedUniforms;
} Host;

/* What it keeps of a noise material. */
typedef struct NoiseMaterial {
  uint32_t index; /* of the glTF material */
  LichenBundle bundle;
  LichenVulkanAssets assets;
  VkDescriptorSetLayout setLayout; /* for the pipeline layout */
  VkDescriptorSet set;
} NoiseMaterial;

LichenResult createContext(const Host* host, LichenVulkanContext* context,
                           LichenDiagnostic* diagnostic);
LichenResult loadMaterial(const Host* host, LichenVulkanContext context, const void* file,
                          size_t fileBytes, uint32_t index, VkCommandBuffer commands,
                          NoiseMaterial* material, LichenDiagnostic* diagnostic);
void unloadMaterial(NoiseMaterial* material, uint64_t lastFrame);
LichenResult updateMaterial(const Host* host, const NoiseMaterial* material, uint32_t frameInFlight,
                            const int64_t cameraTile[2], uint32_t* dynamicOffset,
                            LichenDiagnostic* diagnostic);

#ifdef __cplusplus
}
#endif

#endif
