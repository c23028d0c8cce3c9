// SPDX-License-Identifier: MIT
// The images of a window, and copying finished pictures into them.
#pragma once

#include <lichen/vulkan_device.h>

#include <vector>

namespace lichen::renderer {

/// Functions throw a Failure: environment for a surface that cannot be copied to. The device is
/// idle whenever no function runs, except for presentation by the window system.
class Swapchain {
public:
  /// Owns the surface. The device and the window must outlive the swapchain.
  Swapchain(VulkanDevice& device, VkSurfaceKHR surface);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Replaces the images to match a window of this size. Returns false while the window has no
  /// area.
  [[nodiscard]] bool resize(VkExtent2D window);
  [[nodiscard]] VkExtent2D extent() const { return extent_; }

  /// Presents an image of size extent() in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, sRGB-encoded in a
  /// UNORM format. Returns false if the window has changed: call resize() and present again.
  [[nodiscard]] bool present(const DeviceImage& picture);

private:
  struct SurfaceOnly {};
  /// Owns only the surface. The public constructor delegates to it, so the destructor cleans up if
  /// the rest of the setup throws.
  Swapchain(VulkanDevice& device, VkSurfaceKHR surface, SurfaceOnly)
      : device_(device), surface_(surface) {}

  void chooseFormat();
  void destroyImages();
  void recordCopy(const DeviceImage& picture, VkImage target);
  void submitCopy(std::uint32_t index);

  VulkanDevice& device_;
  VkSurfaceKHR surface_;
  VkSurfaceFormatKHR format_{};
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  std::vector<VkImage> images_;
  /// one per image; presentation waits for it, and the host cannot tell when that is over
  std::vector<VkSemaphore> copied_;
  VkSemaphore acquired_ = VK_NULL_HANDLE;
  VkFence done_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

} // namespace lichen::renderer
