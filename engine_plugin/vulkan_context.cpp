// SPDX-License-Identifier: MIT
// What is made once per device: the functions, the samplers, the way to device memory.
#include "abi.h"
#include "vulkan_objects.h"

#include <memory>

using namespace lichen::plugin;

namespace {

template <class Function>
void load(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, const char* name,
          Function& function) {
  function = reinterpret_cast<Function>(getInstanceProcAddr(instance, name));
}

/// Every function by the loader, which answers with entry points that serve any device.
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
  return f;
}

bool allPresent(const LichenVulkanFunctions& f) {
  return f.getPhysicalDeviceMemoryProperties && f.getPhysicalDeviceFormatProperties &&
         f.getPhysicalDeviceImageFormatProperties && f.allocateMemory && f.freeMemory &&
         f.mapMemory && f.createBuffer && f.destroyBuffer && f.getBufferMemoryRequirements &&
         f.bindBufferMemory && f.createImage && f.destroyImage && f.getImageMemoryRequirements &&
         f.bindImageMemory && f.createImageView && f.destroyImageView && f.createSampler &&
         f.destroySampler && f.createDescriptorSetLayout && f.destroyDescriptorSetLayout &&
         f.allocateDescriptorSets && f.updateDescriptorSets && f.cmdPipelineBarrier &&
         f.cmdCopyBufferToImage;
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
  if (allPresent(functions))
    return LICHEN_SUCCESS;
  say(diagnostic, "Vulkan functions are missing: give all of LichenVulkanFunctions, or "
                  "getInstanceProcAddr and instance");
  return LICHEN_ERROR_USAGE;
}

LichenResult checkInfo(const LichenVulkanInfo& info, LichenDiagnostic* diagnostic) {
  if (info.device == VK_NULL_HANDLE || info.physicalDevice == VK_NULL_HANDLE) {
    say(diagnostic, "physicalDevice and device must not be VK_NULL_HANDLE");
    return LICHEN_ERROR_USAGE;
  }
  if (info.flags & ~std::uint32_t(LICHEN_VULKAN_DYNAMIC_UNIFORMS)) {
    say(diagnostic, "flags 0x%x: only LichenVulkanFlags are accepted", info.flags);
    return LICHEN_ERROR_USAGE;
  }
  if (!(info.maxAnisotropy >= 0.0f)) {
    say(diagnostic, "maxAnisotropy %g must not be negative", double(info.maxAnisotropy));
    return LICHEN_ERROR_USAGE;
  }
  if (info.deviceAllocator != nullptr &&
      (info.deviceAllocator->allocate == nullptr || info.deviceAllocator->release == nullptr)) {
    say(diagnostic, "deviceAllocator needs both allocate and release");
    return LICHEN_ERROR_USAGE;
  }
  return LICHEN_SUCCESS;
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
  return context.functions.createSampler(context.device, &info, context.callbacks,
                                         &context.samplers[use]);
}

/// The largest of the plugin's wishes and one mebibyte: drivers allow few allocations.
constexpr VkDeviceSize kLeastBlockBytes = VkDeviceSize(1) << 20;

VkResult allocateBlock(const LichenVulkanContext_T& context,
                       const VkMemoryRequirements& requirements, VkMemoryPropertyFlags properties,
                       LichenDeviceMemory& memory) {
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = std::max(requirements.size, kLeastBlockBytes);
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  for (std::uint32_t type = 0; type < context.memory.memoryTypeCount; ++type) {
    if ((requirements.memoryTypeBits & (1u << type)) == 0 ||
        (context.memory.memoryTypes[type].propertyFlags & properties) != properties)
      continue;
    info.memoryTypeIndex = type;
    LichenDeviceMemory block{};
    result =
        context.functions.allocateMemory(context.device, &info, context.callbacks, &block.memory);
    if (result != VK_SUCCESS)
      continue; // another heap may have room
    if (properties & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
      result = context.functions.mapMemory(context.device, block.memory, 0, VK_WHOLE_SIZE, 0,
                                           &block.mapped);
    if (result == VK_SUCCESS)
      memory = block;
    else
      context.functions.freeMemory(context.device, block.memory, context.callbacks);
    return result;
  }
  return result;
}

} // namespace

namespace lichen::plugin {

LichenResult vulkanFailure(const char* what, VkResult result, LichenDiagnostic* diagnostic) {
  switch (result) {
  case VK_ERROR_OUT_OF_HOST_MEMORY:
    say(diagnostic, "%s: out of host memory", what);
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    say(diagnostic, "%s: out of device memory", what);
    return LICHEN_ERROR_OUT_OF_DEVICE_MEMORY;
  case VK_ERROR_OUT_OF_POOL_MEMORY:
  case VK_ERROR_FRAGMENTED_POOL:
    say(diagnostic,
        "%s: the descriptor pool is too small; lichenGetNoiseProperties tells what a "
        "set takes",
        what);
    return LICHEN_ERROR_OUT_OF_DEVICE_MEMORY;
  default:
    say(diagnostic, "%s: VkResult %d", what, int(result));
    return LICHEN_ERROR_DEVICE;
  }
}

VkResult allocateMemory(const LichenVulkanContext_T& context,
                        const VkMemoryRequirements& requirements, VkMemoryPropertyFlags properties,
                        LichenDeviceMemory& memory) {
  if (context.hostAllocates)
    return context.allocator.allocate(context.allocator.userData, &requirements, properties,
                                      &memory);
  return allocateBlock(context, requirements, properties, memory);
}

void releaseMemory(const LichenVulkanContext_T& context, const LichenDeviceMemory& memory) {
  if (context.hostAllocates)
    context.allocator.release(context.allocator.userData, &memory);
  else
    context.functions.freeMemory(context.device, memory.memory, context.callbacks);
}

} // namespace lichen::plugin

LichenResult lichenVulkanCreateContext(const LichenVulkanInfo* given, LichenVulkanContext* context,
                                       LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    LichenVulkanInfo info{};
    LichenVulkanFunctions functions{};
    LichenResult result = readStruct(given, LICHEN_STRUCTURE_VULKAN_INFO, info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkHeaderVersion(info.headerVersion, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkInfo(info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = findFunctions(info, functions, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
    auto made = std::make_unique<LichenVulkanContext_T>();
    made->functions = functions;
    made->physicalDevice = info.physicalDevice;
    made->device = info.device;
    if (info.allocationCallbacks != nullptr) {
      made->ownCallbacks = *info.allocationCallbacks;
      made->callbacks = &made->ownCallbacks;
    }
    if (info.deviceAllocator != nullptr) {
      made->allocator = *info.deviceAllocator;
      made->hostAllocates = true;
    }
    made->functions.getPhysicalDeviceMemoryProperties(info.physicalDevice, &made->memory);
    made->uniformType = (info.flags & LICHEN_VULKAN_DYNAMIC_UNIFORMS)
                            ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC
                            : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    made->firstBinding = info.firstBinding;
    made->stages =
        info.stages != 0 ? info.stages : VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
    VkResult created = createSampler(*made, LICHEN_SAMPLER_GAUSSIAN, info.maxAnisotropy);
    if (created == VK_SUCCESS)
      created = createSampler(*made, LICHEN_SAMPLER_TABLE, info.maxAnisotropy);
    if (created != VK_SUCCESS) {
      lichenVulkanDestroyContext(made.release());
      return vulkanFailure("creating a sampler", created, diagnostic);
    }
    *context = made.release();
    return LICHEN_SUCCESS;
  });
}

void lichenVulkanDestroyContext(LichenVulkanContext context) {
  if (context == nullptr)
    return;
  for (const VkSampler sampler : context->samplers)
    context->functions.destroySampler(context->device, sampler, context->callbacks);
  delete context;
}
