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
  VkBuffer uniformBuffer; /* each slot has framesInFlight blocks of LICHEN_UNIFORM_BYTES */
  unsigned char* mappedUniforms;
} Host;

/* What it keeps of a bundle. */
typedef struct NoiseBundle {
  LichenBundle bundle;
  LichenVulkanAssets assets;
} NoiseBundle;

/* What it keeps of a noise material in a bundle. */
typedef struct NoiseMaterial {
  uint32_t index;                  /* of the glTF material */
  uint32_t slot;                   /* of the uniform buffer */
  VkDescriptorSetLayout setLayout; /* for the pipeline layout */
  VkDescriptorSet set;
} NoiseMaterial;

LichenResult createContext(const Host* host, LichenVulkanContext* context,
                           LichenDiagnostic* diagnostic);
LichenResult loadBundle(LichenVulkanContext context, const void* file, size_t fileBytes,
                        VkCommandBuffer commands, NoiseBundle* loaded,
                        LichenDiagnostic* diagnostic);
void unloadBundle(NoiseBundle* loaded, uint64_t lastFrame);
LichenResult addMaterial(const Host* host, const NoiseBundle* loaded, uint32_t index, uint32_t slot,
                         NoiseMaterial* material, LichenDiagnostic* diagnostic);
LichenResult updateMaterial(const Host* host, const NoiseBundle* loaded,
                            const NoiseMaterial* material, uint32_t frameInFlight,
                            const int64_t cameraTile[2], uint32_t* dynamicOffset,
                            LichenDiagnostic* diagnostic);

#ifdef __cplusplus
}
#endif

#endif
