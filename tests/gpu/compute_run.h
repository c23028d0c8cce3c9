// SPDX-License-Identifier: MIT
// Runs compute shaders over arrays of inputs.
#pragma once

#include <lichen/vulkan_device.h>

#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace lichen::test {

struct ComputePipeline;
struct ComputeRun;

/// Pipelines for several runs on one device: software devices compile for most of a small run.
class ComputePipelines {
public:
  explicit ComputePipelines(VkDevice device);
  ~ComputePipelines();
  /// That of the run's shader, constant and layout; made the first time.
  const ComputePipeline& of(const ComputeRun& run);

private:
  VkDevice device_;
  std::vector<std::unique_ptr<ComputePipeline>> all_;
};

struct ComputeRun {
  std::span<const std::uint32_t> spirv;
  std::span<const std::byte> input; ///< storage buffer, binding 0
  std::size_t outputBytes = 0;      ///< storage buffer, binding 1
  std::uint32_t items = 0;          ///< invocations; the shader's workgroup has 64
  std::int32_t constant = 0;        ///< specialization constant 0
  /// A set of the caller's for set 0; the two buffers are then in set 1.
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
  /// Not 0: of the plugin's layouts, which are alike if they have as many, one pipeline serves all.
  std::uint32_t imageSamplers = 0;
  std::vector<std::uint32_t> dynamicOffsets; ///< of that set
  /// Records before the dispatch, in the same command buffer.
  std::function<void(VkCommandBuffer)> before;
  ComputePipelines* pipelines = nullptr; ///< of the same device; null: made for this run
};

/// The output buffer's bytes. Throws std::runtime_error with the device's message.
[[nodiscard]] std::vector<std::byte> runCompute(VulkanDevice& device, const ComputeRun& run);

/// Those of several runs, one after the other in one command buffer.
[[nodiscard]] std::vector<std::vector<std::byte>> runComputes(VulkanDevice& device,
                                                              std::span<const ComputeRun> runs);

/// Gives a run its input, one invocation for each element, and one or more outputs for each. The
/// input must outlive it.
template <class Output, class Input>
void setArrays(ComputeRun& run, const std::vector<Input>& inputs, std::size_t outputsEach = 1) {
  run.input = std::as_bytes(std::span(inputs));
  run.items = std::uint32_t(inputs.size());
  run.outputBytes = inputs.size() * outputsEach * sizeof(Output);
}

template <class Output>
std::vector<Output> asArray(std::span<const std::byte> bytes) {
  std::vector<Output> outputs(bytes.size() / sizeof(Output));
  std::memcpy(outputs.data(), bytes.data(), bytes.size());
  return outputs;
}

/// One run with typed arrays.
template <class Output, class Input>
std::vector<Output> runCompute(VulkanDevice& device, ComputeRun run,
                               const std::vector<Input>& inputs, std::size_t outputsEach = 1) {
  setArrays<Output>(run, inputs, outputsEach);
  return asArray<Output>(runCompute(device, run));
}

} // namespace lichen::test
