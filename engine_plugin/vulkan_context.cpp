// SPDX-License-Identifier: MIT
// Creates what is needed once per device: function pointers and samplers.
#include "abi.h"
#include "vulkan_objects.h"

#include <array>
#include <lichen_interface.h>
#include <memory>
#include <utility>

using namespace lichen::plugin;

namespace {

template <class Function>
void load(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, const char* name,
          Function& function) {
  function = reinterpret_cast<Function>(getInstanceProcAddr(instance, name));
}

/// Gets every function from the loader, whose entry points serve any device.
LichenVulkanFunctions loadFunctions(PFN_vkGetInstanceProcAddr get, VkInstance instance) {
  LichenVulkanFunctions f{};
  load(get, instance, "vkGetPhysicalDeviceMemoryProperties", f.getPhysicalDeviceMemoryProperties);
  load(get, instance, "vkGetPhysicalDeviceFormatProperties", f.getPhysicalDeviceFormatProperties);
  load(get, instance, "vkGetPhysicalDeviceImageFormatProperties",
       f.getPhysicalDeviceImageFormatProperties);
  load(get, instance, "vkAllocateMemory", f.allocateMemory);
  load(get, instance, "vkFreeMemory", f.freeMemory);
  load(get, instance, "vkMapMemory", f.mapMemory);
  load(get, instance, "vkCreateBuffer", f.createBuffer);
  load(get, instance, "vkDestroyBuffer", f.destroyBuffer);
  load(get, instance, "vkGetBufferMemoryRequirements", f.getBufferMemoryRequirements);
  load(get, instance, "vkBindBufferMemory", f.bindBufferMemory);
  load(get, instance, "vkCreateImage", f.createImage);
  load(get, instance, "vkDestroyImage", f.destroyImage);
  load(get, instance, "vkGetImageMemoryRequirements", f.getImageMemoryRequirements);
  load(get, instance, "vkBindImageMemory", f.bindImageMemory);
  load(get, instance, "vkCreateImageView", f.createImageView);
  load(get, instance, "vkDestroyImageView", f.destroyImageView);
  load(get, instance, "vkCreateSampler", f.createSampler);
  load(get, instance, "vkDestroySampler", f.destroySampler);
  load(get, instance, "vkCreateDescriptorSetLayout", f.createDescriptorSetLayout);
  load(get, instance, "vkDestroyDescriptorSetLayout", f.destroyDescriptorSetLayout);
  load(get, instance, "vkAllocateDescriptorSets", f.allocateDescriptorSets);
  load(get, instance, "vkUpdateDescriptorSets", f.updateDescriptorSets);
  load(get, instance, "vkCmdPipelineBarrier", f.cmdPipelineBarrier);
  load(get, instance, "vkCmdCopyBufferToImage", f.cmdCopyBufferToImage);
  load(get, instance, "vkCmdCopyBuffer", f.cmdCopyBuffer);
  return f;
}

/// What every host needs.
bool hasImagesAndCopies(const LichenVulkanFunctions& f) {
  return f.getPhysicalDeviceFormatProperties && f.getPhysicalDeviceImageFormatProperties &&
         f.createBuffer && f.destroyBuffer && f.getBufferMemoryRequirements && f.bindBufferMemory &&
         f.createImage && f.destroyImage && f.getImageMemoryRequirements && f.bindImageMemory &&
         f.createImageView && f.destroyImageView && f.createSampler && f.destroySampler &&
         f.cmdPipelineBarrier && f.cmdCopyBufferToImage && f.cmdCopyBuffer;
}

bool hasMemory(const LichenVulkanFunctions& f) {
  return f.getPhysicalDeviceMemoryProperties && f.allocateMemory && f.freeMemory && f.mapMemory;
}

int countOfSets(const LichenVulkanFunctions& f) {
  return int(f.createDescriptorSetLayout != nullptr) +
         int(f.destroyDescriptorSetLayout != nullptr) + int(f.allocateDescriptorSets != nullptr) +
         int(f.updateDescriptorSets != nullptr);
}

LichenResult findFunctions(const LichenVulkanInfo& info, LichenVulkanFunctions& functions,
                           LichenDiagnostic* diagnostic) {
  if (info.functions != nullptr) {
    const LichenResult result =
        readStruct(info.functions, LICHEN_STRUCTURE_VULKAN_FUNCTIONS, functions, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
  } else if (info.getInstanceProcAddr != nullptr && info.instance != VK_NULL_HANDLE) {
    functions = loadFunctions(info.getInstanceProcAddr, info.instance);
  }
  constexpr int kAllOfSets = 4;
  const int ofSets = countOfSets(functions);
  if (hasImagesAndCopies(functions) && (hasMemory(functions) || info.deviceAllocator != nullptr) &&
      (ofSets == 0 || ofSets == kAllOfSets))
    return LICHEN_SUCCESS;
  writeDiagnostic(diagnostic,
                  "Vulkan functions are missing; set getInstanceProcAddr and instance, or all of "
                  "LichenVulkanFunctions; with a deviceAllocator the functions for memory may be "
                  "NULL, and the functions for sets may all be NULL");
  return LICHEN_ERROR_USAGE;
}

LichenResult checkInfo(const LichenVulkanInfo& info, LichenDiagnostic* diagnostic) {
  if (info.device == VK_NULL_HANDLE || info.physicalDevice == VK_NULL_HANDLE) {
    writeDiagnostic(diagnostic, "physicalDevice and device must not be VK_NULL_HANDLE");
    return LICHEN_ERROR_USAGE;
  }
  constexpr std::uint32_t kFlags = LICHEN_VULKAN_DYNAMIC_UNIFORMS | LICHEN_VULKAN_LAYERS;
  if (info.flags & ~kFlags) {
    writeDiagnostic(diagnostic, "flags 0x%x has unknown bits; the LichenVulkanFlags bits are 0x%x",
                    info.flags, kFlags);
    return LICHEN_ERROR_USAGE;
  }
  if (!(info.maxAnisotropy >= 0.0f && double(info.maxAnisotropy) <= kMostAnisotropy)) {
    writeDiagnostic(diagnostic, "maxAnisotropy %g is out of range; expected 0 to %g",
                    double(info.maxAnisotropy), kMostAnisotropy);
    return LICHEN_ERROR_USAGE;
  }
  const bool hasLayers = (info.flags & LICHEN_VULKAN_LAYERS) != 0;
  const std::uint32_t bindings = hasLayers ? LICHEN_LAYERED_SET_BINDINGS : LICHEN_SET_BINDINGS;
  if (info.firstBinding > UINT32_MAX - bindings) {
    writeDiagnostic(diagnostic,
                    "firstBinding %u is too large; a noise needs %u consecutive binding numbers",
                    info.firstBinding, bindings);
    return LICHEN_ERROR_USAGE;
  }
  return LICHEN_SUCCESS;
}

LichenResult findAllocator(const LichenVulkanInfo& info, LichenVulkanContext_T& context,
                           LichenDiagnostic* diagnostic) {
  if (info.deviceAllocator == nullptr)
    return LICHEN_SUCCESS;
  context.hostAllocates = true;
  const LichenResult result = readStruct(info.deviceAllocator, LICHEN_STRUCTURE_DEVICE_ALLOCATOR,
                                         context.allocator, diagnostic);
  if (result != LICHEN_SUCCESS || (context.allocator.allocate && context.allocator.release))
    return result;
  writeDiagnostic(diagnostic, "deviceAllocator needs both allocate and release");
  return LICHEN_ERROR_USAGE;
}

VkResult createSampler(LichenVulkanContext_T& context, LichenSamplerUse use, float maxAnisotropy) {
  LichenSamplerProperties properties;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_SAMPLER_PROPERTIES);
  if (lichenGetSamplerProperties(use, &properties) != LICHEN_SUCCESS)
    return VK_ERROR_UNKNOWN;
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = info.minFilter = VkFilter(properties.vkFilter);
  info.mipmapMode = VkSamplerMipmapMode(properties.vkMipmapMode);
  info.addressModeU = info.addressModeV = info.addressModeW =
      VkSamplerAddressMode(properties.vkAddressMode);
  info.maxLod = properties.maxLod;
  if (properties.takesAnisotropy && maxAnisotropy > 1.0f) {
    info.anisotropyEnable = VK_TRUE;
    info.maxAnisotropy = maxAnisotropy;
  }
  return create(context, context.functions.createSampler, info, context.samplers[use]);
}

/// The layout of every noise's set.
VkResult createSetLayout(LichenVulkanContext_T& context) {
  std::array<VkDescriptorSetLayoutBinding, LICHEN_LAYERED_SET_BINDINGS> bindings{};
  for (std::uint32_t i = 0; i < LICHEN_LAYERED_SET_BINDINGS; ++i) {
    bindings[i].binding = context.firstBinding + i;
    bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = context.stages;
  }
  bindings[LICHEN_BINDING_NOISE].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  bindings[LICHEN_BINDING_MATERIAL].descriptorType = context.materialType;
  for (const auto& [binding, use] : {std::pair{LICHEN_BINDING_IMAGE_SAMPLER, LICHEN_SAMPLER_IMAGE},
                                     {LICHEN_BINDING_TABLE_SAMPLER, LICHEN_SAMPLER_TABLE}}) {
    bindings[std::size_t(binding)].descriptorType = VK_DESCRIPTOR_TYPE_SAMPLER;
    bindings[std::size_t(binding)].pImmutableSamplers = &context.samplers[use];
  }
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = context.hasLayers ? LICHEN_LAYERED_SET_BINDINGS : LICHEN_SET_BINDINGS;
  info.pBindings = bindings.data();
  return create(context, context.functions.createDescriptorSetLayout, info, context.setLayout);
}

} // namespace

namespace lichen::plugin {

LichenResult vulkanFailure(const char* what, VkResult result, LichenDiagnostic* diagnostic) {
  switch (result) {
  case VK_ERROR_OUT_OF_HOST_MEMORY:
    writeDiagnostic(diagnostic, "%s: out of host memory", what);
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  case VK_ERROR_MEMORY_MAP_FAILED: // no free address range
    writeDiagnostic(diagnostic, "%s: cannot map it into host memory", what);
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    writeDiagnostic(diagnostic, "%s: out of device memory", what);
    return LICHEN_ERROR_OUT_OF_DEVICE_MEMORY;
  case VK_ERROR_TOO_MANY_OBJECTS:
    writeDiagnostic(diagnostic,
                    "%s: more objects than the device allows; destroy some, or set a "
                    "deviceAllocator that takes memory from larger blocks",
                    what);
    return LICHEN_ERROR_OUT_OF_DEVICE_MEMORY;
  case VK_ERROR_OUT_OF_POOL_MEMORY:
  case VK_ERROR_FRAGMENTED_POOL:
    writeDiagnostic(diagnostic,
                    "%s: the descriptor pool is too small: a set takes 2 uniform buffers, 2 "
                    "samplers and %d sampled images, with LICHEN_VULKAN_LAYERS %d",
                    what, LICHEN_SET_IMAGES, LICHEN_LAYERED_SET_IMAGES);
    return LICHEN_ERROR_OUT_OF_POOL_MEMORY;
  default:
    writeDiagnostic(diagnostic, "%s: VkResult %d", what, int(result));
    return LICHEN_ERROR_DEVICE;
  }
}

} // namespace lichen::plugin

LichenResult lichenVulkanCreateContext(const LichenVulkanInfo* hostInfo,
                                       LichenVulkanContext* context, LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    if (context == nullptr) {
      writeDiagnostic(diagnostic, "context must not be NULL");
      return LICHEN_ERROR_USAGE;
    }
    LichenVulkanInfo info{};
    auto newContext = std::make_unique<LichenVulkanContext_T>();
    LichenResult result = readStruct(hostInfo, LICHEN_STRUCTURE_VULKAN_INFO, info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkHeaderVersion(info.headerVersion, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkInfo(info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = findFunctions(info, newContext->functions, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = findAllocator(info, *newContext, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
    newContext->physicalDevice = info.physicalDevice;
    newContext->device = info.device;
    if (info.allocationCallbacks != nullptr) {
      newContext->ownCallbacks = *info.allocationCallbacks;
      newContext->callbacks = &newContext->ownCallbacks;
    }
    if (!newContext->hostAllocates)
      newContext->functions.getPhysicalDeviceMemoryProperties(info.physicalDevice,
                                                              &newContext->memory);
    newContext->hasLayers = (info.flags & LICHEN_VULKAN_LAYERS) != 0;
    newContext->materialType = (info.flags & LICHEN_VULKAN_DYNAMIC_UNIFORMS)
                                   ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC
                                   : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    newContext->firstBinding = info.firstBinding;
    newContext->stages =
        info.stages != 0 ? info.stages : VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
    VkResult created = createSampler(*newContext, LICHEN_SAMPLER_IMAGE, info.maxAnisotropy);
    if (created == VK_SUCCESS)
      created = createSampler(*newContext, LICHEN_SAMPLER_TABLE, info.maxAnisotropy);
    if (created != VK_SUCCESS) {
      lichenVulkanDestroyContext(newContext.release());
      return vulkanFailure("creating a sampler", created, diagnostic);
    }
    if (newContext->functions.createDescriptorSetLayout != nullptr)
      created = createSetLayout(*newContext);
    if (created != VK_SUCCESS) {
      lichenVulkanDestroyContext(newContext.release());
      return vulkanFailure("creating a descriptor set layout", created, diagnostic);
    }
    *context = newContext.release();
    return LICHEN_SUCCESS;
  });
}

void lichenVulkanDestroyContext(LichenVulkanContext context) {
  if (context == nullptr)
    return;
  lichenVulkanFrameCompleted(context, UINT64_MAX);
  if (context->setLayout != VK_NULL_HANDLE)
    context->functions.destroyDescriptorSetLayout(context->device, context->setLayout,
                                                  context->callbacks);
  for (const VkSampler sampler : context->samplers)
    context->functions.destroySampler(context->device, sampler, context->callbacks);
  delete context;
}

LichenResult lichenVulkanGetSetLayout(LichenVulkanContext context, VkDescriptorSetLayout* layout) {
  if (context == nullptr || layout == nullptr || context->setLayout == VK_NULL_HANDLE)
    return LICHEN_ERROR_USAGE;
  *layout = context->setLayout;
  return LICHEN_SUCCESS;
}

LichenResult lichenVulkanGetSamplers(LichenVulkanContext context, VkSampler* images,
                                     VkSampler* tables) {
  if (context == nullptr || images == nullptr || tables == nullptr)
    return LICHEN_ERROR_USAGE;
  *images = context->samplers[LICHEN_SAMPLER_IMAGE];
  *tables = context->samplers[LICHEN_SAMPLER_TABLE];
  return LICHEN_SUCCESS;
}
