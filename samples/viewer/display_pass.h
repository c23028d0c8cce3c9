// SPDX-License-Identifier: MIT
// Converts the sum of frames into an 8-bit picture for the window.
#pragma once

#include "gpu_objects.h"
#include "uniform_blocks.h"

#include <array>

namespace lichen::renderer {

/// Each frame in flight has a picture and a set of its own. Functions throw a Failure.
class DisplayPass {
public:
  explicit DisplayPass(VulkanDevice& device);

  /// Records the average of `frames` frames into the returned picture: sRGB-encoded in a UNORM
  /// format, in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL and ready to copy. No frame that was recorded
  /// with the same slot may be in flight.
  const DeviceImage& record(const FrameCommands& frame, const DeviceImage& sum,
                            std::uint32_t frames);

private:
  VulkanDevice& device_;
  ObjectOwner objects_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  std::array<VkDescriptorSet, kFramesInFlight> sets_{};
  std::array<DeviceImage, kFramesInFlight> pictures_;
};

} // namespace lichen::renderer
