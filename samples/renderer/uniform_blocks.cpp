// SPDX-License-Identifier: MIT
// Blocks at a stride that every device accepts as a dynamic offset.
#include "uniform_blocks.h"

#include "failure.h"

namespace lichen::renderer {
namespace {

// No device may ask for more [Vulkan, minUniformBufferOffsetAlignment].
constexpr std::size_t kAlignment = 256;

} // namespace

UniformBlocks::UniformBlocks(VulkanDevice& device, std::size_t count, std::size_t bytes)
    : bytes_(bytes), stride_((bytes + kAlignment - 1) / kAlignment * kAlignment),
      buffer_(
          take(device.createBuffer(count * stride_, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true))) {}

Descriptor UniformBlocks::descriptor() const {
  return {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, {buffer_.handle, 0, bytes_}, {}};
}

} // namespace lichen::renderer
