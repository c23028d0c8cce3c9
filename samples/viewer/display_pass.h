// SPDX-License-Identifier: MIT
// Converts the sum of frames into an 8-bit picture for the window.
#pragma once

#include "gpu_objects.h"

namespace lichen::renderer {

/// Functions throw a Failure.
class DisplayPass {
public:
  explicit DisplayPass(VulkanDevice& device);

  /// Records the average of `frames` frames into the returned picture: sRGB-encoded in a UNORM
  /// format, in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL and ready to copy. No frame may be in flight.
  const DeviceImage& record(VkCommandBuffer commands, const DeviceImage& sum, std::uint32_t frames);

private:
  VulkanDevice& device_;
  ObjectOwner objects_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  DeviceImage picture_;
};

} // namespace lichen::renderer
