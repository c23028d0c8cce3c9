// SPDX-License-Identifier: MIT
// The images that a frame is drawn to.
#pragma once

#include "gpu_objects.h"
#include "shaders/scene_interface.h"

#include <array>

namespace lichen::renderer {

/// Of the picture's size.
struct FrameTargets {
  DeviceImage color;
  DeviceImage depth;
  DeviceImage sum; ///< of frames; in GENERAL once a frame is drawn
};

/// Of what the sun and a few directions of the sky see, whatever the picture's size.
struct LightMaps {
  DeviceImage sunDepth;
  DeviceImage skyDepth; ///< a layer for each direction
  std::array<VkImageView, MAX_SKY_DIRECTIONS> skyLayers{};
};

/// Throws a Failure: usage for a size beyond the device's.
[[nodiscard]] FrameTargets createFrameTargets(VulkanDevice& device, std::uint32_t width,
                                              std::uint32_t height);

[[nodiscard]] LightMaps createLightMaps(VulkanDevice& device, ObjectOwner& objects);

/// How depth maps are filtered. Throws a Failure: environment for a device that cannot draw and
/// sample them.
[[nodiscard]] VkFilter depthFilter(const VulkanDevice& device);

} // namespace lichen::renderer
