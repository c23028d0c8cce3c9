// SPDX-License-Identifier: MIT
// The descriptor set of plain.frag, bare.frag and the peers (shaders/peer_inputs.glsl).
#pragma once

#include <lichen/image.h>
#include <lichen/vulkan_device.h>

#include <array>
#include <vector>

namespace lichen::bench {

struct PeerTexels;

class PeerImages {
public:
  /// `exemplar`: RGB, square, the side a power of two. Throws std::runtime_error with the device's
  /// message.
  PeerImages(VulkanDevice& device, const SrgbImage& exemplar);
  ~PeerImages();
  PeerImages(const PeerImages&) = delete;
  PeerImages& operator=(const PeerImages&) = delete;

  [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_; }
  [[nodiscard]] VkDescriptorSet set() const { return set_; }
  /// The mean of the exemplar's code values, to which each picture's mean has to be near.
  [[nodiscard]] const std::array<double, 3>& mean() const { return mean_; }

private:
  void upload(const PeerTexels& source);
  void createSet();

  VulkanDevice& device_;
  std::vector<DeviceImage> images_; ///< by binding
  DeviceBuffer parameters_;
  VkSampler repeats_ = VK_NULL_HANDLE;
  VkSampler clamps_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  std::array<double, 3> mean_{};
};

} // namespace lichen::bench
