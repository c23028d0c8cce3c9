// SPDX-License-Identifier: MIT
// The engine plugin on the renderer's device; see noise_context.h.
#include "noise_context.h"

#include "shaders/scene_interface.h"

namespace lichen::renderer {
namespace {

ErrorKind kindOf(LichenResult result) {
  switch (result) {
  case LICHEN_ERROR_VERSION:
  case LICHEN_ERROR_BAD_BUNDLE:
    return ErrorKind::badInput;
  case LICHEN_ERROR_OUT_OF_HOST_MEMORY:
  case LICHEN_ERROR_OUT_OF_DEVICE_MEMORY:
    return ErrorKind::resources;
  default:
    return ErrorKind::environment;
  }
}

} // namespace

void checkLichen(LichenResult result, const LichenDiagnostic& diagnostic, const std::string& file) {
  if (result != LICHEN_SUCCESS)
    throw Failure{{kindOf(result), (file.empty() ? "" : file + ": ") + diagnostic.text}};
}

void checkLichen(LichenResult result) {
  checkLichen(result, LichenDiagnostic{LICHEN_STRUCTURE_DIAGNOSTIC, sizeof(LichenDiagnostic),
                                       nullptr, "the noise plugin failed to answer a query"});
}

Result<void> fitsDescriptors(const VkPhysicalDeviceLimits& limits) {
  // The bindings of a frame but its block, the textures of a material, and two samplers of a noise.
  constexpr std::uint32_t kOwn = FRAME_BINDINGS - 1 + MATERIAL_TEXTURES;
  constexpr std::uint32_t kSamplers = kOwn + 2, kImages = kOwn + LICHEN_LAYERED_SET_IMAGES;
  const auto tooFew = [](const char* what, std::uint32_t has, std::uint32_t needed) {
    return Error{ErrorKind::environment, "this device has " + std::to_string(has) + " " + what +
                                             " a shader stage; the renderer needs " +
                                             std::to_string(needed)};
  };
  if (limits.maxPerStageDescriptorSamplers < kSamplers)
    return tooFew("samplers (maxPerStageDescriptorSamplers)", limits.maxPerStageDescriptorSamplers,
                  kSamplers);
  if (limits.maxPerStageDescriptorSampledImages < kImages)
    return tooFew("sampled images (maxPerStageDescriptorSampledImages)",
                  limits.maxPerStageDescriptorSampledImages, kImages);
  return {};
}

NoiseContext::NoiseContext(VulkanDevice& device) {
  take(fitsDescriptors(device.properties().limits));
  auto diagnostic = lichenStruct<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  auto info = lichenStruct<LichenVulkanInfo>(LICHEN_STRUCTURE_VULKAN_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  // One set of a noise serves all materials.
  info.flags = LICHEN_VULKAN_DYNAMIC_UNIFORMS | LICHEN_VULKAN_LAYERS;
  info.physicalDevice = device.physicalDevice();
  info.device = device.device();
  info.getInstanceProcAddr = vkGetInstanceProcAddr;
  info.instance = device.instance();
  info.stages = VK_SHADER_STAGE_ALL_GRAPHICS; // displaced vertices read the height
  LichenVulkanContext context = nullptr;
  checkLichen(lichenVulkanCreateContext(&info, &context, &diagnostic), diagnostic);
  context_.reset(context);
  checkLichen(lichenVulkanGetSetLayout(context, &setLayout_));
}

} // namespace lichen::renderer
