// SPDX-License-Identifier: MIT
// Uniform blocks that the host rewrites for every frame: one buffer, dynamic offsets.
#pragma once

#include "gpu_objects.h"

namespace lichen::renderer {

class UniformBlocks {
public:
  UniformBlocks() = default;
  /// `count` blocks of `bytes` bytes. Throws a Failure.
  UniformBlocks(VulkanDevice& device, std::size_t count, std::size_t bytes);

  /// UNIFORM_BUFFER_DYNAMIC: a set that has it is written once, and bound with an offset().
  [[nodiscard]] Descriptor descriptor() const;
  [[nodiscard]] std::uint32_t offset(std::size_t block = 0) const {
    return std::uint32_t(block * stride_);
  }
  /// Where the host writes the block. No frame may be in flight.
  [[nodiscard]] std::byte* data(std::size_t block = 0) const {
    return buffer_.mapped + offset(block);
  }

private:
  std::size_t bytes_ = 0;
  std::size_t stride_ = 0;
  DeviceBuffer buffer_;
};

} // namespace lichen::renderer
