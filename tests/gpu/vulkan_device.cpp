// SPDX-License-Identifier: MIT
// The device layer itself: choice of a device, and what becomes of failures. The plugin's tests
// have copies that return what was written, and validation that reports a missing barrier.
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
