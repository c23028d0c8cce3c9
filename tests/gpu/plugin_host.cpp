// SPDX-License-Identifier: MIT
// A small host of the engine plugin for the tests; see plugin_host.h.
#include "plugin_host.h"

#include "checkout_paths.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace lichen::test {
namespace {

/// Bytes between material blocks: a multiple of every device's minUniformBufferOffsetAlignment.
constexpr std::uint32_t kBlockStride = 1536; // a multiple of any alignment

void require(LichenResult result, const LichenDiagnostic& diagnostic) {
  if (result != LICHEN_SUCCESS)
    throw std::runtime_error(diagnostic.text);
}

void require(LichenResult result, const char* what) {
  if (result != LICHEN_SUCCESS)
    throw std::runtime_error(what);
}

void requireVulkan(VkResult result) {
  if (result != VK_SUCCESS)
    throw std::runtime_error("no descriptor set");
}

LichenDiagnostic emptyDiagnostic() {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  return diagnostic;
}

} // namespace

std::vector<Point> linePoints() {
  std::vector<Point> points(200);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{float(k) * 0.013f, float(k) * -0.007f}, {0.02f, 0.0f}, {0.0f, 0.05f}, {}};
  return points;
}

LichenBundle parseOrThrow(std::span<const std::byte> glb) {
  LichenDiagnostic diagnostic = emptyDiagnostic();
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

MaterialUse moved(MaterialUse use) {
  use.parameters.scale = 0.8;
  use.parameters.rotation = 0.6;
  use.parameters.offset[0] = 0.25;
  use.parameters.offset[1] = -1.5;
  use.parameters.seed = 4294967295u;
  return use;
}

PluginContext::PluginContext(VulkanDevice& device, const LichenVulkanInfo& info)
    : device_(device), isDynamic_((info.flags & LICHEN_VULKAN_DYNAMIC_UNIFORMS) != 0),
      pipelines_(device.device()) {
  LichenDiagnostic diagnostic = emptyDiagnostic();
  require(lichenVulkanCreateContext(&info, &context_, &diagnostic), diagnostic);
  require(lichenVulkanGetSetLayout(context_, &layout_), "no set layout");
}

PluginContext::~PluginContext() { lichenVulkanDestroyContext(context_); }

VkDescriptorPool PluginContext::createPool(std::uint32_t sets) const {
  const VkDescriptorPoolSize sizes[] = {
      {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, isDynamic_ ? sets : 2 * sets},
      {VK_DESCRIPTOR_TYPE_SAMPLER, 2 * sets},
      {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, LICHEN_LAYERED_SET_IMAGES * sets},
      {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, sets}};
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = sets;
  info.poolSizeCount = isDynamic_ ? 4 : 3;
  info.pPoolSizes = sizes;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  if (vkCreateDescriptorPool(device_.device(), &info, nullptr, &pool) != VK_SUCCESS)
    throw std::runtime_error("no descriptor pool");
  return pool;
}

PluginHost::PluginHost(PluginContext& context, std::shared_ptr<LichenBundle_T> bundle)
    : context_(context), bundle_(std::move(bundle)), pool_(context.createPool(1)) {
  LichenDiagnostic diagnostic = emptyDiagnostic();
  require(lichenVulkanCreateAssets(context.context(), bundle_.get(), &assets_, &diagnostic),
          diagnostic);
  materialBuffer_ = context.device()
                        .createBuffer(2 * kBlockStride, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true)
                        .value();
  setNoise(0);
}

void PluginHost::setNoise(std::uint32_t noise) {
  require(lichenGetNoiseConstants(bundle_.get(), noise, &constants_), "no noise");
  LichenMapProperties map;
  LICHEN_INIT(map, LICHEN_STRUCTURE_MAP_PROPERTIES);
  require(lichenGetMapProperties(bundle_.get(), noise, 0, &map), "no map");
  role_ = std::uint32_t(map.target);
  vkResetDescriptorPool(context_.device().device(), pool_, 0);
  LichenDiagnostic diagnostic = emptyDiagnostic();
  const VkDescriptorBufferInfo buffer{materialBuffer_.handle, 0, LICHEN_LAYERED_MATERIAL_BYTES};
  require(lichenVulkanAllocateSet(assets_, noise, pool_, &buffer, &set_, &diagnostic), diagnostic);
}

PluginHost::~PluginHost() {
  vkDestroyDescriptorPool(context_.device().device(), pool_, nullptr);
  lichenVulkanDestroyAssets(assets_);
}

MaterialUse PluginHost::use(std::uint32_t material) const {
  MaterialUse use;
  LICHEN_INIT(use.parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  LICHEN_INIT(use.placement, LICHEN_STRUCTURE_PLACEMENT);
  require(lichenGetMaterialParameters(bundle_.get(), material, &use.parameters),
          "no such material");
  return use;
}

std::vector<std::byte> PluginHost::evaluateRun(ComputeRun run, const MaterialUse& use) {
  LichenDiagnostic diagnostic = emptyDiagnostic();
  if (context_.isDynamic())
    run.dynamicOffsets = {kBlockStride};
  std::byte* const block = materialBuffer_.mapped + (context_.isDynamic() ? kBlockStride : 0);
  require(lichenFillMaterial(&use.parameters, &use.placement, block, &diagnostic), diagnostic);
  std::memcpy(&planes_, block, sizeof planes_);
  run.layout = context_.layout();
  run.set = set_;
  run.pipelines = &context_.pipelines();
  if (!uploaded_)
    run.before = [&](VkCommandBuffer commands) {
      require(lichenVulkanRecordUpload(assets_, commands), "the upload was not recorded");
    };
  std::vector<std::byte> values = runCompute(context_.device(), run);
  uploaded_ = true;
  lichenVulkanReleaseStaging(assets_);
  return values;
}

HostSet::HostSet(VkDevice d, VkDescriptorSetLayout layout, LichenVulkanAssets assets,
                 VkBuffer materialBuffer)
    : device(d) {
  constexpr VkDescriptorPoolSize kSizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2},
                                             {VK_DESCRIPTOR_TYPE_SAMPLER, 2},
                                             {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, LICHEN_SET_IMAGES}};
  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = 3;
  poolInfo.pPoolSizes = kSizes;
  requireVulkan(vkCreateDescriptorPool(device, &poolInfo, nullptr, &pool));
  VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocation.descriptorPool = pool;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &layout;
  requireVulkan(vkAllocateDescriptorSets(device, &allocation, &set));
  VkDescriptorBufferInfo constants{};
  std::array<VkDescriptorImageInfo, LICHEN_SET_IMAGES> images{};
  require(lichenVulkanGetDescriptors(assets, 0, &constants, images.data()), "no descriptors");
  const VkDescriptorBufferInfo material{materialBuffer, 0, LICHEN_MATERIAL_BYTES};
  std::array<VkWriteDescriptorSet, 3> writes{};
  for (VkWriteDescriptorSet& write : writes) {
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  }
  writes[0].dstBinding = LICHEN_BINDING_NOISE;
  writes[0].pBufferInfo = &constants;
  writes[1].dstBinding = LICHEN_BINDING_MATERIAL;
  writes[1].pBufferInfo = &material;
  writes[2].dstBinding = LICHEN_BINDING_IMAGE(0); // images and tables have consecutive bindings
  writes[2].descriptorCount = LICHEN_SET_IMAGES;
  writes[2].descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  writes[2].pImageInfo = images.data();
  vkUpdateDescriptorSets(device, std::uint32_t(writes.size()), writes.data(), 0, nullptr);
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
