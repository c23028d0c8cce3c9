// SPDX-License-Identifier: MIT
// A small host of the engine plugin for tests: a bundle's bytes -> a descriptor set that a compute
// shader reads. Records the upload into the command buffer of its first run.
#pragma once

#include "compute_run.h"
#include "tiling_reference.h"

#include <lichen/lichen_vulkan.h>

#include <lichen_interface.h>

namespace lichen::test {

/// Parses a bundle. Throws std::runtime_error with the plugin's diagnostic.
[[nodiscard]] LichenBundle parseOrThrow(std::span<const std::byte> glb);

/// The minimal info for this device: only the loader's entry point.
[[nodiscard]] LichenVulkanInfo defaultVulkanInfo(const VulkanDevice& device);

class PluginHost {
public:
  PluginHost(VulkanDevice& device, std::span<const std::byte> glb, const LichenVulkanInfo& info);
  PluginHost(VulkanDevice& device, std::span<const std::byte> glb)
      : PluginHost(device, glb, defaultVulkanInfo(device)) {}
  /// With pipelines that outlive it.
  PluginHost(VulkanDevice& device, std::span<const std::byte> glb, ComputePipelines& pipelines)
      : PluginHost(device, glb) {
    sharedPipelines_ = &pipelines;
  }
  ~PluginHost();
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  [[nodiscard]] LichenBundle bundle() const { return bundle_; }
  [[nodiscard]] LichenVulkanAssets assets() const { return assets_; }
  /// Uses another set of the same layout, whose bindings the caller has written.
  void useSet(VkDescriptorSet set) { set_ = set; }
  [[nodiscard]] VkDescriptorSet set() const { return set_; }
  [[nodiscard]] VkBuffer uniformBuffer() const { return uniformBuffer_.handle; }

  /// Writes the uniforms and runs `spirv` (set 0: the noise; set 1: points, values) over `points`,
  /// with `valuesEach` four-component values per point.
  template <class AnyPoint>
  [[nodiscard]] std::vector<std::array<float, 4>>
  evaluate(std::span<const std::uint32_t> spirv, std::int32_t constant,
           const LichenUniformInfo& uniforms, const std::vector<AnyPoint>& points,
           std::size_t valuesEach = 1) {
    ComputeRun run;
    run.spirv = spirv;
    run.constant = constant;
    setArrays<std::array<float, 4>>(run, points, valuesEach);
    return asArray<std::array<float, 4>>(evaluateRun(std::move(run), uniforms));
  }
  /// The uniforms of the last evaluate().
  [[nodiscard]] const shader::LichenUniforms& uniforms() const { return uniforms_; }

private:
  [[nodiscard]] std::vector<std::byte> evaluateRun(ComputeRun run,
                                                   const LichenUniformInfo& uniforms);

  VulkanDevice& device_;
  LichenBundle bundle_ = nullptr;
  LichenVulkanContext context_ = nullptr;
  LichenVulkanAssets assets_ = nullptr;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  DeviceBuffer uniformBuffer_;
  std::vector<std::uint32_t> dynamicOffsets_; ///< one with LICHEN_VULKAN_DYNAMIC_UNIFORMS
  shader::LichenUniforms uniforms_{};
  bool uploaded_ = false;
  std::uint32_t imageSamplers_ = 0; ///< in the set
  ComputePipelines pipelines_;
  ComputePipelines* sharedPipelines_ = nullptr;
};

/// The material's own uniforms, and the same scaled, rotated, moved and with another seed.
[[nodiscard]] LichenUniformInfo uniformInfo();
[[nodiscard]] LichenUniformInfo movedUniformInfo();

/// A committed shader, spirv/NAME.spv.
[[nodiscard]] std::vector<std::uint32_t> committedShader(const std::string& name);

} // namespace lichen::test
