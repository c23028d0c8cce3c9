// SPDX-License-Identifier: MIT
// A scene's geometry, textures and materials on the device.
#pragma once

#include "gpu_objects.h"
#include "noise_host.h"
#include "scene.h"

namespace lichen::renderer {

/// One primitive's range of the scene's buffers.
struct GpuPrimitive {
  std::uint32_t firstIndex = 0;
  std::uint32_t indexCount = 0;
  std::int32_t vertexOffset = 0;
  /// From the vertices to those before morph targets and skins; 0 where they are the same.
  VkDeviceSize undeformedBytes = 0;
};

struct GpuScene {
  DeviceBuffer vertices;
  DeviceBuffer indices; ///< 32 bit
  std::vector<GpuPrimitive> primitives;
  std::vector<DeviceImage> images; ///< an image used both as colour and as data is here twice
  DeviceBuffer materialData;
  VkDescriptorSetLayout materialLayout = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> materialSets; ///< one per Scene::materials
};

/// Errors: environment for an image or a primitive larger than the limits.
[[nodiscard]] Result<void> fitsDevice(const Scene& scene, const VkPhysicalDeviceLimits& limits);

/// `noises` tells which maps a material takes from its noise. Throws a Failure.
[[nodiscard]] GpuScene uploadScene(VulkanDevice& device, ObjectOwner& objects, const Scene& scene,
                                   const NoiseHost& noises);

/// Writes the materials' data again, of which the noises have changed. No frame may be in flight.
void writeMaterials(const Scene& scene, const NoiseHost& noises, GpuScene& gpu);

} // namespace lichen::renderer
