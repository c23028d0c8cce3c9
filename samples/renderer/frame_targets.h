// SPDX-License-Identifier: MIT
// Render targets of a frame.
#pragma once

#include "gpu_objects.h"
#include "shaders/scene_interface.h"

#include <array>

namespace lichen::renderer {

/// Targets of the picture's size.
struct FrameTargets {
  DeviceImage color;
  DeviceImage depth;
  DeviceImage sum; ///< sum of frames; in GENERAL after the first frame
};

/// Depth maps seen from the sun and from a few sky directions. Their size is independent of the
/// picture's.
struct LightMaps {
  DeviceImage sunDepth;
  DeviceImage skyDepth; ///< one layer per direction
  std::array<VkImageView, MAX_SKY_DIRECTIONS> skyLayers{};
};

/// Throws a Failure: usage if the size exceeds the device's limit.
[[nodiscard]] FrameTargets createFrameTargets(VulkanDevice& device, std::uint32_t width,
                                              std::uint32_t height);

[[nodiscard]] LightMaps createLightMaps(VulkanDevice& device, ObjectOwner& objects);

/// The filter for sampling depth maps. Throws a Failure: environment if the device cannot render to
/// and sample them.
[[nodiscard]] VkFilter depthFilter(const VulkanDevice& device);

} // namespace lichen::renderer
