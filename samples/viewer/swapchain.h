// SPDX-License-Identifier: MIT
// The images of a window: acquire one, record a copy of a picture into it, present it.
#pragma once

#include "gpu_objects.h"

#include <lichen/vulkan_device.h>

#include <vector>

namespace lichen::renderer {

/// Functions throw a Failure: environment for a surface that cannot be copied to.
class Swapchain {
public:
  /// Owns the surface. The device and the window must outlive the swapchain.
  Swapchain(VulkanDevice& device, VkSurfaceKHR surface);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Waits until the device is idle, and replaces the images to match a window of this size.
  /// Returns false while the window has no area.
  [[nodiscard]] bool resize(VkExtent2D window);
  [[nodiscard]] VkExtent2D extent() const { return extent_; }

  /// Waits for the next image and acquires it. Returns false if the window has changed: call
  /// resize() and acquire again.
  [[nodiscard]] bool acquire();
  /// Records a copy into the acquired image of a picture of size extent() in
  /// VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, sRGB-encoded in a UNORM format.
  void recordCopy(VkCommandBuffer commands, const DeviceImage& picture) const;
  /// Presents the acquired image once the copy has finished. Returns false if the window has
  /// changed: call resize() and present again.
  [[nodiscard]] bool present();

private:
  struct SurfaceOnly {};
  /// Owns only the surface. The public constructor delegates to it, so the destructor cleans up if
  /// the rest of the setup throws.
  Swapchain(VulkanDevice& device, VkSurfaceKHR surface, SurfaceOnly)
      : device_(device), surface_(surface), objects_(device.device()), acquired_(objects_.fence()) {
  }

  void chooseFormat();

  VulkanDevice& device_;
  VkSurfaceKHR surface_;
  ObjectOwner objects_;
  VkFence acquired_;
  VkSurfaceFormatKHR format_{};
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  std::vector<VkImage> images_;
  std::uint32_t index_ = 0; ///< of the acquired image
};

} // namespace lichen::renderer
