// SPDX-License-Identifier: MIT
// Descriptor sets: bindings from another first one (the shader is compiled with
// LICHEN_FIRST_BINDING 7), sets that the host writes, and hosts without Vulkan's functions for
// sets.
#include "plugin_calls.h"
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <tiling_maps.comp.h>
#include <tiling_maps.comp.rebound.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::array<SyntheticMap, 3> kBoundMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32}}};

std::vector<Point> boundPoints() {
  std::vector<Point> points(200);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{float(k) * 0.013f, float(k) * -0.007f}, {0.02f, 0.0f}, {0.0f, 0.05f}, {}};
  return points;
}

/// A set that the host writes itself, without samplers: those are the layout's.
struct HostSet {
  HostSet(VkDevice d, VkDescriptorSetLayout layout, LichenVulkanAssets assets,
          VkBuffer materialBuffer)
      : device(d) {
    constexpr VkDescriptorPoolSize kSizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2},
        {VK_DESCRIPTOR_TYPE_SAMPLER, 2},
        {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, LICHEN_SET_IMAGES}};
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = 3;
    poolInfo.pPoolSizes = kSizes;
    REQUIRE(vkCreateDescriptorPool(device, &poolInfo, nullptr, &pool) == VK_SUCCESS);
    VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocation.descriptorPool = pool;
    allocation.descriptorSetCount = 1;
    allocation.pSetLayouts = &layout;
    REQUIRE(vkAllocateDescriptorSets(device, &allocation, &set) == VK_SUCCESS);
    VkDescriptorBufferInfo constants{};
    std::array<VkDescriptorImageInfo, LICHEN_SET_IMAGES> images{};
    REQUIRE(lichenVulkanGetDescriptors(assets, 0, &constants, images.data()) == LICHEN_SUCCESS);
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
  HostSet(const HostSet&) = delete;
  HostSet& operator=(const HostSet&) = delete;
  ~HostSet() { vkDestroyDescriptorPool(device, pool, nullptr); }

  VkDevice device;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
};

/// The layout of a host that asks the plugin only what each binding is, and which samplers it has.
VkDescriptorSetLayout hostLayout(VkDevice device, LichenBundle bundle,
                                 LichenVulkanContext context) {
  constexpr std::array<VkDescriptorType, 4> kTypes{
      VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
      VK_DESCRIPTOR_TYPE_SAMPLER, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE}; // by LichenBindingKind
  std::array<VkSampler, 2> samplers{};                               // by LichenSamplerUse
  REQUIRE(lichenVulkanGetSamplers(context, &samplers[0], &samplers[1]) == LICHEN_SUCCESS);
  std::array<VkDescriptorSetLayoutBinding, LICHEN_SET_BINDINGS> bindings{};
  for (std::uint32_t i = 0; i < LICHEN_SET_BINDINGS; ++i) {
    LichenBinding binding;
    LICHEN_INIT(binding, LICHEN_STRUCTURE_BINDING);
    REQUIRE(lichenGetBinding(bundle, 0, i, &binding) == LICHEN_SUCCESS);
    bindings[i] = {binding.binding, kTypes[binding.kind], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    if (binding.kind == LICHEN_BINDING_SAMPLER)
      bindings[i].pImmutableSamplers = &samplers[binding.sampler];
  }
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = LICHEN_SET_BINDINGS;
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  REQUIRE(vkCreateDescriptorSetLayout(device, &info, nullptr, &layout) == VK_SUCCESS);
  return layout;
}

/// As the table of an older header, which ends before the functions for memory and for sets.
LichenVulkanFunctions shortFunctions() {
  LichenVulkanFunctions functions = loadedFunctions();
  functions.size = offsetof(LichenVulkanFunctions, getPhysicalDeviceMemoryProperties);
  return functions;
}

} // namespace

TEST_CASE("bindings may start at another number: the values match the oracle") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kBoundMaps);
  const Bundle bundle = parseBundle(glb, "synthetic").value();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.firstBinding = 7;
  PluginHost host(*device, glb, info);
  const std::vector<Point> points = boundPoints();
  const auto values =
      host.evaluate(tiling_maps_comp_rebound, 0, host.use(), points, kBoundMaps.size());
  for (std::size_t m = 0; m < kBoundMaps.size(); ++m) {
    const TilingReference reference(bundle, m);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto expected = reference.evaluate(points[k], host.material());
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(std::abs(double(values[k * kBoundMaps.size() + m][c]) - expected.value[c]) <
                1.0 / 255.0);
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a set that the host writes itself gives the same values") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kBoundMaps);
  const std::vector<Point> points = boundPoints();
  PluginHost host(*device, glb);
  const auto expected = host.evaluate(tiling_maps_comp, 0, host.use(), points, kBoundMaps.size());

  const HostSet own(device->device(), host.context().layout(), host.assets(),
                    host.materialBuffer());
  host.useSet(own.set);
  CHECK(host.evaluate(tiling_maps_comp, 0, host.use(), points, kBoundMaps.size()) == expected);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a short function table serves a host with its own memory and descriptors") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kBoundMaps);
  const std::vector<Point> points = boundPoints();
  PluginHost plain(*device, glb);
  const MaterialUse use = plain.use();
  const auto expected = plain.evaluate(tiling_maps_comp, 0, use, points, kBoundMaps.size());

  const LichenVulkanFunctions functions = shortFunctions();
  HostMemory memory(*device);
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  info.deviceAllocator = &memory.callbacks;
  LichenVulkanContext context = nullptr;
  REQUIRE(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_SUCCESS);
  LichenVulkanAssets assets = nullptr;
  REQUIRE(lichenVulkanCreateAssets(context, plain.bundle(), &assets, nullptr) == LICHEN_SUCCESS);
  const DeviceBuffer block =
      device->createBuffer(LICHEN_MATERIAL_BYTES, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true).value();
  REQUIRE(lichenFillMaterial(&use.parameters, &use.placement, block.mapped, nullptr) ==
          LICHEN_SUCCESS);
  const VkDescriptorSetLayout layout = hostLayout(device->device(), plain.bundle(), context);
  {
    const HostSet own(device->device(), layout, assets, block.handle);
    ComputeRun run;
    run.spirv = tiling_maps_comp;
    run.layout = layout;
    run.set = own.set;
    run.before = [&](VkCommandBuffer commands) {
      CHECK(lichenVulkanRecordUpload(assets, commands) == LICHEN_SUCCESS);
    };
    CHECK(runCompute<std::array<float, 4>>(*device, run, points, kBoundMaps.size()) == expected);
  }
  vkDestroyDescriptorSetLayout(device->device(), layout, nullptr);
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
  CHECK(memory.alive == 0);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("what a short function table lacks is an error where it is needed") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kBoundMaps));
  LichenVulkanFunctions functions = shortFunctions();
  HostMemory memory(*device);
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  info.deviceAllocator = &memory.callbacks;
  LichenVulkanContext context = nullptr;
  REQUIRE(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_SUCCESS);
  LichenVulkanAssets assets = nullptr;
  REQUIRE(lichenVulkanCreateAssets(context, bundle, &assets, nullptr) == LICHEN_SUCCESS);
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  CHECK(lichenVulkanGetSetLayout(context, &layout) == LICHEN_ERROR_USAGE);
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  VkDescriptorSet set = VK_NULL_HANDLE;
  const auto anyPool = reinterpret_cast<VkDescriptorPool>(&set); // is not used
  const auto anyBuffer = reinterpret_cast<VkBuffer>(&set);
  const VkDescriptorBufferInfo material{anyBuffer, 0, LICHEN_MATERIAL_BYTES};
  CHECK(lichenVulkanAllocateSet(assets, 0, anyPool, &material, &set, &diagnostic) ==
        LICHEN_ERROR_USAGE);
  CHECK(std::string(diagnostic.text) ==
        "the host has given no Vulkan functions for sets; set the four descriptor set functions of "
        "LichenVulkanFunctions");
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
  // Memory is needed without an allocator, and sets are all or nothing.
  info.deviceAllocator = nullptr;
  CHECK(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_ERROR_USAGE);
  functions.size = offsetof(LichenVulkanFunctions, updateDescriptorSets);
  CHECK(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_ERROR_USAGE);
  lichenDestroyBundle(bundle);
  CHECK(memory.alive == 0);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
