// SPDX-License-Identifier: MIT
// Sizes of the machine code that a driver makes of the shaders and of their published peers, beside
// three bare fetches. Draws nothing, so a driver without its device serves as well: Mesa's RADV, as
//   VK_ICD_FILENAMES=/usr/share/vulkan/icd.d/radeon_icd.x86_64.json RADV_FORCE_FAMILY=navi21
#include "rows.h"
#include "screen_pass.h"

#include <lichen/lichen_vulkan.h>

#include <array>
#include <bare.frag.h>
#include <bindless.frag.h>
#include <cstring>
#include <hextile.frag.h>
#include <hextile.frag.unrotated.h>
#include <hn18.frag.h>
#include <local_random_phase.frag.h>
#include <plain.frag.h>
#include <stdexcept>
#include <surface.frag.textons.h>
#include <texton.frag.h>
#include <texton.frag.mixed.h>
#include <tiling.frag.gaussian.h>
#include <tiling.frag.joint.h>
#include <triplanar.frag.h>
#include <unity.frag.h>
#include <vector>
#include <view.vert.h>

namespace lichen::bench {
namespace {

void require(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(vulkanError(what, result).message);
}

/// A device with VK_KHR_pipeline_executable_properties, and a set layout of each kind of shader.
class CompilerDevice {
public:
  CompilerDevice() {
    choosePhysicalDevice();
    createDevice();
    createPeerLayout();
    createBindlessLayout();
    createNoiseLayout();
  }
  CompilerDevice(const CompilerDevice&) = delete;
  CompilerDevice& operator=(const CompilerDevice&) = delete;
  ~CompilerDevice() {
    lichenVulkanDestroyContext(context_);
    vkDestroyDescriptorSetLayout(device_, peerLayout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, bindlessLayout_, nullptr);
    vkDestroyDevice(device_, nullptr);
    vkDestroyInstance(instance_, nullptr);
  }

  [[nodiscard]] const char* name() const { return properties_.deviceName; }
  [[nodiscard]] VkDescriptorSetLayout peerLayout() const { return peerLayout_; }
  [[nodiscard]] VkDescriptorSetLayout noiseLayout() const { return noiseLayout_; }
  [[nodiscard]] VkDescriptorSetLayout bindlessLayout() const { return bindlessLayout_; }

  /// The statistics of a fragment shader: name and value.
  [[nodiscard]] std::vector<Detail> statistics(std::span<const std::uint32_t> fragment,
                                               VkDescriptorSetLayout layout) const {
    const ScreenPipeline pipeline(device_, view_vert, fragment, layout,
                                  VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR);
    VkPipelineInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR};
    info.pipeline = pipeline.handle();
    std::uint32_t count = 0;
    require(getExecutables_(device_, &info, &count, nullptr), "executables");
    std::vector<VkPipelineExecutablePropertiesKHR> executables(
        count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
    require(getExecutables_(device_, &info, &count, executables.data()), "executables");
    for (std::uint32_t i = 0; i < count; ++i)
      if ((executables[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT) != 0)
        return statisticsOf(pipeline.handle(), i);
    throw std::runtime_error("the driver has no statistics of fragment shaders");
  }

private:
  /// The first device. It need not have queues that work, as a VulkanDevice must.
  void choosePhysicalDevice() {
    if (const auto names = VulkanDevice::listDevices(); !names) // loads Vulkan
      throw std::runtime_error(names.error().message);
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    require(vkCreateInstance(&info, nullptr, &instance_), "an instance");
    std::uint32_t count = 1;
    if (vkEnumeratePhysicalDevices(instance_, &count, &physicalDevice_) < 0 || count == 0)
      throw std::runtime_error("no Vulkan device");
    vkGetPhysicalDeviceProperties(physicalDevice_, &properties_);
  }

  void createDevice() {
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR};
    VkPhysicalDeviceFeatures2 features{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &statistics, {}};
    vkGetPhysicalDeviceFeatures2(physicalDevice_, &features);
    if (statistics.pipelineExecutableInfo == VK_FALSE)
      throw std::runtime_error(std::string(name()) +
                               " does not support VK_KHR_pipeline_executable_properties; "
                               "RADV does, without its device: see tests/benchmark/code_rows.cpp");
    VkPhysicalDeviceVulkan12Features indexing{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
                                              &statistics};
    indexing.descriptorIndexing = indexing.runtimeDescriptorArray = VK_TRUE;
    indexing.shaderSampledImageArrayNonUniformIndexing = VK_TRUE;
    VkPhysicalDeviceVulkan13Features core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
                                          &indexing};
    core.dynamicRendering = VK_TRUE;
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &core};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    require(vkCreateDevice(physicalDevice_, &info, nullptr, &device_), "a device");
    const auto load = [&](const char* function) { return vkGetDeviceProcAddr(device_, function); };
    getExecutables_ = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
        load("vkGetPipelineExecutablePropertiesKHR"));
    getStatistics_ = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
        load("vkGetPipelineExecutableStatisticsKHR"));
  }

  /// As shaders/peer_inputs.glsl declares it.
  void createPeerLayout() {
    constexpr std::uint32_t kImages = 5;
    std::array<VkDescriptorSetLayoutBinding, kImages + 1> bindings{};
    for (std::uint32_t i = 0; i <= kImages; ++i)
      bindings[i] = {i,
                     i < kImages ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                 : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                     1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.bindingCount = std::uint32_t(bindings.size());
    info.pBindings = bindings.data();
    require(vkCreateDescriptorSetLayout(device_, &info, nullptr, &peerLayout_), "a set layout");
  }

  /// As shaders/bindless.frag declares it.
  void createBindlessLayout() {
    constexpr std::uint32_t kImages = 64; // of each kind
    const std::array<VkDescriptorType, 6> types{
        VK_DESCRIPTOR_TYPE_SAMPLER,        VK_DESCRIPTOR_TYPE_SAMPLER,
        VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,  VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    std::array<VkDescriptorSetLayoutBinding, types.size()> bindings{};
    for (std::uint32_t i = 0; i < types.size(); ++i)
      bindings[i] = {i, types[i], types[i] == VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE ? kImages : 1,
                     VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.bindingCount = std::uint32_t(bindings.size());
    info.pBindings = bindings.data();
    require(vkCreateDescriptorSetLayout(device_, &info, nullptr, &bindlessLayout_), "a set layout");
  }

  void createNoiseLayout() {
    LichenVulkanInfo info;
    LICHEN_INIT(info, LICHEN_STRUCTURE_VULKAN_INFO);
    info.headerVersion = LICHEN_HEADER_VERSION;
    info.physicalDevice = physicalDevice_;
    info.device = device_;
    info.getInstanceProcAddr = vkGetInstanceProcAddr;
    info.instance = instance_;
    if (lichenVulkanCreateContext(&info, &context_, nullptr) != LICHEN_SUCCESS ||
        lichenVulkanGetSetLayout(context_, &noiseLayout_) != LICHEN_SUCCESS)
      throw std::runtime_error("the plugin has no context on the device");
  }

  [[nodiscard]] std::vector<Detail> statisticsOf(VkPipeline pipeline,
                                                 std::uint32_t executable) const {
    VkPipelineExecutableInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR};
    info.pipeline = pipeline;
    info.executableIndex = executable;
    std::uint32_t count = 0;
    require(getStatistics_(device_, &info, &count, nullptr), "statistics");
    std::vector<VkPipelineExecutableStatisticKHR> all(
        count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
    require(getStatistics_(device_, &info, &count, all.data()), "statistics");
    std::vector<Detail> details;
    for (const VkPipelineExecutableStatisticKHR& one : all)
      if (one.format == VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR)
        details.push_back({one.name, double(one.value.u64)});
    return details;
  }

  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  VkDevice device_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout peerLayout_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout noiseLayout_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout bindlessLayout_ = VK_NULL_HANDLE;
  LichenVulkanContext context_ = nullptr;
  PFN_vkGetPipelineExecutablePropertiesKHR getExecutables_ = nullptr;
  PFN_vkGetPipelineExecutableStatisticsKHR getStatistics_ = nullptr;
};

double valueOf(const std::vector<Detail>& statistics, const char* name) {
  for (const Detail& one : statistics)
    if (one.name == name)
      return one.value;
  throw std::runtime_error("the driver does not state \"" + std::string(name) + "\"");
}

std::vector<Row> measure() {
  struct Shader {
    const char* name;
    std::span<const std::uint32_t> fragment;
    VkDescriptorSetLayout layout;
  };
  const CompilerDevice device;
  const VkDescriptorSetLayout peer = device.peerLayout(), noise = device.noiseLayout();
  const Shader shaders[] = {
      {"three bare fetches", bare_frag, peer}, // the unit
      {"one plain fetch", plain_frag, peer},
      {"hextile-demo", hextile_frag, peer},
      {"hextile-demo without rotation", hextile_frag_unrotated, peer},
      {"Unity's stochastic texturing", unity_frag, peer},
      {"[HN18] without prefilter", hn18_frag, peer},
      {"tiling, joint table", tiling_frag_joint, noise},
      {"tiling, Gaussian only", tiling_frag_gaussian, noise},
      {"triplanar tiling", triplanar_frag, noise},
      {"texton", texton_frag, noise},
      {"mix of textons", texton_frag_mixed, noise},
      {"local random phase", local_random_phase_frag, noise},
      {"surface texton", surface_frag_textons, noise},
      {"four layers of tiling, bindless", bindless_frag, device.bindlessLayout()}};
  // RADV's; cycles are its estimates of a wave alone, and of many waves.
  constexpr std::array kShown{
      "Instructions", "VGPRs", "SGPRs", "Code size", "Branches", "Latency", "Inverse Throughput"};
  std::vector<Row> rows;
  double unit = 0.0;
  for (const Shader& shader : shaders) {
    const std::vector<Detail> statistics = device.statistics(shader.fragment, shader.layout);
    const double instructions = valueOf(statistics, "Instructions");
    if (unit == 0.0)
      unit = instructions;
    Row row{std::string(shader.name) + ", instructions", instructions / unit, kNoTarget, "",
            device.name()};
    for (const char* name : kShown)
      row.details.push_back({name, valueOf(statistics, name)});
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace

std::vector<Row> codeRows() {
  try {
    return measure();
  } catch (const std::exception& problem) {
    return {{"tiling, joint table, instructions", 0.0, kNoTarget, "", problem.what(), true}};
  }
}

} // namespace lichen::bench
