// SPDX-License-Identifier: MIT
// Freezes specialization constants before a driver compiles a shader; see frozen_constants.h.
#include "frozen_constants.h"

#include <volk.h>

#include <cstring>
#include <mutex>
#include <unordered_map>
#include <vector>
#ifdef LICHEN_HAS_SPIRV_OPT
#include <spirv-tools/optimizer.hpp>
#endif

namespace {

using Words = std::vector<std::uint32_t>;

/// The driver's functions, and the code of each module.
struct Driver {
  PFN_vkCreateShaderModule createShaderModule = nullptr;
  PFN_vkDestroyShaderModule destroyShaderModule = nullptr;
  PFN_vkCreateComputePipelines createComputePipelines = nullptr;
  PFN_vkCreateGraphicsPipelines createGraphicsPipelines = nullptr;
  std::unordered_map<VkShaderModule, Words> codes;
};

std::mutex mutex; // of the codes: tests create devices in several threads

Driver& driver() {
  static Driver instance;
  return instance;
}

#ifdef LICHEN_HAS_SPIRV_OPT
/// Tells the inliner to leave functions alone that are longer than those that only tell whether a
/// noise has a method or a mapping. Their calls are the conditions of most branches.
void leaveLargeFunctions(Words& code) {
  // SPIR-V 1.0: OpFunction, OpFunctionEnd, the DontInline bit, and the words of a module's header.
  constexpr std::uint32_t kFunction = 54, kFunctionEnd = 56, kDontInline = 2;
  constexpr std::size_t kHeaderWords = 5;
  constexpr std::size_t kSmallWords = 150; // 300 make no test faster
  std::size_t begin = 0;
  for (std::size_t at = kHeaderWords; at < code.size(); at += code[at] >> 16) {
    const std::uint32_t operation = code[at] & 0xFFFF;
    if (operation == kFunction)
      begin = at;
    if (operation == kFunctionEnd && at - begin > kSmallWords)
      code[begin + 3] |= kDontInline;
  }
}
#endif

/// `code` for these constants; empty where it stays as it is. With `switches`, constants say which
/// methods and mappings the noises have.
Words frozen(Words code, const VkSpecializationInfo& constants, bool switches) {
  Words result;
#ifdef LICHEN_HAS_SPIRV_OPT
  std::unordered_map<std::uint32_t, Words> values;
  for (std::uint32_t k = 0; k < constants.mapEntryCount; ++k) {
    const VkSpecializationMapEntry& entry = constants.pMapEntries[k];
    if (entry.size != sizeof(std::uint32_t))
      return {};
    std::uint32_t value = 0;
    std::memcpy(&value, static_cast<const char*>(constants.pData) + entry.offset, sizeof value);
    values[entry.constantID] = {value};
  }
  if (switches)
    leaveLargeFunctions(code);
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_0);
  optimizer.SetMessageConsumer([](auto...) {}); // it warns of what it does not inline
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
      .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
  if (switches)
    optimizer.RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
  spvtools::OptimizerOptions options;
  options.set_run_validator(false); // the layers validate the result
  if (!optimizer.Run(code.data(), code.size(), &result, options))
    return {};
#else
  static_cast<void>(code);
  static_cast<void>(constants);
  static_cast<void>(switches);
#endif
  return result;
}

Words codeOf(VkShaderModule module) {
  const std::lock_guard lock(mutex);
  return driver().codes[module];
}

/// Stages with frozen modules in place of their own, until it is destroyed.
class FrozenStages {
public:
  explicit FrozenStages(VkDevice device) : device_(device) {}
  FrozenStages(const FrozenStages&) = delete;
  FrozenStages& operator=(const FrozenStages&) = delete;
  ~FrozenStages() {
    for (VkShaderModule module : made_)
      driver().destroyShaderModule(device_, module, nullptr);
  }

  void freeze(VkPipelineShaderStageCreateInfo& stage) {
    const VkSpecializationInfo* const constants = stage.pSpecializationInfo;
    if (constants == nullptr)
      return;
    const bool isRenderers = stage.stage != VK_SHADER_STAGE_COMPUTE_BIT;
    const Words code = frozen(codeOf(stage.module), *constants, isRenderers);
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = code.size() * sizeof(std::uint32_t);
    info.pCode = code.data();
    VkShaderModule module = VK_NULL_HANDLE;
    if (code.empty() || driver().createShaderModule(device_, &info, nullptr, &module) != VK_SUCCESS)
      return;
    made_.push_back(module);
    stage.module = module;
    stage.pSpecializationInfo = nullptr;
  }

private:
  VkDevice device_;
  std::vector<VkShaderModule> made_;
};

VKAPI_ATTR VkResult VKAPI_CALL createShaderModule(VkDevice device,
                                                  const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator,
                                                  VkShaderModule* module) {
  const VkResult result = driver().createShaderModule(device, info, allocator, module);
  if (result != VK_SUCCESS)
    return result;
  const std::lock_guard lock(mutex);
  driver().codes[*module] = Words(info->pCode, info->pCode + info->codeSize / 4);
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroyShaderModule(VkDevice device, VkShaderModule module,
                                               const VkAllocationCallbacks* allocator) {
  {
    const std::lock_guard lock(mutex);
    driver().codes.erase(module);
  }
  driver().destroyShaderModule(device, module, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL createComputePipelines(VkDevice device, VkPipelineCache cache,
                                                      std::uint32_t count,
                                                      const VkComputePipelineCreateInfo* infos,
                                                      const VkAllocationCallbacks* allocator,
                                                      VkPipeline* pipelines) {
  FrozenStages stages(device);
  std::vector<VkComputePipelineCreateInfo> all(infos, infos + count);
  for (VkComputePipelineCreateInfo& info : all)
    stages.freeze(info.stage);
  return driver().createComputePipelines(device, cache, count, all.data(), allocator, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL createGraphicsPipelines(VkDevice device, VkPipelineCache cache,
                                                       std::uint32_t count,
                                                       const VkGraphicsPipelineCreateInfo* infos,
                                                       const VkAllocationCallbacks* allocator,
                                                       VkPipeline* pipelines) {
  FrozenStages stages(device);
  std::vector<VkGraphicsPipelineCreateInfo> all(infos, infos + count);
  std::vector<std::vector<VkPipelineShaderStageCreateInfo>> ofEach;
  for (VkGraphicsPipelineCreateInfo& info : all) {
    ofEach.emplace_back(info.pStages, info.pStages + info.stageCount);
    for (VkPipelineShaderStageCreateInfo& stage : ofEach.back())
      stages.freeze(stage);
    info.pStages = ofEach.back().data();
  }
  return driver().createGraphicsPipelines(device, cache, count, all.data(), allocator, pipelines);
}

} // namespace

namespace lichen::test {

void freezeConstants() {
  if (vkCreateShaderModule == &createShaderModule)
    return;
  driver() = {vkCreateShaderModule, vkDestroyShaderModule, vkCreateComputePipelines,
              vkCreateGraphicsPipelines, std::move(driver().codes)};
  vkCreateShaderModule = &createShaderModule;
  vkDestroyShaderModule = &destroyShaderModule;
  vkCreateComputePipelines = &createComputePipelines;
  vkCreateGraphicsPipelines = &createGraphicsPipelines;
}

} // namespace lichen::test
