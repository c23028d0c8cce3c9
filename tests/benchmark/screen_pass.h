// SPDX-License-Identifier: MIT
// A pipeline that draws one rectangle over a whole image, to time a fragment shader.
#pragma once

#include <lichen/vulkan_device.h>

#include <cstdint>
#include <span>

namespace lichen::bench {

/// The values that view.vert reads.
struct ScreenView {
  float uvPerScreenX = 1.0f;
  float uvPerScreenY = 1.0f;
  float farDistance = 1.0f;
};

inline constexpr VkFormat kScreenFormat = VK_FORMAT_R8G8B8A8_UNORM;

/// A pipeline that draws a rectangle over the whole screen.
class ScreenPipeline {
public:
  /// `layout` is the layout of set 0. Throws std::runtime_error with the device's message.
  ScreenPipeline(VkDevice device, std::span<const std::uint32_t> vertex,
                 std::span<const std::uint32_t> fragment, VkDescriptorSetLayout layout);
  ~ScreenPipeline();
  ScreenPipeline(const ScreenPipeline&) = delete;
  ScreenPipeline& operator=(const ScreenPipeline&) = delete;

  [[nodiscard]] VkPipeline handle() const { return pipeline_; }
  [[nodiscard]] VkPipelineLayout layout() const { return layout_; }

private:
  VkDevice device_;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

class ScreenPass {
public:
  /// `layout` is the layout of set 0. Throws std::runtime_error with the device's message.
  ScreenPass(VulkanDevice& device, std::span<const std::uint32_t> vertex,
             std::span<const std::uint32_t> fragment, VkDescriptorSetLayout layout);
  ~ScreenPass();
  ScreenPass(const ScreenPass&) = delete;
  ScreenPass& operator=(const ScreenPass&) = delete;

  /// Draws into `target` (kScreenFormat, a colour attachment) and waits. Returns the seconds that
  /// the device took, from its timestamps.
  [[nodiscard]] double draw(const DeviceImage& target, VkDescriptorSet set, const ScreenView& view);

private:
  static constexpr std::uint32_t kTimestamps = 2; ///< before and after the draw

  VulkanDevice& device_;
  ScreenPipeline pipeline_;
  VkQueryPool timestamps_ = VK_NULL_HANDLE;
  std::uint64_t ticks_ = 0; ///< mask of the bits that timestamps have
};

} // namespace lichen::bench
