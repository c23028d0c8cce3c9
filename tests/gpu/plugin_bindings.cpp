// SPDX-License-Identifier: MIT
// Hosts without Vulkan's functions for sets.
#include "plugin_calls.h"
#include "plugin_host.h"
#include "require_device.h"

#include <catch2/catch.hpp>

#include <array>
#include <tiling_maps.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

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

/// A set that the host writes itself, without samplers: those are the layout's.
VkDescriptorSet hostSet(VkDevice device, const DescriptorPool& pool, VkDescriptorSetLayout layout,
                        LichenVulkanAssets assets, VkBuffer materialBuffer) {
  VkDescriptorBufferInfo constants{};
  std::array<VkDescriptorImageInfo, LICHEN_SET_IMAGES> images{};
  REQUIRE(lichenVulkanGetDescriptors(assets, 0, &constants, images.data()) == LICHEN_SUCCESS);
  const VkDescriptorBufferInfo material{materialBuffer, 0, LICHEN_MATERIAL_BYTES};
  const VkDescriptorSet set = pool.allocate(layout);
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
  return set;
}

/// As the table of an older header, which ends before the functions for memory and for sets.
LichenVulkanFunctions shortFunctions() {
  LichenVulkanFunctions functions = loadedFunctions();
  functions.size = offsetof(LichenVulkanFunctions, getPhysicalDeviceMemoryProperties);
  return functions;
}

} // namespace

TEST_CASE("a short function table serves a host with its own memory and descriptors") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kThreeMaps);
  const std::vector<Point> points = linePoints();
  PluginHost plain(*device, glb);
  const MaterialUse use = plain.use();
  const auto expected = plain.evaluate(tiling_maps_comp, 0, use, points, kThreeMaps.size());

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
    const DescriptorPool pool(device->device(), 1, kSetSizes);
    ComputeRun run;
    run.spirv = tiling_maps_comp;
    run.layout = layout;
    run.set = hostSet(device->device(), pool, layout, assets, block.handle);
    run.before = [&](VkCommandBuffer commands) {
      CHECK(lichenVulkanRecordUpload(assets, commands) == LICHEN_SUCCESS);
    };
    CHECK(runCompute<std::array<float, 4>>(*device, run, points, kThreeMaps.size()) == expected);
  }
  vkDestroyDescriptorSetLayout(device->device(), layout, nullptr);
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
  CHECK(memory.alive == 0);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("what a short function table lacks is an error where it is needed") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kThreeMaps));
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
