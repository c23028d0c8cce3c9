// SPDX-License-Identifier: MIT
// A scene's geometry, textures and materials on the device.
#pragma once

#include "gpu_objects.h"
#include "noise_host.h"
#include "scene.h"
#include "uniform_blocks.h"

namespace lichen::renderer {

/// One primitive's range in the scene's buffers.
struct GpuPrimitive {
  std::uint32_t firstIndex = 0;
  std::uint32_t indexCount = 0;
  std::int32_t vertexOffset = 0;
};

struct GpuScene {
  DeviceBuffer vertices;
  DeviceBuffer displacements; ///< by vertex; null if no primitive is displaced
  DeviceBuffer indices;       ///< 32 bit
  std::vector<GpuPrimitive> primitives;
  std::vector<DeviceImage> images; ///< an image used as both colour and data appears twice
  UniformBlocks materialData;      ///< one block per element of Scene::materials
  VkDescriptorSetLayout materialLayout = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> materialSets; ///< one per element of Scene::materials
};

/// Errors: environment if an image or a primitive exceeds the device's limits.
[[nodiscard]] Result<void> fitsDevice(const Scene& scene, const VkPhysicalDeviceLimits& limits);

/// Throws a Failure.
[[nodiscard]] GpuScene uploadScene(VulkanDevice& device, ObjectOwner& objects, const Scene& scene);

/// Writes the materials' blocks of a frame.
void writeMaterials(const Scene& scene, const NoiseHost& noises, const GpuScene& gpu);

} // namespace lichen::renderer
