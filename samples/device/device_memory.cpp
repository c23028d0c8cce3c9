// SPDX-License-Identifier: MIT
// Buffers and images with their own memory, one-time submits, readback, validation messages.
#include "create_object.h"

#include <lichen/vulkan_device.h>

#include <algorithm>
#include <cstring>

namespace lichen {

void ValidationMessages::add(bool isError, std::string text) {
  const std::lock_guard lock(mutex_);
  errors_ += isError ? 1 : 0;
  texts_.push_back(std::move(text));
}

void ValidationMessages::clear() {
  const std::lock_guard lock(mutex_);
  errors_ = 0;
  texts_.clear();
}

std::size_t ValidationMessages::errors() const {
  const std::lock_guard lock(mutex_);
  return errors_;
}

std::size_t ValidationMessages::warnings() const {
  const std::lock_guard lock(mutex_);
  return texts_.size() - errors_;
}

std::vector<std::string> ValidationMessages::texts() const {
  const std::lock_guard lock(mutex_);
  return texts_;
}

Error vulkanError(const std::string& what, VkResult result) {
  const bool exhausted = result == VK_ERROR_OUT_OF_HOST_MEMORY ||
                         result == VK_ERROR_OUT_OF_DEVICE_MEMORY ||
                         result == VK_ERROR_TOO_MANY_OBJECTS;
  const char* reason = "";
  switch (result) {
  case VK_ERROR_OUT_OF_HOST_MEMORY:
    reason = "out of host memory";
    break;
  case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    reason = "out of device memory";
    break;
  case VK_ERROR_DEVICE_LOST:
    reason = "the device was lost";
    break;
  case VK_ERROR_EXTENSION_NOT_PRESENT:
    reason = "an extension is not present";
    break;
  case VK_ERROR_FEATURE_NOT_PRESENT:
    reason = "a feature is not present";
    break;
  case VK_ERROR_INCOMPATIBLE_DRIVER:
    reason = "no driver is compatible";
    break;
  default:
    reason = "the driver reported an error";
    break;
  }
  return {exhausted ? ErrorKind::resources : ErrorKind::environment,
          what + ": " + reason + " (VkResult " + std::to_string(int(result)) + ")"};
}

DeviceBuffer& DeviceBuffer::operator=(DeviceBuffer&& other) noexcept {
  if (this != &other) {
    reset();
    handle = std::exchange(other.handle, VK_NULL_HANDLE);
    size = std::exchange(other.size, 0);
    mapped = std::exchange(other.mapped, nullptr);
    device_ = std::exchange(other.device_, VK_NULL_HANDLE);
    memory_ = std::exchange(other.memory_, VK_NULL_HANDLE);
    allocations_ = other.allocations_;
  }
  return *this;
}

void DeviceBuffer::reset() {
  if (device_ == VK_NULL_HANDLE)
    return;
  vkDestroyBuffer(device_, std::exchange(handle, VK_NULL_HANDLE), nullptr);
  if (memory_ != VK_NULL_HANDLE)
    --*allocations_;
  vkFreeMemory(device_, std::exchange(memory_, VK_NULL_HANDLE), nullptr);
  mapped = nullptr;
  device_ = VK_NULL_HANDLE;
}

DeviceImage& DeviceImage::operator=(DeviceImage&& other) noexcept {
  if (this != &other) {
    reset();
    handle = std::exchange(other.handle, VK_NULL_HANDLE);
    view = std::exchange(other.view, VK_NULL_HANDLE);
    info = other.info;
    device_ = std::exchange(other.device_, VK_NULL_HANDLE);
    memory_ = std::exchange(other.memory_, VK_NULL_HANDLE);
    allocations_ = other.allocations_;
  }
  return *this;
}

void DeviceImage::reset() {
  if (device_ == VK_NULL_HANDLE)
    return;
  vkDestroyImageView(device_, std::exchange(view, VK_NULL_HANDLE), nullptr);
  vkDestroyImage(device_, std::exchange(handle, VK_NULL_HANDLE), nullptr);
  if (memory_ != VK_NULL_HANDLE)
    --*allocations_;
  vkFreeMemory(device_, std::exchange(memory_, VK_NULL_HANDLE), nullptr);
  device_ = VK_NULL_HANDLE;
}

Result<VkDeviceMemory> VulkanDevice::allocate(const VkMemoryRequirements& requirements,
                                              VkMemoryPropertyFlags required) {
  const std::uint32_t most = properties_.limits.maxMemoryAllocationCount;
  if (allocations_ >= most)
    return Error{ErrorKind::resources,
                 "the scene needs more than " + std::to_string(most) +
                     " memory allocations, the limit of this Vulkan device; use fewer textures "
                     "(each texture and each buffer takes one)"};
  // Protected memory requires a protected queue; lazily allocated memory only suits transient
  // attachments.
  constexpr VkMemoryPropertyFlags kUnwanted =
      VK_MEMORY_PROPERTY_PROTECTED_BIT | VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT;
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(physicalDevice_, &memory);
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    if ((requirements.memoryTypeBits & (1u << type)) == 0 ||
        (memory.memoryTypes[type].propertyFlags & (required | kUnwanted)) != required)
      continue;
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = type;
    VkDeviceMemory handle = VK_NULL_HANDLE;
    if (const VkResult result = vkAllocateMemory(device_, &info, nullptr, &handle);
        result != VK_SUCCESS)
      return vulkanError("cannot allocate " + std::to_string(info.allocationSize) + " bytes",
                         result);
    ++allocations_;
    return handle;
  }
  return Error{ErrorKind::environment, "the Vulkan device has no suitable memory type"};
}

Result<DeviceBuffer> VulkanDevice::createBuffer(VkDeviceSize size, VkBufferUsageFlags usage,
                                                bool hostVisible) {
  DeviceBuffer buffer;
  buffer.device_ = device_;
  buffer.size = size;
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size;
  info.usage = usage;
  if (const VkResult result = createObject(vkCreateBuffer, device_, info, buffer.handle);
      result != VK_SUCCESS)
    return vulkanError("cannot create a buffer of " + std::to_string(size) + " bytes", result);
  VkMemoryRequirements requirements{};
  vkGetBufferMemoryRequirements(device_, buffer.handle, &requirements);
  Result<VkDeviceMemory> memory =
      allocate(requirements, hostVisible ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                               VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                         : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory)
    return memory.error();
  buffer.memory_ = memory.value();
  buffer.allocations_ = &allocations_;
  void* mapped = nullptr;
  VkResult result = vkBindBufferMemory(device_, buffer.handle, buffer.memory_, 0);
  if (result == VK_SUCCESS && hostVisible)
    result = vkMapMemory(device_, buffer.memory_, 0, VK_WHOLE_SIZE, 0, &mapped);
  if (result != VK_SUCCESS)
    return vulkanError("cannot create a buffer of " + std::to_string(size) + " bytes", result);
  buffer.mapped = static_cast<std::byte*>(mapped);
  return buffer;
}

Result<DeviceImage> VulkanDevice::createImage(const DeviceImageInfo& request) {
  const std::string failure = "cannot create an image of " + std::to_string(request.extent.width) +
                              " x " + std::to_string(request.extent.height);
  DeviceImage image;
  image.device_ = device_;
  image.info = request;
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.flags = request.flags;
  info.imageType = request.extent.depth > 1 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
  info.format = request.format;
  info.extent = request.extent;
  info.mipLevels = request.mipLevels;
  info.arrayLayers = request.layers;
  info.samples = request.samples;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = request.usage;
  if (const VkResult result = createObject(vkCreateImage, device_, info, image.handle);
      result != VK_SUCCESS)
    return vulkanError(failure, result);
  VkMemoryRequirements requirements{};
  vkGetImageMemoryRequirements(device_, image.handle, &requirements);
  Result<VkDeviceMemory> memory = allocate(requirements, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory)
    return memory.error();
  image.memory_ = memory.value();
  image.allocations_ = &allocations_;
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image.handle;
  view.viewType = request.extent.depth > 1 ? VK_IMAGE_VIEW_TYPE_3D : request.viewType;
  view.format = request.format;
  view.subresourceRange = {request.aspect, 0, request.mipLevels, 0, request.layers};
  VkResult result = vkBindImageMemory(device_, image.handle, image.memory_, 0);
  if (result == VK_SUCCESS)
    result = createObject(vkCreateImageView, device_, view, image.view);
  if (result != VK_SUCCESS)
    return vulkanError(failure, result);
  return image;
}

Result<void> VulkanDevice::submit(const std::function<void(VkCommandBuffer)>& record) {
  VkCommandBufferAllocateInfo allocation{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocation.commandPool = commandPool_;
  allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocation.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  if (const VkResult result = vkAllocateCommandBuffers(device_, &allocation, &commands);
      result != VK_SUCCESS)
    return vulkanError("cannot allocate a command buffer", result);
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VkSubmitInfo submission{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submission.commandBufferCount = 1;
  submission.pCommandBuffers = &commands;
  VkResult result = vkBeginCommandBuffer(commands, &begin);
  if (result == VK_SUCCESS) {
    record(commands);
    result = vkEndCommandBuffer(commands);
  }
  if (result == VK_SUCCESS)
    result = vkQueueSubmit(queue_, 1, &submission, fence_);
  const bool isSubmitted = result == VK_SUCCESS;
  if (isSubmitted)
    result = vkWaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX);
  if (!isSubmitted || result == VK_SUCCESS) // otherwise the device may still use them
    vkFreeCommandBuffers(device_, commandPool_, 1, &commands);
  if (result == VK_SUCCESS)
    result = vkResetFences(device_, 1, &fence_);
  if (result != VK_SUCCESS)
    return vulkanError("cannot submit work to the device", result);
  return {};
}

Result<std::vector<std::byte>>
VulkanDevice::readImage(const DeviceImage& image, VkImageLayout layout, std::size_t texelBytes) {
  const VkExtent3D extent = image.info.extent;
  const VkDeviceSize size =
      VkDeviceSize(extent.width) * extent.height * extent.depth * VkDeviceSize(texelBytes);
  Result<DeviceBuffer> buffer = createBuffer(size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true);
  if (!buffer)
    return buffer.error();
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
  barrier.oldLayout = layout;
  barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.handle;
  barrier.subresourceRange = {image.info.aspect, 0, image.info.mipLevels, 0, image.info.layers};
  VkBufferImageCopy region{};
  region.imageSubresource = {image.info.aspect, 0, 0, 1};
  region.imageExtent = extent;
  VkMemoryBarrier toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  toHost.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  Result<void> submitted = submit([&](VkCommandBuffer commands) {
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                         VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
    vkCmdCopyImageToBuffer(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           buffer.value().handle, 1, &region);
    std::swap(barrier.oldLayout, barrier.newLayout);
    barrier.srcAccessMask = 0;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &toHost, 0, nullptr, 1, &barrier);
  });
  if (!submitted)
    return submitted.error();
  const std::byte* begin = buffer.value().mapped;
  return std::vector<std::byte>(begin, begin + size);
}

} // namespace lichen
