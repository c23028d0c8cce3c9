// SPDX-License-Identifier: MIT
// The renderer's pipelines: depth maps of lights, surfaces, sky, and accumulation of frames.
#pragma once

#include "gpu_objects.h"
#include "noise_context.h"
#include "noise_host.h"

#include <array>
#include <vector>

namespace lichen::renderer {

inline constexpr VkFormat kColorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
inline constexpr VkFormat kSumFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

/// Push constants of surfaces: one of the structs of scene_interface.h, for the vertex shader.
inline constexpr std::uint32_t kDrawBytes = 128; // as many as every device has

/// Push constants of accumulate.comp.
struct AccumulateSettings {
  float exposure = 1.0f;
  std::int32_t toneMap = 1;
  std::int32_t first = 1;
};

struct SurfaceKind {
  bool hasNoise = false;
  bool hasNormalMap = false;
  bool blends = false;
  bool displaces = false;
  bool isLayered = false; ///< the noise

  [[nodiscard]] std::size_t index() const {
    return std::size_t(isLayered) * 16 + std::size_t(displaces) * 8 + std::size_t(hasNoise) * 4 +
           std::size_t(hasNormalMap) * 2 + std::size_t(blends);
  }
};

/// How a surface appears in a depth map.
struct DepthKind {
  bool hasGaps = false;  ///< masked or blended
  bool hasNoise = false; ///< only if it has gaps or is displaced: others read no set
  bool displaces = false;

  [[nodiscard]] std::size_t index() const {
    return std::size_t(displaces) * 4 + std::size_t(hasNoise) * 2 + std::size_t(hasGaps);
  }
};

/// Which of the pipelines that vary by material a scene draws with.
struct PipelinesUsed {
  std::array<bool, 32> surfaces{}; ///< by SurfaceKind::index()
  std::array<bool, 8> depths{};    ///< by DepthKind::index()
};

struct Pipelines {
  VkPipelineLayout sceneLayout = VK_NULL_HANDLE; ///< sets: frame (not of depths), material, noise
  VkPipelineLayout accumulateLayout = VK_NULL_HANDLE;
  VkPipeline sky = VK_NULL_HANDLE;
  VkPipeline accumulate = VK_NULL_HANDLE;
  std::array<VkPipeline, 32> surfaces{}; ///< by SurfaceKind::index(); null if unused
  std::array<VkPipeline, 8> depths{};    ///< by DepthKind::index(); null if unused

  [[nodiscard]] VkPipeline surface(const SurfaceKind& kind) const { return surfaces[kind.index()]; }
  [[nodiscard]] VkPipeline depth(const DepthKind& kind) const { return depths[kind.index()]; }
};

struct PipelineLayouts {
  VkDescriptorSetLayout frame = VK_NULL_HANDLE;
  VkDescriptorSetLayout material = VK_NULL_HANDLE;
  VkDescriptorSetLayout accumulate = VK_NULL_HANDLE;
};

/// What the fragment shaders of all surfaces of a scene are specialized for.
struct SurfaceConstants {
  int debugView = 0; ///< one of the shaders' DEBUG_ constants
  NoiseFeatures noises;
  [[nodiscard]] bool operator==(const SurfaceConstants&) const = default;
};

/// The pipelines of all scenes on one device. Each is made when a scene first draws with it and
/// lives as long as the store: a driver may take longer to compile one than to draw a small
/// picture. Not thread-safe.
class PipelineStore {
public:
  /// Throws a Failure. The device must outlive the store.
  explicit PipelineStore(VulkanDevice& device) : noises_(device), objects_(device.device()) {}

  /// The noise plugin's context, which lives as long as the store.
  [[nodiscard]] const NoiseContext& noiseContext() const { return noises_; }

  /// The pipelines that `used` asks for. The set layouts of all calls must be defined identically;
  /// they need not outlive the call. Cull mode and front face are dynamic state. Throws a Failure.
  [[nodiscard]] Pipelines pipelinesFor(const PipelineLayouts& layouts,
                                       const SurfaceConstants& constants,
                                       const PipelinesUsed& used);

private:
  struct Stored {
    SurfaceConstants constants;
    std::size_t kind = 0; ///< SurfaceKind::index() or DepthKind::index()
    VkPipeline pipeline = VK_NULL_HANDLE;
  };

  void createShared(const PipelineLayouts& layouts);
  [[nodiscard]] VkPipeline surface(const SurfaceConstants& constants, std::size_t kind);
  [[nodiscard]] VkPipeline depth(const SurfaceConstants& constants, std::size_t kind);

  NoiseContext noises_;
  ObjectOwner objects_;
  Pipelines shared_; ///< layouts, and the pipelines that all scenes have
  std::vector<Stored> surfaces_;
  std::vector<Stored> depths_;
};

} // namespace lichen::renderer
