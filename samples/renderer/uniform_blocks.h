// SPDX-License-Identifier: MIT
// Uniform blocks that the host rewrites for every frame while the device still reads the blocks of
// the frame before: one buffer, a copy of all blocks for each frame in flight, dynamic offsets.
#pragma once

#include "gpu_objects.h"

namespace lichen::renderer {

/// The host prepares one frame while the device draws another.
inline constexpr std::uint32_t kFramesInFlight = 2;

/// Commands of one frame, and the slot of the blocks that they read, below kFramesInFlight.
struct FrameCommands {
  VkCommandBuffer buffer = VK_NULL_HANDLE;
  std::uint32_t slot = 0;
};

class UniformBlocks {
public:
  UniformBlocks() = default;
  /// `count` blocks of `bytes` bytes. Throws a Failure.
  UniformBlocks(VulkanDevice& device, std::size_t count, std::size_t bytes);

  /// UNIFORM_BUFFER_DYNAMIC: a set that has it is written once, and bound with an offset().
  [[nodiscard]] Descriptor descriptor() const;
  /// The offset of a block in the copy of `slot`, which is below kFramesInFlight.
  [[nodiscard]] std::uint32_t offset(std::uint32_t slot, std::size_t block = 0) const {
    return std::uint32_t((slot * count_ + block) * stride_);
  }
  /// Where the host writes the block. No frame that uses `slot` may be in flight.
  [[nodiscard]] std::byte* data(std::uint32_t slot, std::size_t block = 0) const {
    return buffer_.mapped + offset(slot, block);
  }

private:
  std::size_t count_ = 0;
  std::size_t bytes_ = 0;
  std::size_t stride_ = 0;
  DeviceBuffer buffer_;
};

} // namespace lichen::renderer
