/* SPDX-License-Identifier: MIT
 * The code of docs/integration.md: a test compares the two, another runs this. */
#include "integration_host.h"

LichenResult createContext(const Host* host, LichenVulkanContext* context,
                           LichenDiagnostic* diagnostic) {
  LichenVulkanInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_VULKAN_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.flags = LICHEN_VULKAN_DYNAMIC_UNIFORMS; /* one set for all frames in flight */
  info.instance = host->instance;
  info.physicalDevice = host->physicalDevice;
  info.device = host->device;
  info.getInstanceProcAddr = host->getInstanceProcAddr; /* or info.functions */
  return lichenVulkanCreateContext(&info, context, diagnostic);
}

/* Records the upload into `commands`: submit it before or with the first frame that draws. */
LichenResult loadMaterial(const Host* host, LichenVulkanContext context, const void* file,
                          size_t fileBytes, uint32_t index, VkCommandBuffer commands,
                          NoiseMaterial* material, LichenDiagnostic* diagnostic) {
  const VkDescriptorBufferInfo uniforms = {host->uniformBuffer, 0, LICHEN_UNIFORM_BYTES};
  LichenParseInfo parse;
  LichenMaterialProperties properties;
  LichenResult result;
  memset(material, 0, sizeof *material);
  material->index = index;
  LICHEN_INIT(parse, LICHEN_STRUCTURE_PARSE_INFO);
  parse.headerVersion = LICHEN_HEADER_VERSION;
  parse.bytes = file; /* a .glb that `lichen bake` wrote */
  parse.byteCount = fileBytes;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);

  result = lichenParseBundle(&parse, &material->bundle, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenGetMaterialProperties(material->bundle, index, &properties);
  /* LICHEN_NO_NOISE: draw it as any other material. Other mappings are not evaluated yet. */
  if (result == LICHEN_SUCCESS &&
      (properties.noise == LICHEN_NO_NOISE || properties.mapping != LICHEN_MAPPING_UV))
    result = LICHEN_ERROR_UNSUPPORTED;
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanCreateAssets(context, material->bundle, &material->assets, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanGetSetLayout(material->assets, properties.noise, &material->setLayout);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanAllocateSet(material->assets, properties.noise, host->pool, &uniforms,
                                     &material->set, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanRecordUpload(material->assets, commands);
  if (result != LICHEN_SUCCESS)
    unloadMaterial(material, 0); /* no frame has used it */
  return result;
}

void unloadMaterial(NoiseMaterial* material, uint64_t lastFrame) {
  lichenVulkanRetireAssets(material->assets, lastFrame);
  lichenDestroyBundle(material->bundle);
  memset(material, 0, sizeof *material);
}

LichenResult updateMaterial(const Host* host, const NoiseMaterial* material, uint32_t frameInFlight,
                            const int64_t cameraTile[2], uint32_t* dynamicOffset,
                            LichenDiagnostic* diagnostic) {
  LichenUniformInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_UNIFORM_INFO);
  info.material = material->index;
  info.tileOrigin[0] = cameraTile[0]; /* far from the origin: see below */
  info.tileOrigin[1] = cameraTile[1];
  *dynamicOffset = frameInFlight * LICHEN_UNIFORM_BYTES;
  return lichenFillUniforms(material->bundle, &info, host->mappedUniforms + *dynamicOffset,
                            diagnostic);
}
