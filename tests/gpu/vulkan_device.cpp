// SPDX-License-Identifier: MIT
// The device layer itself: choice of a device, copies that return what was written, and validation
// that reports a mistake.
#include "require_device.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace lichen;

TEST_CASE("the error for an unknown device lists the devices") {
  lichen::test::requireDevice();
  VulkanDeviceOptions options;
  options.choice = "no such device";
  const auto device = VulkanDevice::create(options);
  REQUIRE_FALSE(device.ok());
  CHECK(device.error().kind == ErrorKind::usage);
  const std::vector<std::string> names = VulkanDevice::listDevices().value();
  CHECK(device.error().message.find(names.front()) != std::string::npos);
}

TEST_CASE("a device can be chosen by its index or by part of its name") {
  const auto device = lichen::test::requireDevice();
  VulkanDeviceOptions options;
  options.choice = std::string(device->properties().deviceName).substr(0, 4);
  CHECK(VulkanDevice::create(options).ok());
  options.choice = "0";
  CHECK(VulkanDevice::create(options).ok());
}

namespace {

/// Copies 256 bytes to the device and back, with or without the barrier between the two copies.
void copyThereAndBack(VulkanDevice& device, bool withBarrier, std::vector<std::byte>& result) {
  const VkBufferUsageFlags usage =
      VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  DeviceBuffer source = device.createBuffer(256, usage, true).value();
  DeviceBuffer middle = device.createBuffer(256, usage, false).value();
  DeviceBuffer target = device.createBuffer(256, usage, true).value();
  for (std::size_t i = 0; i < 256; ++i)
    source.mapped[i] = std::byte(i);
  const VkBufferCopy region{0, 0, 256};
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
  REQUIRE(device.submit([&](VkCommandBuffer commands) {
    vkCmdCopyBuffer(commands, source.handle, middle.handle, 1, &region);
    if (withBarrier)
      vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                           0, 1, &barrier, 0, nullptr, 0, nullptr);
    vkCmdCopyBuffer(commands, middle.handle, target.handle, 1, &region);
  }));
  result.assign(target.mapped, target.mapped + 256);
}

} // namespace

TEST_CASE("bytes copied to the device and back are unchanged, without validation messages") {
  const auto device = lichen::test::requireDevice();
  std::vector<std::byte> result;
  copyThereAndBack(*device, true, result);
  for (std::size_t i = 0; i < 256; ++i)
    REQUIRE(result[i] == std::byte(i));
  CHECK(device->messages().texts().empty());
}

TEST_CASE("synchronization validation reports a missing barrier") {
  const auto device = lichen::test::requireDevice();
  std::vector<std::byte> result;
  copyThereAndBack(*device, false, result);
  REQUIRE(device->messages().errors() == 1);
  CHECK(device->messages().texts().front().find("SYNC-HAZARD-READ") != std::string::npos);
}

TEST_CASE("validation messages about objects that outlive their device are stored") {
  auto device = lichen::test::requireDevice();
  const auto messages = device->keptMessages();
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = 256;
  info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
  VkBuffer leaked = VK_NULL_HANDLE;
  REQUIRE(vkCreateBuffer(device->device(), &info, nullptr, &leaked) == VK_SUCCESS);
  CHECK(messages->texts().empty());
  device.reset();
  REQUIRE(messages->errors() == 1);
  CHECK(messages->texts().front().find("vkDestroyDevice") != std::string::npos);
}

TEST_CASE("a failed submission frees its command buffer") {
  const auto device = lichen::test::requireDevice();
  const auto realSubmit = vkQueueSubmit;
  static PFN_vkFreeCommandBuffers realFree;
  static int freed;
  realFree = vkFreeCommandBuffers;
  freed = 0;
  vkQueueSubmit = [](VkQueue, std::uint32_t, const VkSubmitInfo*, VkFence) {
    return VK_ERROR_OUT_OF_HOST_MEMORY;
  };
  vkFreeCommandBuffers = [](VkDevice owner, VkCommandPool pool, std::uint32_t count,
                            const VkCommandBuffer* buffers) {
    ++freed;
    realFree(owner, pool, count, buffers);
  };
  const Result<void> submitted = device->submit([](VkCommandBuffer) {});
  vkQueueSubmit = realSubmit;
  vkFreeCommandBuffers = realFree;
  CHECK_FALSE(submitted);
  CHECK(freed == 1);
  CHECK(device->submit([](VkCommandBuffer) {}));
}

TEST_CASE("a handle written by a failed creation is not destroyed") {
  const auto device = lichen::test::requireDevice();
  const auto realCreate = vkCreateImageView;
  static PFN_vkDestroyImageView realDestroy;
  static VkImageView garbage, destroyed;
  realDestroy = vkDestroyImageView;
  std::memset(static_cast<void*>(&garbage), 0xa5, sizeof garbage);
  destroyed = VK_NULL_HANDLE;
  vkCreateImageView = [](VkDevice, const VkImageViewCreateInfo*, const VkAllocationCallbacks*,
                         VkImageView* view) {
    *view = garbage;
    return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  };
  vkDestroyImageView = [](VkDevice d, VkImageView view, const VkAllocationCallbacks* callbacks) {
    destroyed = view;
    if (view != garbage)
      realDestroy(d, view, callbacks);
  };
  DeviceImageInfo info;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
  const auto image = device->createImage(info);
  vkCreateImageView = realCreate;
  vkDestroyImageView = realDestroy;
  REQUIRE_FALSE(image.ok());
  CHECK(image.error().kind == ErrorKind::resources);
  CHECK(destroyed == VK_NULL_HANDLE);
  CHECK(device->messages().texts().empty());
}

TEST_CASE("allocations beyond the device's limit fail until one is freed") {
  const auto device = lichen::test::requireDevice();
  // Drivers accept thousands, some of them any number.
  auto& properties = const_cast<VkPhysicalDeviceProperties&>(device->properties());
  properties.limits.maxMemoryAllocationCount = 2;
  const auto create = [&] {
    return device->createBuffer(256, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, true);
  };
  auto first = create();
  const auto second = create();
  REQUIRE((first.ok() && second.ok()));
  const auto third = create();
  REQUIRE_FALSE(third.ok());
  CHECK(third.error().kind == ErrorKind::resources);
  first.value().reset();
  CHECK(create().ok());
  CHECK(create().ok()); // the last one is gone
}

TEST_CASE("an image read back has the colour it was cleared to") {
  const auto device = lichen::test::requireDevice();
  DeviceImageInfo info;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  info.extent = {5, 3, 1};
  info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
               VK_IMAGE_USAGE_SAMPLED_BIT;
  const DeviceImage image = device->createImage(info).value();
  const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.handle;
  barrier.subresourceRange = all;
  VkClearColorValue color{};
  color.float32[0] = 1.0f;
  color.float32[3] = 0.2f;
  REQUIRE(device->submit([&](VkCommandBuffer commands) {
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT,
                         VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
    vkCmdClearColorImage(commands, image.handle, VK_IMAGE_LAYOUT_GENERAL, &color, 1, &all);
  }));
  const auto texels = device->readImage(image, VK_IMAGE_LAYOUT_GENERAL, 4).value();
  REQUIRE(texels.size() == 5 * 3 * 4);
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    REQUIRE(texels[i] == std::byte(255));
    REQUIRE(texels[i + 1] == std::byte(0));
    REQUIRE(texels[i + 3] == std::byte(51));
  }
  CHECK(device->messages().texts().empty());
}
