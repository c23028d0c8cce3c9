// SPDX-License-Identifier: MIT
// Runs compute shaders over arrays of inputs.
#pragma once

#include <lichen/vulkan_device.h>

#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace lichen::test {

/// Throws std::runtime_error, as allocate() does.
class DescriptorPool {
public:
  DescriptorPool(VkDevice device, std::uint32_t sets, std::span<const VkDescriptorPoolSize> sizes);
  DescriptorPool(const DescriptorPool&) = delete;
  DescriptorPool& operator=(const DescriptorPool&) = delete;
  ~DescriptorPool();
  [[nodiscard]] VkDescriptorPool handle() const { return handle_; }
  [[nodiscard]] VkDescriptorSet allocate(VkDescriptorSetLayout layout) const;

private:
  VkDevice device_;
  VkDescriptorPool handle_ = VK_NULL_HANDLE;
};

struct ComputePipeline;
struct ComputeRun;

/// Shares pipelines between runs on one device: on software devices, compilation takes most of the
/// time of a small run.
class ComputePipelines {
public:
  explicit ComputePipelines(VkDevice device);
  ~ComputePipelines();
  /// Returns the pipeline for the run's shader, constants and layout, created on first use.
  const ComputePipeline& of(const ComputeRun& run);

private:
  VkDevice device_;
  std::vector<std::unique_ptr<ComputePipeline>> all_;
};

struct ComputeRun {
  std::span<const std::uint32_t> spirv;
  std::span<const std::byte> input;        ///< storage buffer, binding 0
  std::size_t outputBytes = 0;             ///< storage buffer, binding 1
  std::uint32_t items = 0;                 ///< invocations; the shader's workgroup size is 64
  std::array<std::int32_t, 2> constants{}; ///< specialization constants 0 and 1
  /// A set that the caller binds as set 0. The two buffers are then in set 1.
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
  std::vector<std::uint32_t> dynamicOffsets; ///< of `set`
  /// Records commands before the dispatch, into the same command buffer.
  std::function<void(VkCommandBuffer)> before;
  ComputePipelines* pipelines = nullptr; ///< of the same device; null: the run creates its own
};

/// Runs that have been submitted and may not have finished: a frame in flight.
class PendingRuns {
public:
  /// Submits the runs, one after the other in one command buffer, and does not wait. Copies their
  /// inputs. Throws std::runtime_error.
  PendingRuns(VulkanDevice& device, std::vector<ComputeRun> runs);
  /// Waits.
  ~PendingRuns();
  PendingRuns(const PendingRuns&) = delete;
  PendingRuns& operator=(const PendingRuns&) = delete;
  /// Waits and returns the bytes of each output buffer. Throws std::runtime_error.
  [[nodiscard]] std::vector<std::vector<std::byte>> outputs();

private:
  struct Submission;
  std::unique_ptr<Submission> submission_;
};

/// Returns the bytes of the output buffer. Throws std::runtime_error with the device's message.
[[nodiscard]] std::vector<std::byte> runCompute(VulkanDevice& device, const ComputeRun& run);

/// The same for several runs, one after the other in one command buffer.
[[nodiscard]] std::vector<std::vector<std::byte>> runComputes(VulkanDevice& device,
                                                              std::span<const ComputeRun> runs);

/// Sets a run's input, with one invocation per element and one or more outputs for each. `inputs`
/// must outlive the run.
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
