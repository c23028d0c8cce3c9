// SPDX-License-Identifier: MIT
// A small host of the engine plugin for tests: a bundle's bytes -> a descriptor set that a compute
// shader reads. Records the upload into the command buffer of its first run.
#pragma once

#include "compute_run.h"
#include "synthetic_noise.h"
#include "tiling_reference.h"

#include <lichen/lichen_vulkan.h>

#include <lichen_interface.h>
#include <memory>

namespace lichen::test {

/// Base colour, slopes and ORM of a synthetic noise.
inline constexpr std::array<SyntheticMap, 3> kThreeMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32}}};

/// Points on a line across several tiles, with an elongated footprint.
[[nodiscard]] std::vector<Point> linePoints();

/// Parses a bundle. Throws std::runtime_error with the plugin's diagnostic.
[[nodiscard]] LichenBundle parseOrThrow(std::span<const std::byte> glb);

/// The minimal info for this device: only the loader's entry point.
[[nodiscard]] LichenVulkanInfo defaultVulkanInfo(const VulkanDevice& device);

/// How a material uses a noise, and where.
struct MaterialUse {
  LichenMaterialParameters parameters;
  LichenPlacement placement;
};

/// The same scaled, rotated, moved and with another seed.
[[nodiscard]] MaterialUse moved(MaterialUse use);

/// The descriptors of one set without layers and dynamic offsets.
inline constexpr std::array<VkDescriptorPoolSize, 3> kSetSizes{
    {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2},
     {VK_DESCRIPTOR_TYPE_SAMPLER, 2},
     {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, LICHEN_SET_IMAGES}}};

/// A plugin context with the pipelines of its set layout. Pipelines take most of the time of a
/// small run on software devices: share a context where the tests do not look at it.
class PluginContext {
public:
  PluginContext(VulkanDevice& device, const LichenVulkanInfo& info);
  explicit PluginContext(VulkanDevice& device) : PluginContext(device, defaultVulkanInfo(device)) {}
  ~PluginContext();
  PluginContext(const PluginContext&) = delete;
  PluginContext& operator=(const PluginContext&) = delete;

  [[nodiscard]] VulkanDevice& device() const { return device_; }
  [[nodiscard]] LichenVulkanContext context() const { return context_; }
  [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_; }
  [[nodiscard]] ComputePipelines& pipelines() { return pipelines_; }
  /// Whether material blocks have a dynamic offset.
  [[nodiscard]] bool isDynamic() const { return isDynamic_; }
  /// A pool that this many sets fit in, and no more, without FREE_DESCRIPTOR_SET.
  [[nodiscard]] DescriptorPool createPool(std::uint32_t sets) const;

private:
  VulkanDevice& device_;
  const bool isDynamic_;
  LichenVulkanContext context_ = nullptr;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  ComputePipelines pipelines_;
};

/// A set of a noise of a bundle, of the first one at first.
class PluginHost {
public:
  PluginHost(PluginContext& context, std::shared_ptr<LichenBundle_T> bundle);
  PluginHost(PluginContext& context, std::span<const std::byte> glb)
      : PluginHost(context, {parseOrThrow(glb), lichenDestroyBundle}) {}
  PluginHost(VulkanDevice& device, std::span<const std::byte> glb, const LichenVulkanInfo& info)
      : PluginHost(std::make_unique<PluginContext>(device, info), glb) {}
  PluginHost(VulkanDevice& device, std::span<const std::byte> glb)
      : PluginHost(device, glb, defaultVulkanInfo(device)) {}
  ~PluginHost();
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  [[nodiscard]] LichenBundle bundle() const { return bundle_.get(); }
  [[nodiscard]] LichenVulkanAssets assets() const { return assets_; }
  [[nodiscard]] PluginContext& context() const { return context_; }
  /// Evaluates another noise of the bundle from now on.
  void setNoise(std::uint32_t noise);
  /// The caller has uploaded the assets.
  void noteUploaded() { uploaded_ = true; }
  [[nodiscard]] VkDescriptorSet set() const { return set_; }

  /// What a material of the bundle says, at the origin.
  [[nodiscard]] MaterialUse use(std::uint32_t material = 0) const;

  /// Writes the material's block and runs `spirv` (set 0: the noise; set 1: points, values) over
  /// `points`, with `valuesEach` four-component values per point. The specialization constants are
  /// `constant` and the role of the noise's first map.
  template <class AnyPoint>
  [[nodiscard]] std::vector<std::array<float, 4>>
  evaluate(std::span<const std::uint32_t> spirv, std::int32_t constant, const MaterialUse& use,
           const std::vector<AnyPoint>& points, std::size_t valuesEach = 1) {
    ComputeRun run;
    run.spirv = spirv;
    run.constants = {constant, std::int32_t(role_)};
    setArrays<std::array<float, 4>>(run, points, valuesEach);
    return asArray<std::array<float, 4>>(evaluateRun(std::move(run), use));
  }
  /// The block of the last evaluate(): of triplanar mapping all of it, of others its material.
  [[nodiscard]] const shader::LichenTriplanarMaterial& planes() const { return planes_; }
  [[nodiscard]] const shader::LichenMaterial& material() const { return planes_.material; }
  /// The block of the noise.
  [[nodiscard]] const shader::LichenNoiseConstants& constants() const { return constants_; }
  /// The noise's first map.
  [[nodiscard]] const shader::LichenMap& map() const { return constants_.maps[role_]; }

private:
  PluginHost(std::unique_ptr<PluginContext> own, std::span<const std::byte> glb)
      : PluginHost(*own, glb) {
    own_ = std::move(own);
  }
  [[nodiscard]] std::vector<std::byte> evaluateRun(ComputeRun run, const MaterialUse& use);

  std::unique_ptr<PluginContext> own_;
  PluginContext& context_;
  std::shared_ptr<LichenBundle_T> bundle_;
  LichenVulkanAssets assets_ = nullptr;
  DescriptorPool pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  DeviceBuffer materialBuffer_; ///< two blocks, of which the second is used where dynamic
  std::uint32_t role_ = 0;      ///< of the noise's first map
  shader::LichenTriplanarMaterial planes_{};
  shader::LichenNoiseConstants constants_{};
  bool uploaded_ = false;
};

/// A committed shader, spirv/NAME.spv.
[[nodiscard]] std::vector<std::uint32_t> committedShader(const std::string& name);

} // namespace lichen::test
