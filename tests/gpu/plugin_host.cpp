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

DescriptorPool PluginContext::createPool(std::uint32_t sets) const {
  const std::array<VkDescriptorPoolSize, 4> sizes{
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, isDynamic_ ? sets : 2 * sets},
       {VK_DESCRIPTOR_TYPE_SAMPLER, 2 * sets},
       {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, LICHEN_LAYERED_SET_IMAGES * sets},
       {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, sets}}};
  return {device_.device(), sets, std::span(sizes).first(isDynamic_ ? 4 : 3)};
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
  vkResetDescriptorPool(context_.device().device(), pool_.handle(), 0);
  LichenDiagnostic diagnostic = emptyDiagnostic();
  const VkDescriptorBufferInfo buffer{materialBuffer_.handle, 0, LICHEN_LAYERED_MATERIAL_BYTES};
  require(lichenVulkanAllocateSet(assets_, noise, pool_.handle(), &buffer, &set_, &diagnostic),
          diagnostic);
}

PluginHost::~PluginHost() { lichenVulkanDestroyAssets(assets_); }

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
