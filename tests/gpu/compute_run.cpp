// SPDX-License-Identifier: MIT
// Runs compute shaders over arrays of inputs; see compute_run.h.
#include "compute_run.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

namespace lichen::test {
namespace {

constexpr std::uint32_t kWorkgroup = 64;

void require(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(vulkanError(what, result).message);
}

template <class T>
T require(Result<T> result) {
  if (!result)
    throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

constexpr VkDescriptorPoolSize kBuffers{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};

/// A set of one run's buffers.
VkDescriptorSet bufferSet(VkDevice device, const DescriptorPool& pool, VkDescriptorSetLayout layout,
                          const DeviceBuffer& input, const DeviceBuffer& output) {
  const std::array<VkDescriptorBufferInfo, 2> buffers{
      {{input.handle, 0, VK_WHOLE_SIZE}, {output.handle, 0, VK_WHOLE_SIZE}}};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = pool.allocate(layout);
  write.descriptorCount = kBuffers.descriptorCount; // of bindings 0 and 1
  write.descriptorType = kBuffers.type;
  write.pBufferInfo = buffers.data();
  vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
  return write.dstSet;
}

} // namespace

DescriptorPool::DescriptorPool(VkDevice device, std::uint32_t sets,
                               std::span<const VkDescriptorPoolSize> sizes)
    : device_(device) {
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = sets;
  info.poolSizeCount = std::uint32_t(sizes.size());
  info.pPoolSizes = sizes.data();
  require(vkCreateDescriptorPool(device, &info, nullptr, &handle_), "a descriptor pool");
}

DescriptorPool::~DescriptorPool() { vkDestroyDescriptorPool(device_, handle_, nullptr); }

VkDescriptorSet DescriptorPool::allocate(VkDescriptorSetLayout layout) const {
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = handle_;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  require(vkAllocateDescriptorSets(device_, &info, &set), "a descriptor set");
  return set;
}

/// A pipeline with its inputs, by which it is found again.
struct ComputePipeline {
  ComputePipeline(VkDevice d, const ComputeRun& run)
      : device(d), spirv(run.spirv.begin(), run.spirv.end()), constants(run.constants),
        otherLayout(run.layout) {
    createSetLayout();
    createPipeline();
  }
  ComputePipeline(const ComputePipeline&) = delete;
  ComputePipeline& operator=(const ComputePipeline&) = delete;
  ~ComputePipeline() {
    vkDestroyPipeline(device, pipeline, nullptr);
    vkDestroyPipelineLayout(device, pipelineLayout, nullptr);
    vkDestroyShaderModule(device, module, nullptr);
    vkDestroyDescriptorSetLayout(device, setLayout, nullptr);
  }

  [[nodiscard]] bool serves(const ComputeRun& run) const {
    return constants == run.constants && otherLayout == run.layout &&
           std::equal(spirv.begin(), spirv.end(), run.spirv.begin(), run.spirv.end());
  }

  void createSetLayout() {
    std::array<VkDescriptorSetLayoutBinding, 2> bindings{};
    for (std::uint32_t i = 0; i < 2; ++i)
      bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo layout{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    layout.bindingCount = 2;
    layout.pBindings = bindings.data();
    require(vkCreateDescriptorSetLayout(device, &layout, nullptr, &setLayout), "a set layout");
  }

  void createPipeline() {
    VkShaderModuleCreateInfo moduleInfo{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    moduleInfo.codeSize = spirv.size() * sizeof(std::uint32_t);
    moduleInfo.pCode = spirv.data();
    require(vkCreateShaderModule(device, &moduleInfo, nullptr, &module), "a shader");
    const std::array<VkDescriptorSetLayout, 2> layouts{otherLayout, setLayout};
    const bool hasOther = otherLayout != VK_NULL_HANDLE;
    VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layout.setLayoutCount = hasOther ? 2 : 1;
    layout.pSetLayouts = hasOther ? layouts.data() : &setLayout;
    require(vkCreatePipelineLayout(device, &layout, nullptr, &pipelineLayout), "a pipeline layout");
    constexpr std::uint32_t kBytes = sizeof(std::int32_t);
    const VkSpecializationMapEntry entries[] = {{0, 0, kBytes}, {1, kBytes, kBytes}};
    const VkSpecializationInfo specialization{2, entries, sizeof constants, constants.data()};
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &specialization;
    info.layout = pipelineLayout;
    require(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
            "a pipeline");
  }

  VkDevice device;
  std::vector<std::uint32_t> spirv;
  std::array<std::int32_t, 2> constants;
  VkDescriptorSetLayout otherLayout; // of the caller's set
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  VkShaderModule module = VK_NULL_HANDLE;
  VkPipelineLayout pipelineLayout = VK_NULL_HANDLE;
  VkPipeline pipeline = VK_NULL_HANDLE;
};

ComputePipelines::ComputePipelines(VkDevice device) : device_(device) {}

ComputePipelines::~ComputePipelines() = default;

const ComputePipeline& ComputePipelines::of(const ComputeRun& run) {
  for (const auto& pipeline : all_)
    if (pipeline->serves(run))
      return *pipeline;
  all_.push_back(std::make_unique<ComputePipeline>(device_, run));
  return *all_.back();
}

namespace {

/// A run with its buffers, set and pipeline.
struct Prepared {
  Prepared(VulkanDevice& device, const ComputeRun& r)
      : run(r), input(require(device.createBuffer(r.input.size(), kUsage, true))),
        output(require(device.createBuffer(r.outputBytes, kUsage, true))), own(device.device()),
        pipeline((run.pipelines ? *run.pipelines : own).of(run)),
        pool(device.device(), 1, std::span(&kBuffers, 1)),
        set(bufferSet(device.device(), pool, pipeline.setLayout, input, output)) {
    std::copy(run.input.begin(), run.input.end(), input.mapped);
  }

  void record(VkCommandBuffer commands) const {
    if (run.before)
      run.before(commands);
    const std::array<VkDescriptorSet, 2> sets{run.set, set};
    const bool hasOther = run.set != VK_NULL_HANDLE;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.pipelineLayout, 0,
                            hasOther ? 2 : 1, hasOther ? sets.data() : &set,
                            std::uint32_t(run.dynamicOffsets.size()), run.dynamicOffsets.data());
    vkCmdDispatch(commands, (run.items + kWorkgroup - 1) / kWorkgroup, 1, 1);
  }

  static constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const ComputeRun& run;
  DeviceBuffer input;
  DeviceBuffer output;
  ComputePipelines own;
  const ComputePipeline& pipeline;
  DescriptorPool pool;
  VkDescriptorSet set;
};

std::vector<std::unique_ptr<Prepared>> preparedOf(VulkanDevice& device,
                                                  std::span<const ComputeRun> runs) {
  std::vector<std::unique_ptr<Prepared>> prepared;
  for (const ComputeRun& run : runs)
    prepared.push_back(std::make_unique<Prepared>(device, run));
  return prepared;
}

void record(VkCommandBuffer commands, const std::vector<std::unique_ptr<Prepared>>& all) {
  for (const auto& one : all)
    one->record(commands);
  VkMemoryBarrier toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  toHost.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                       0, 1, &toHost, 0, nullptr, 0, nullptr);
}

std::vector<std::vector<std::byte>> outputsOf(const std::vector<std::unique_ptr<Prepared>>& all) {
  std::vector<std::vector<std::byte>> outputs;
  for (const auto& one : all)
    outputs.emplace_back(one->output.mapped, one->output.mapped + one->run.outputBytes);
  return outputs;
}

} // namespace

struct PendingRuns::Submission {
  Submission(VulkanDevice& device, std::vector<ComputeRun> r)
      : runs(std::move(r)), prepared(preparedOf(device, runs)), handle(device.device()) {}
  Submission(const Submission&) = delete;
  Submission& operator=(const Submission&) = delete;
  ~Submission() {
    if (isSubmitted)
      vkWaitForFences(handle, 1, &fence, VK_TRUE, UINT64_MAX);
    vkDestroyFence(handle, fence, nullptr);
    vkDestroyCommandPool(handle, pool, nullptr);
  }

  const std::vector<ComputeRun> runs;
  const std::vector<std::unique_ptr<Prepared>> prepared;
  const VkDevice handle;
  VkCommandPool pool = VK_NULL_HANDLE;
  VkFence fence = VK_NULL_HANDLE;
  bool isSubmitted = false;
};

PendingRuns::PendingRuns(VulkanDevice& device, std::vector<ComputeRun> runs)
    : submission_(std::make_unique<Submission>(device, std::move(runs))) {
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.queueFamilyIndex = device.queueFamily();
  require(vkCreateCommandPool(device.device(), &pool, nullptr, &submission_->pool), "a pool");
  VkCommandBufferAllocateInfo allocation{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocation.commandPool = submission_->pool;
  allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocation.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  require(vkAllocateCommandBuffers(device.device(), &allocation, &commands), "commands");
  const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  require(vkCreateFence(device.device(), &fence, nullptr, &submission_->fence), "a fence");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  require(vkBeginCommandBuffer(commands, &begin), "commands");
  record(commands, submission_->prepared);
  require(vkEndCommandBuffer(commands), "commands");
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  require(vkQueueSubmit(device.queue(), 1, &submit, submission_->fence), "a submission");
  submission_->isSubmitted = true;
}

PendingRuns::~PendingRuns() = default;

std::vector<std::vector<std::byte>> PendingRuns::outputs() {
  require(vkWaitForFences(submission_->handle, 1, &submission_->fence, VK_TRUE, UINT64_MAX),
          "a fence");
  return outputsOf(submission_->prepared);
}

std::vector<std::vector<std::byte>> runComputes(VulkanDevice& device,
                                                std::span<const ComputeRun> runs) {
  const std::vector<std::unique_ptr<Prepared>> prepared = preparedOf(device, runs);
  const Result<void> submitted =
      device.submit([&](VkCommandBuffer commands) { record(commands, prepared); });
  if (!submitted)
    throw std::runtime_error(submitted.error().message);
  return outputsOf(prepared);
}

std::vector<std::byte> runCompute(VulkanDevice& device, const ComputeRun& run) {
  return runComputes(device, std::span(&run, 1)).front();
}

} // namespace lichen::test
