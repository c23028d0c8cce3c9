// SPDX-License-Identifier: MIT
// The sum of frames -> a picture of 8 bits for the window.
#pragma once

#include "gpu_objects.h"

namespace lichen::renderer {

/// Functions throw a Failure.
class DisplayPass {
public:
  explicit DisplayPass(VulkanDevice& device);

  /// The average of `frames` frames in sRGB code, without a format of sRGB; in
  /// VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, ready to be copied from. Valid until the next call.
  const DeviceImage& show(const DeviceImage& sum, std::uint32_t frames);

private:
  VulkanDevice& device_;
  ObjectOwner objects_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  DeviceImage picture_;
};

} // namespace lichen::renderer
