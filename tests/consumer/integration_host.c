/* SPDX-License-Identifier: MIT
 * The code of docs/integration.md: a test compares the two, another runs this. */
#include "integration_host.h"

LichenResult createContext(const Host* host, LichenVulkanContext* context,
                           VkDescriptorSetLayout* setLayout, LichenDiagnostic* diagnostic) {
  LichenVulkanInfo info;
  LichenResult result;
  LICHEN_INIT(info, LICHEN_STRUCTURE_VULKAN_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.flags = LICHEN_VULKAN_DYNAMIC_UNIFORMS; /* one set for all frames in flight */
  info.instance = host->instance;
  info.physicalDevice = host->physicalDevice;
  info.device = host->device;
  info.getInstanceProcAddr = host->getInstanceProcAddr; /* or info.functions */
  result = lichenVulkanCreateContext(&info, context, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanGetSetLayout(*context, setLayout); /* for your pipeline layouts */
  return result;
}

/* Records the upload into `commands`. Submit it before or with the first frame that draws. */
LichenResult loadBundle(LichenVulkanContext context, const void* file, size_t fileBytes,
                        VkCommandBuffer commands, NoiseBundle* loaded,
                        LichenDiagnostic* diagnostic) {
  LichenParseInfo parse;
  LichenResult result;
  memset(loaded, 0, sizeof *loaded);
  LICHEN_INIT(parse, LICHEN_STRUCTURE_PARSE_INFO);
  parse.headerVersion = LICHEN_HEADER_VERSION;
  parse.bytes = file; /* of `lichen bake` */
  parse.byteCount = fileBytes;

  result = lichenParseBundle(&parse, &loaded->bundle, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanCreateAssets(context, loaded->bundle, &loaded->assets, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanRecordUpload(loaded->assets, commands);
  if (result != LICHEN_SUCCESS)
    unloadBundle(loaded, 0); /* no frame has used it */
  return result;
}

/* When the upload has completed and all materials are added. */
void finishLoading(NoiseBundle* loaded) {
  lichenVulkanReleaseStaging(loaded->assets);
  lichenDestroyBundle(loaded->bundle);
  loaded->bundle = NULL;
}

void unloadBundle(NoiseBundle* loaded, uint64_t lastFrame) {
  lichenVulkanRetireAssets(loaded->assets, lastFrame);
  lichenDestroyBundle(loaded->bundle);
  memset(loaded, 0, sizeof *loaded);
}

/* Each material has its own `slot` of the uniform buffer. */
LichenResult addMaterial(const Host* host, const NoiseBundle* loaded, uint32_t index, uint32_t slot,
                         NoiseMaterial* material, LichenDiagnostic* diagnostic) {
  /* Each draw adds its dynamic offset to this offset of 0. */
  const VkDescriptorBufferInfo block = {host->uniformBuffer, 0, LICHEN_TRIPLANAR_MATERIAL_BYTES};
  LichenMaterialProperties properties;
  LichenResult result;
  memset(material, 0, sizeof *material);
  material->slot = slot;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
  LICHEN_INIT(material->parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  LICHEN_INIT(material->placement, LICHEN_STRUCTURE_PLACEMENT);

  result = lichenGetMaterialProperties(loaded->bundle, index, &properties);
  /* This host draws a material without a noise, or of another mapping, with its core textures. */
  if (result == LICHEN_SUCCESS &&
      (properties.noise == LICHEN_NO_NOISE || properties.mapping != LICHEN_MAPPING_UV))
    result = LICHEN_ERROR_UNSUPPORTED;
  if (result == LICHEN_SUCCESS)
    result = lichenGetMaterialParameters(loaded->bundle, index, &material->parameters);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanAllocateSet(loaded->assets, properties.noise, host->pool, &block,
                                     &material->set, diagnostic);
  return result;
}

LichenResult updateMaterial(const Host* host, const NoiseMaterial* material, uint32_t frameInFlight,
                            uint32_t* dynamicOffset, LichenDiagnostic* diagnostic) {
  *dynamicOffset = (material->slot * host->framesInFlight + frameInFlight) * BLOCK_STRIDE;
  return lichenFillMaterial(&material->parameters, &material->placement,
                            host->mappedUniforms + *dynamicOffset, diagnostic);
}
