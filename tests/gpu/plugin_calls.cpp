// SPDX-License-Identifier: MIT
// Proxies between the plugin and the device; see plugin_calls.h.
#include "plugin_calls.h"

namespace lichen::test {

LichenVulkanFunctions loadedFunctions() {
  LichenVulkanFunctions f;
  LICHEN_INIT(f, LICHEN_STRUCTURE_VULKAN_FUNCTIONS);
  f.getPhysicalDeviceMemoryProperties = vkGetPhysicalDeviceMemoryProperties;
  f.getPhysicalDeviceFormatProperties = vkGetPhysicalDeviceFormatProperties;
  f.getPhysicalDeviceImageFormatProperties = vkGetPhysicalDeviceImageFormatProperties;
  f.allocateMemory = vkAllocateMemory;
  f.freeMemory = vkFreeMemory;
  f.mapMemory = vkMapMemory;
  f.createBuffer = vkCreateBuffer;
  f.destroyBuffer = vkDestroyBuffer;
  f.getBufferMemoryRequirements = vkGetBufferMemoryRequirements;
  f.bindBufferMemory = vkBindBufferMemory;
  f.createImage = vkCreateImage;
  f.destroyImage = vkDestroyImage;
  f.getImageMemoryRequirements = vkGetImageMemoryRequirements;
  f.bindImageMemory = vkBindImageMemory;
  f.createImageView = vkCreateImageView;
  f.destroyImageView = vkDestroyImageView;
  f.createSampler = vkCreateSampler;
  f.destroySampler = vkDestroySampler;
  f.createDescriptorSetLayout = vkCreateDescriptorSetLayout;
  f.destroyDescriptorSetLayout = vkDestroyDescriptorSetLayout;
  f.allocateDescriptorSets = vkAllocateDescriptorSets;
  f.updateDescriptorSets = vkUpdateDescriptorSets;
  f.cmdPipelineBarrier = vkCmdPipelineBarrier;
  f.cmdCopyBufferToImage = vkCmdCopyBufferToImage;
  f.cmdCopyBuffer = vkCmdCopyBuffer;
  return f;
}

LichenVulkanFunctions Proxy::functions() {
  LichenVulkanFunctions f;
  LICHEN_INIT(f, LICHEN_STRUCTURE_VULKAN_FUNCTIONS);
  f.getPhysicalDeviceMemoryProperties = pass<&vkGetPhysicalDeviceMemoryProperties>;
  f.getPhysicalDeviceFormatProperties = pass<&vkGetPhysicalDeviceFormatProperties>;
  f.getPhysicalDeviceImageFormatProperties = call<&vkGetPhysicalDeviceImageFormatProperties>;
  f.allocateMemory = allocate;
  f.freeMemory = destroy<&vkFreeMemory>;
  f.mapMemory = map;
  f.createBuffer = create<&vkCreateBuffer>;
  f.destroyBuffer = destroy<&vkDestroyBuffer>;
  f.getBufferMemoryRequirements = pass<&vkGetBufferMemoryRequirements>;
  f.bindBufferMemory = call<&vkBindBufferMemory>;
  f.createImage = create<&vkCreateImage>;
  f.destroyImage = destroy<&vkDestroyImage>;
  f.getImageMemoryRequirements = pass<&vkGetImageMemoryRequirements>;
  f.bindImageMemory = call<&vkBindImageMemory>;
  f.createImageView = create<&vkCreateImageView>;
  f.destroyImageView = destroy<&vkDestroyImageView>;
  f.createSampler = create<&vkCreateSampler>;
  f.destroySampler = destroy<&vkDestroySampler>;
  f.createDescriptorSetLayout = create<&vkCreateDescriptorSetLayout>;
  f.destroyDescriptorSetLayout = destroy<&vkDestroyDescriptorSetLayout>;
  f.allocateDescriptorSets = allocateSets;
  f.updateDescriptorSets = pass<&vkUpdateDescriptorSets>;
  f.cmdPipelineBarrier = pass<&vkCmdPipelineBarrier>;
  f.cmdCopyBufferToImage = pass<&vkCmdCopyBufferToImage>;
  f.cmdCopyBuffer = pass<&vkCmdCopyBuffer>;
  return f;
}

VkResult VKAPI_CALL Proxy::allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                    const VkAllocationCallbacks* callbacks,
                                    VkDeviceMemory* memory) {
  if (exhausted) {
    fillWithGarbage(memory);
    return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  }
  const VkResult result = create<&vkAllocateMemory>(device, info, callbacks, memory);
  exhausted = result != VK_SUCCESS;
  return result;
}

VkResult VKAPI_CALL Proxy::map(VkDevice device, VkDeviceMemory memory, VkDeviceSize offset,
                               VkDeviceSize size, VkMemoryMapFlags flags, void** data) {
  if (fails()) {
    exhausted = true;
    fillWithGarbage(data);
    return VK_ERROR_MEMORY_MAP_FAILED;
  }
  const Inside inside;
  return vkMapMemory(device, memory, offset, size, flags, data);
}

VkResult VKAPI_CALL Proxy::allocateSets(VkDevice device, const VkDescriptorSetAllocateInfo* info,
                                        VkDescriptorSet* sets) {
  if (fails()) {
    *sets = VK_NULL_HANDLE; // the only call whose output Vulkan defines on failure
    return VK_ERROR_OUT_OF_POOL_MEMORY;
  }
  const Inside inside;
  return vkAllocateDescriptorSets(device, info, sets);
}

HostMemory::HostMemory(VulkanDevice& d) : device(d) {
  LICHEN_INIT(callbacks, LICHEN_STRUCTURE_DEVICE_ALLOCATOR);
  callbacks.userData = this;
  callbacks.allocate = allocate;
  callbacks.release = release;
}

VkResult HostMemory::allocate(void* userData, const LichenMemoryRequest* request,
                              LichenDeviceMemory* memory) {
  auto& self = *static_cast<HostMemory*>(userData);
  if (self.untilFailure > 0 && --self.untilFailure == 0) {
    Proxy::fillWithGarbage(&memory->memory);
    return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  }
  VkPhysicalDeviceMemoryProperties types{};
  vkGetPhysicalDeviceMemoryProperties(self.device.physicalDevice(), &types);
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  while ((request->requirements.memoryTypeBits & (1u << info.memoryTypeIndex)) == 0 ||
         (types.memoryTypes[info.memoryTypeIndex].propertyFlags & request->properties) !=
             request->properties)
    ++info.memoryTypeIndex;
  memory->offset = request->requirements.alignment * 3;
  info.allocationSize = memory->offset + request->requirements.size;
  const VkResult result = vkAllocateMemory(self.device.device(), &info, nullptr, &memory->memory);
  if (result != VK_SUCCESS)
    return result;
  if (request->properties & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
    vkMapMemory(self.device.device(), memory->memory, memory->offset, request->requirements.size, 0,
                &memory->mapped);
  ++self.alive;
  return VK_SUCCESS;
}

void HostMemory::release(void* userData, const LichenDeviceMemory* memory) {
  auto& self = *static_cast<HostMemory*>(userData);
  vkFreeMemory(self.device.device(), memory->memory, nullptr);
  --self.alive;
}

} // namespace lichen::test
