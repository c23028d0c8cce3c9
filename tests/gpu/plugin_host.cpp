// SPDX-License-Identifier: MIT
// A small host of the engine plugin for the tests; see plugin_host.h.
#include "plugin_host.h"

#include "checkout_paths.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace lichen::test {
namespace {

LichenNoiseProperties firstNoise(LichenBundle bundle) {
  LichenNoiseProperties noise;
  LICHEN_INIT(noise, LICHEN_STRUCTURE_NOISE_PROPERTIES);
  if (lichenGetNoiseProperties(bundle, 0, &noise) != LICHEN_SUCCESS)
    throw std::runtime_error("the bundle has no noise");
  return noise;
}

/// The pool that exactly one set of the noise fits in, without FREE_DESCRIPTOR_SET.
VkDescriptorPool exactPool(VkDevice device, const LichenNoiseProperties& noise,
                           VkDescriptorType uniformType) {
  const VkDescriptorPoolSize sizes[] = {
      {uniformType, noise.uniformBufferCount},
      {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, noise.combinedImageSamplerCount}};
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = 1;
  info.poolSizeCount = 2;
  info.pPoolSizes = sizes;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  if (vkCreateDescriptorPool(device, &info, nullptr, &pool) != VK_SUCCESS)
    throw std::runtime_error("no descriptor pool");
  return pool;
}

void require(LichenResult result, const LichenDiagnostic& diagnostic) {
  if (result != LICHEN_SUCCESS)
    throw std::runtime_error(diagnostic.text);
}

} // namespace

LichenBundle parseOrThrow(std::span<const std::byte> glb) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  LichenParseInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.bytes = glb.data();
  info.byteCount = glb.size();
  LichenBundle bundle = nullptr;
  require(lichenParseBundle(&info, &bundle, &diagnostic), diagnostic);
  return bundle;
}

LichenVulkanInfo defaultVulkanInfo(const VulkanDevice& device) {
  LichenVulkanInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_VULKAN_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.physicalDevice = device.physicalDevice();
  info.device = device.device();
  info.getInstanceProcAddr = vkGetInstanceProcAddr;
  info.instance = device.instance();
  return info;
}

PluginHost::PluginHost(VulkanDevice& device, std::span<const std::byte> glb,
                       const LichenVulkanInfo& info)
    : device_(device), bundle_(parseOrThrow(glb)), pipelines_(device.device()) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  require(lichenVulkanCreateContext(&info, &context_, &diagnostic), diagnostic);
  require(lichenVulkanCreateAssets(context_, bundle_, &assets_, &diagnostic), diagnostic);
  const bool isDynamic = (info.flags & LICHEN_VULKAN_DYNAMIC_UNIFORMS) != 0;
  const LichenNoiseProperties noise = firstNoise(bundle_);
  imageSamplers_ = noise.combinedImageSamplerCount;
  pool_ = exactPool(device.device(), noise,
                    isDynamic ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC
                              : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
  if (isDynamic)
    dynamicOffsets_ = {LICHEN_UNIFORM_BYTES}; // the second of two blocks
  uniformBuffer_ =
      device.createBuffer(2 * LICHEN_UNIFORM_BYTES, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true)
          .value();
  const VkDescriptorBufferInfo buffer{uniformBuffer_.handle, 0, LICHEN_UNIFORM_BYTES};
  require(lichenVulkanAllocateSet(assets_, 0, pool_, &buffer, &set_, &diagnostic), diagnostic);
}

PluginHost::~PluginHost() {
  vkDestroyDescriptorPool(device_.device(), pool_, nullptr);
  lichenVulkanDestroyAssets(assets_);
  lichenVulkanDestroyContext(context_);
  lichenDestroyBundle(bundle_);
}

std::vector<std::byte> PluginHost::evaluateRun(ComputeRun run, const LichenUniformInfo& uniforms) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  std::byte* const block =
      uniformBuffer_.mapped + (dynamicOffsets_.empty() ? 0 : dynamicOffsets_.front());
  require(lichenFillUniforms(bundle_, &uniforms, block, &diagnostic), diagnostic);
  std::memcpy(&uniforms_, block, sizeof uniforms_);
  run.set = set_;
  run.pipelines = sharedPipelines_ != nullptr ? sharedPipelines_ : &pipelines_;
  run.imageSamplers = sharedPipelines_ != nullptr ? imageSamplers_ : 0;
  run.dynamicOffsets = dynamicOffsets_;
  if (lichenVulkanGetSetLayout(assets_, 0, &run.layout) != LICHEN_SUCCESS)
    throw std::runtime_error("no set layout");
  if (!uploaded_)
    run.before = [&](VkCommandBuffer commands) {
      if (lichenVulkanRecordUpload(assets_, commands) != LICHEN_SUCCESS)
        throw std::runtime_error("the upload was not recorded");
    };
  std::vector<std::byte> values = runCompute(device_, run);
  uploaded_ = true;
  lichenVulkanReleaseStaging(assets_);
  return values;
}

LichenUniformInfo uniformInfo() {
  LichenUniformInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_UNIFORM_INFO);
  return info;
}

LichenUniformInfo movedUniformInfo() {
  LichenUniformInfo info = uniformInfo();
  info.overrides = LICHEN_OVERRIDE_SCALE | LICHEN_OVERRIDE_ROTATION | LICHEN_OVERRIDE_OFFSET |
                   LICHEN_OVERRIDE_SEED;
  info.scale = 0.8;
  info.rotation = 0.6;
  info.offset[0] = 0.25;
  info.offset[1] = -1.5;
  info.seed = 4294967295u;
  return info;
}

std::vector<std::uint32_t> committedShader(const std::string& name) {
  std::ifstream file(sourcePath("spirv/" + name + ".spv"), std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty())
    throw std::runtime_error("spirv/" + name + ".spv cannot be read");
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

} // namespace lichen::test
