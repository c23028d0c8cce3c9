// SPDX-License-Identifier: MIT
// A scene on a Vulkan device that is drawn again and again: what stays from frame to frame, what
// may change between two frames, and the sum of frames since the last change.
#pragma once

#include "frame_data.h"
#include "frame_targets.h"
#include "gpu_environment.h"
#include "gpu_scene.h"
#include "noise_changes.h"
#include "noise_host.h"
#include "pipelines.h"
#include "renderer.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen::renderer {

/// Every function that is not const may throw a Failure, with renderScene()'s errors, after which
/// the object is only good to be destroyed. Not for several threads at once. The device is idle
/// whenever no function runs, so that what frames read may be changed between them.
class SceneRenderer {
public:
  /// Device, scene and the settings' store of pipelines must outlive it. Of the settings, `frames`
  /// may be changed later, as may the size, the camera, the debug view and the exposure.
  SceneRenderer(VulkanDevice& device, const Scene& scene, const RenderSettings& settings);

  /// What is left out or changed, with the camera and the noise as they are, one sentence each.
  [[nodiscard]] std::vector<std::string> notes() const;
  [[nodiscard]] const Camera& camera() const { return inputs_.camera; }
  [[nodiscard]] const Sphere& subject() const { return inputs_.subject; }
  /// Of the bundle's noises, as the file has them; may be empty.
  [[nodiscard]] const std::vector<std::string>& noiseNames() const { return noises_.names(); }

  // After any of these the next frame is to be frame 0.
  void setSize(std::uint32_t width, std::uint32_t height);
  void setFrames(std::uint32_t frames); ///< at least 1
  void setPreview();                    ///< one frame that is soon followed by others: quicker
  void setCamera(const Camera& camera);
  void setExposure(float exposureEv) { exposureEv_ = exposureEv; } ///< stops
  void setDebugView(const std::string& name);                      ///< see RenderSettings
  void setNoise(const NoiseChanges& changes);

  /// Draws frame `index`, below `frames`, and adds it to the sum, which frame 0 starts. Waits.
  void drawFrame(std::uint32_t index);
  /// The sum of frames, in GENERAL; its values divided by their number are those of a Picture.
  [[nodiscard]] const DeviceImage& sum() const { return targets_.sum; }
  /// The average of that many frames, RGB.
  [[nodiscard]] LinearImage average(std::uint32_t frames);

private:
  [[nodiscard]] GpuEnvironment lightAround(const RenderSettings& settings);
  void noteCoarseVertices(std::vector<std::string>& notes) const;
  void noteUnseenNoise(std::vector<std::string>& notes) const;
  void noteMissingTexCoords(std::vector<std::string>& notes) const;
  void createFrameSet(VkFilter depthFilter);
  [[nodiscard]] VkDescriptorSet createSet(std::span<const Descriptor> descriptors,
                                          VkShaderStageFlags stages, VkDescriptorSetLayout& layout);
  [[nodiscard]] std::array<Descriptor, 2> accumulateDescriptors() const;
  [[nodiscard]] SurfaceConstants surfaceConstants() const;
  [[nodiscard]] PipelinesUsed pipelinesUsed() const;
  void choosePipelines();

  [[nodiscard]] const Material& materialOf(const Instance& instance) const;
  [[nodiscard]] SurfaceKind kindOf(std::size_t material) const;
  [[nodiscard]] std::vector<std::size_t> blendedOrder() const;

  void bindGeometry(VkCommandBuffer commands) const;
  void bindMaterial(VkCommandBuffer commands, VkPipelineLayout layout, std::size_t material) const;
  void drawPrimitive(VkCommandBuffer commands, std::size_t primitive) const;
  void drawSurface(VkCommandBuffer commands, const Instance& instance, VkCullModeFlags cull) const;
  void drawOpaque(VkCommandBuffer commands, const Instance& instance) const;
  void drawBlended(VkCommandBuffer commands, const Instance& instance) const;
  void recordDepthMap(VkCommandBuffer commands, VkImageView view, std::uint32_t side,
                      const glm::mat4& clipFromWorld) const;
  void recordDepthMaps(VkCommandBuffer commands, const FrameView& view) const;
  void recordSurfaces(VkCommandBuffer commands) const;
  void recordAccumulate(VkCommandBuffer commands, std::uint32_t index) const;

  VulkanDevice& device_;
  const Scene& scene_;
  float exposureEv_;
  bool toneMap_;
  int debugView_;
  ObjectOwner objects_;
  NoiseHost noises_;
  GpuScene gpu_;
  FrameInputs inputs_;
  bool hasHaze_ = false;
  std::vector<std::pair<std::size_t, glm::dvec3>> blended_; ///< instances and their middles
  std::vector<std::size_t> blendedOrder_;
  GpuEnvironment environment_;
  FrameTargets targets_;
  LightMaps lightMaps_;
  DeviceBuffer frameData_;
  VkDescriptorSetLayout frameLayout_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout accumulateLayout_ = VK_NULL_HANDLE;
  VkDescriptorSet frameSet_ = VK_NULL_HANDLE;
  VkDescriptorSet accumulateSet_ = VK_NULL_HANDLE;
  std::vector<std::string> environmentNotes_;
  std::optional<PipelineStore> ownStore_; ///< unless the settings have one
  PipelineStore& store_;
  Pipelines pipelines_;
};

} // namespace lichen::renderer
