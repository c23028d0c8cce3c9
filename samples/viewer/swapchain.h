// SPDX-License-Identifier: MIT
// The images of a window, and the way of a finished picture into one of them.
#pragma once

#include <lichen/vulkan_device.h>

#include <vector>

namespace lichen::renderer {

/// Functions throw a Failure: environment for a surface that cannot be copied to. The device is
/// idle whenever no function runs, but for what the window system does with presented images.
class Swapchain {
public:
  /// Owns the surface. The device must outlive it, and the window too.
  Swapchain(VulkanDevice& device, VkSurfaceKHR surface);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Images for a window of that size, in place of earlier ones. False while it has no area.
  [[nodiscard]] bool resize(VkExtent2D window);
  [[nodiscard]] VkExtent2D extent() const { return extent_; }

  /// Shows an image of extent() in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, of sRGB code without a
  /// format of sRGB, that is ready to be copied from. False when the window has changed: resize()
  /// and show again.
  [[nodiscard]] bool present(const DeviceImage& picture);

private:
  struct Nothing {};
  /// Holds the surface and nothing else, so that a set-up that fails is cleaned up.
  Swapchain(VulkanDevice& device, VkSurfaceKHR surface, Nothing)
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
  std::vector<VkSemaphore> copied_; ///< one per image: presenting waits for it, the host cannot
  VkSemaphore acquired_ = VK_NULL_HANDLE;
  VkFence done_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

} // namespace lichen::renderer
