// SPDX-License-Identifier: MIT
// The renderer's pipelines: depth from a light, surfaces, sky, and the sum of frames.
#pragma once

#include "gpu_objects.h"

#include <array>
#include <vector>

namespace lichen::renderer {

inline constexpr VkFormat kColorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
inline constexpr VkFormat kSumFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

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

  [[nodiscard]] std::size_t index() const {
    return std::size_t(hasNoise) * 4 + std::size_t(hasNormalMap) * 2 + std::size_t(blends);
  }
};

/// Of the pipelines that vary by material, those that a scene draws with.
struct PipelinesUsed {
  std::array<bool, 8> surfaces{};      ///< by SurfaceKind::index()
  std::array<bool, 2> depthWithGaps{}; ///< as Pipelines::depthWithGaps
};

struct Pipelines {
  VkPipelineLayout sceneLayout = VK_NULL_HANDLE; ///< sets: frame, material, noise
  VkPipelineLayout depthLayout = VK_NULL_HANDLE; ///< sets: frame (unused), material, noise
  VkPipelineLayout accumulateLayout = VK_NULL_HANDLE;
  VkPipeline depthOpaque = VK_NULL_HANDLE;   ///< reads no set
  std::array<VkPipeline, 2> depthWithGaps{}; ///< of masks and blends; without and with a noise
  VkPipeline sky = VK_NULL_HANDLE;
  VkPipeline accumulate = VK_NULL_HANDLE;
  std::array<VkPipeline, 8> surfaces{}; ///< by SurfaceKind::index(); null where it is not used

  [[nodiscard]] VkPipeline surface(const SurfaceKind& kind) const { return surfaces[kind.index()]; }
};

struct PipelineLayouts {
  VkDescriptorSetLayout frame = VK_NULL_HANDLE;
  VkDescriptorSetLayout material = VK_NULL_HANDLE;
  VkDescriptorSetLayout noise = VK_NULL_HANDLE;
  VkDescriptorSetLayout accumulate = VK_NULL_HANDLE;
};

/// What all surfaces of a scene share at compile time.
struct SurfaceConstants {
  int debugView = 0;          ///< one of the shaders' DEBUG_ constants
  bool otherTables = false;   ///< some tiling noise has a separable table, or none
  bool tilingNoises = false;  ///< some noise is one of tiling
  bool textonNoises = false;  ///< some noise is one of textons
  bool surfaceNoises = false; ///< some noise is mapped onto a surface, without texture coordinates
  bool triplanarNoises = false; ///< some noise is mapped onto three planes
  bool otherMappings = false;   ///< some noise is mapped otherwise
  bool mixedTextons = false;    ///< some noise is a mix of textons
  bool objectSpaces = false;    ///< some noise is placed in the space of its objects
  bool tileRotation = false;    ///< some noise turns its tiles
  [[nodiscard]] bool operator==(const SurfaceConstants&) const = default;
};

/// The pipelines of all scenes on one device. Each is made when a scene first draws with it and
/// lives as long as the store: a driver may take longer to compile one than to draw a small
/// picture. Not for several threads at once.
class PipelineStore {
public:
  explicit PipelineStore(VkDevice device) : objects_(device) {}

  /// Those that `used` asks for. The set layouts of all calls must be defined identically, and need
  /// not outlive the call. Culling and front face are dynamic. Throws a Failure.
  [[nodiscard]] Pipelines pipelinesFor(const PipelineLayouts& layouts,
                                       const SurfaceConstants& constants,
                                       const PipelinesUsed& used);

private:
  struct Stored {
    SurfaceConstants constants;
    std::size_t kind = 0; ///< SurfaceKind::index(), or 1 for depth with a noise
    VkPipeline pipeline = VK_NULL_HANDLE;
  };

  void createShared(const PipelineLayouts& layouts);
  [[nodiscard]] VkPipeline surface(const SurfaceConstants& constants, std::size_t kind);
  [[nodiscard]] VkPipeline depthWithGaps(const SurfaceConstants& constants, bool hasNoise);

  ObjectOwner objects_;
  Pipelines shared_; ///< layouts, and the pipelines that all scenes have
  std::vector<Stored> surfaces_;
  std::vector<Stored> depths_;
};

} // namespace lichen::renderer
