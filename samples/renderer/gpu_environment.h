// SPDX-License-Identifier: MIT
// Uploads an Environment to the device.
#pragma once

#include "environment.h"
#include "gpu_objects.h"

namespace lichen::renderer {

struct GpuEnvironment {
  DeviceImage panorama;
  DeviceImage specular;
  DeviceImage diffuse;
  DeviceImage brdf;
  VkSampler panoramaSampler = VK_NULL_HANDLE; ///< repeats in u, around the horizon
  VkSampler clampSampler = VK_NULL_HANDLE;
};

[[nodiscard]] GpuEnvironment uploadEnvironment(VulkanDevice& device, ObjectOwner& objects,
                                               const Environment& environment);

} // namespace lichen::renderer
