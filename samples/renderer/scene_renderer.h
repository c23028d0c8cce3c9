// SPDX-License-Identifier: MIT
// Renders a scene repeatedly: owns what stays the same from frame to frame, applies changes between
// frames, and accumulates the frames since the last change.
#pragma once

#include "frame_data.h"
#include "frame_targets.h"
#include "gpu_environment.h"
#include "gpu_scene.h"
#include "noise_changes.h"
#include "noise_host.h"
#include "pipelines.h"
#include "renderer.h"
#include "uniform_blocks.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen::renderer {

/// Every non-const function may throw a Failure with the errors of renderScene(); after that the
/// object may only be destroyed. Not thread-safe. Call none while a frame is in flight.
class SceneRenderer {
public:
  /// The device, the scene and the settings' pipeline store must outlive the object. The setters
  /// below can change `frames`, size, camera, debug view and exposure later.
  SceneRenderer(VulkanDevice& device, const Scene& scene, const RenderSettings& settings);

  /// What is ignored or changed with the current camera and noise, one sentence each.
  [[nodiscard]] std::vector<std::string> notes() const;
  [[nodiscard]] const Camera& camera() const { return inputs_.camera; }
  [[nodiscard]] const Sphere& subject() const { return inputs_.subject; }

  // After any of these calls, continue with frame 0.
  void setSize(std::uint32_t width, std::uint32_t height);
  void setFrames(std::uint32_t frames); ///< at least 1
  void setPreview();                    ///< one quick frame, soon replaced by others
  void setCamera(const Camera& camera);
  void setExposure(float exposureEv) { exposureEv_ = exposureEv; } ///< stops
  void setDebugView(const std::string& name);                      ///< see RenderSettings
  void setNoise(const NoiseChanges& changes);

  /// Records frame `index`, below `frames`: renders it and adds it to the sum; frame 0 starts a new
  /// sum.
  void recordFrame(VkCommandBuffer commands, std::uint32_t index);
  /// Records frame `index`, submits it and blocks until the device has finished.
  void drawFrame(std::uint32_t index);
  /// The sum of frames, in GENERAL. Divided by the number of frames, it has the values of a
  /// Picture.
  [[nodiscard]] const DeviceImage& sum() const { return targets_.sum; }
  /// The sum divided by `frames`, RGB.
  [[nodiscard]] LinearImage average(std::uint32_t frames);

private:
  [[nodiscard]] GpuEnvironment prepareLight(const RenderSettings& settings);
  void noteInvisibleNoise(std::vector<std::string>& notes) const;
  void noteMissingTexCoords(std::vector<std::string>& notes) const;
  void createFrameSet(VkFilter depthFilter);
  [[nodiscard]] VkDescriptorSet createSet(std::span<const Descriptor> descriptors,
                                          VkShaderStageFlags stages, VkDescriptorSetLayout& layout);
  [[nodiscard]] std::array<Descriptor, 2> accumulateDescriptors() const;
  [[nodiscard]] PipelinesUsed pipelinesUsed() const;
  void choosePipelines();

  [[nodiscard]] const Material& materialOf(const Instance& instance) const;
  [[nodiscard]] bool displaces(std::size_t material) const;
  [[nodiscard]] SurfaceKind kindOf(std::size_t material) const;
  [[nodiscard]] DepthKind depthKindOf(std::size_t material) const;
  [[nodiscard]] std::vector<std::size_t> blendedOrder() const;

  void bindGeometry(VkCommandBuffer commands) const;
  void bindMaterial(VkCommandBuffer commands, VkPipelineLayout layout, std::size_t material) const;
  void drawPrimitive(VkCommandBuffer commands, std::size_t primitive) const;
  void pushDisplaced(VkCommandBuffer commands, const glm::mat4& clipFromWorld, glm::vec2 size,
                     float footprint, const glm::mat4& worldFromObject) const;
  void drawSurface(VkCommandBuffer commands, const FrameView& view, const Instance& instance,
                   VkCullModeFlags cull) const;
  void drawOpaque(VkCommandBuffer commands, const FrameView& view, const Instance& instance) const;
  void drawBlended(VkCommandBuffer commands, const FrameView& view, const Instance& instance) const;
  [[nodiscard]] float spacingOfSubject(const FrameView& view) const;
  void recordDepthMap(VkCommandBuffer commands, VkImageView view, std::uint32_t side,
                      const glm::mat4& clipFromWorld, float spacing) const;
  void recordDepthMaps(VkCommandBuffer commands, const FrameView& view) const;
  void recordSurfaces(VkCommandBuffer commands, const FrameView& view) const;
  void recordAccumulate(VkCommandBuffer commands, std::uint32_t index) const;

  VulkanDevice& device_;
  const Scene& scene_;
  float exposureEv_;
  bool toneMap_;
  int debugView_;
  ObjectOwner objects_;
  std::optional<PipelineStore> ownStore_; ///< unless the settings have one
  PipelineStore& store_;
  NoiseHost noises_;
  GpuScene gpu_;
  FrameInputs inputs_;
  bool hasHaze_ = false;
  /// instances and the centres of their bounding boxes
  std::vector<std::pair<std::size_t, glm::dvec3>> blended_;
  std::vector<std::size_t> blendedOrder_;
  GpuEnvironment environment_;
  FrameTargets targets_;
  LightMaps lightMaps_;
  UniformBlocks frameData_;
  VkDescriptorSetLayout frameLayout_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout accumulateLayout_ = VK_NULL_HANDLE;
  VkDescriptorSet frameSet_ = VK_NULL_HANDLE;
  VkDescriptorSet accumulateSet_ = VK_NULL_HANDLE;
  std::vector<std::string> environmentNotes_;
  Pipelines pipelines_;
};

} // namespace lichen::renderer
