// SPDX-License-Identifier: MIT
// The plugin from a host's view: function table and loader, sets from the plugin and from the host,
// dynamic uniforms, several maps, hot reload.
#include "plugin_calls.h"
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tiling_maps.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::array<SyntheticMap, 3> kMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32, true}}};

std::vector<Point> somePoints() {
  std::vector<Point> points(500);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{float(k) * 0.013f, float(k) * -0.007f}, {0.02f, 0.0f}, {0.0f, 0.05f}, {}};
  return points;
}

/// The barriers before the first read, without their destination scope.
void VKAPI_CALL brokenBarrier(VkCommandBuffer commands, VkPipelineStageFlags source,
                              VkPipelineStageFlags target, VkDependencyFlags flags,
                              std::uint32_t memoryCount, const VkMemoryBarrier* memory,
                              std::uint32_t bufferCount, const VkBufferMemoryBarrier* buffers,
                              std::uint32_t imageCount, const VkImageMemoryBarrier* images) {
  std::vector<VkImageMemoryBarrier> changed(images, images + imageCount);
  if (images[0].newLayout == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL) {
    for (VkImageMemoryBarrier& image : changed)
      image.dstAccessMask = 0;
    target = VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT;
    bufferCount = 0;
  }
  vkCmdPipelineBarrier(commands, source, target, flags, memoryCount, memory, bufferCount, buffers,
                       imageCount, changed.data());
}

} // namespace

TEST_CASE("several maps share the taps: each has the values of a noise with that map alone") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const Bundle bundle = parseBundle(glb, "synthetic").value();
  PluginHost host(*device, glb);
  const std::vector<Point> points = somePoints();
  const auto values = host.evaluate(tiling_maps_comp, 0, host.use(), points, kMaps.size());
  for (std::size_t m = 0; m < kMaps.size(); ++m) {
    const TilingReference reference(bundle, m);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto expected = reference.evaluate(points[k], host.material());
      for (std::size_t c = 0; c < 3; ++c) // the last map has 8 bits; see tiling_parity.cpp
        REQUIRE(std::abs(double(values[k * kMaps.size() + m][c]) - expected.value[c]) <
                (kMaps[m].eightBit ? 0.04 : 1.0 / 255.0));
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("the loader, a function table and the host's own memory give the same values") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<Point> points = somePoints();
  PluginHost byLoader(*device, glb);
  const auto expected =
      byLoader.evaluate(tiling_maps_comp, 0, byLoader.use(), points, kMaps.size());
  const LichenVulkanFunctions functions = loadedFunctions();
  HostMemory memory(*device);
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.getInstanceProcAddr = nullptr;
  info.instance = VK_NULL_HANDLE;
  info.functions = &functions;
  info.deviceAllocator = &memory.callbacks;
  {
    PluginHost byTable(*device, glb, info);
    CHECK(memory.alive == 3); // images, constants and staging
    CHECK(byTable.evaluate(tiling_maps_comp, 0, byTable.use(), points, kMaps.size()) == expected);
    CHECK(memory.alive == 2); // the staging buffer is released
  }
  CHECK(memory.alive == 0);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("images that exceed one allocation use several, with the same values") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<Point> points = somePoints();
  PluginHost plain(*device, glb);
  const auto expected = plain.evaluate(tiling_maps_comp, 0, plain.use(), points, kMaps.size());

  // Two of these images exceed the 1 GiB that every device can allocate at once.
  static std::vector<VkDeviceSize> requested;
  requested.clear();
  LichenVulkanFunctions functions = Proxy::functions();
  functions.getImageMemoryRequirements = [](VkDevice d, VkImage image,
                                            VkMemoryRequirements* requirements) {
    vkGetImageMemoryRequirements(d, image, requirements);
    requirements->size = VkDeviceSize(600) << 20;
  };
  functions.allocateMemory = [](VkDevice d, const VkMemoryAllocateInfo* info,
                                const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
    requested.push_back(info->allocationSize);
    VkMemoryAllocateInfo real = *info;
    real.allocationSize = std::min(real.allocationSize, VkDeviceSize(16) << 20);
    return Proxy::create<&vkAllocateMemory>(d, &real, callbacks, memory);
  };
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  {
    PluginHost spread(*device, glb, info);
    CHECK(requested.size() == 2 * (2 * kMaps.size() + 2) + 1); // images, their staging; constants
    CHECK(*std::max_element(requested.begin(), requested.end()) <= VkDeviceSize(1) << 30);
    CHECK(spread.evaluate(tiling_maps_comp, 0, spread.use(), points, kMaps.size()) == expected);
  }
  CHECK(Proxy::alive == 0);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a set that the host writes itself gives the same values") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<Point> points = somePoints();
  PluginHost host(*device, glb);
  const auto expected = host.evaluate(tiling_maps_comp, 0, host.use(), points, kMaps.size());

  const VkDescriptorSetLayout layout = host.context().layout();
  const VkDescriptorPool pool = host.context().createPool(1);
  VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocation.descriptorPool = pool;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  REQUIRE(vkAllocateDescriptorSets(device->device(), &allocation, &set) == VK_SUCCESS);
  VkDescriptorBufferInfo constants{};
  std::array<VkDescriptorImageInfo, LICHEN_SET_IMAGES> images{};
  REQUIRE(lichenVulkanGetDescriptors(host.assets(), 0, &constants, images.data()) ==
          LICHEN_SUCCESS);
  const VkDescriptorBufferInfo material{host.materialBuffer(), 0, LICHEN_MATERIAL_BYTES};
  // The samplers are the layout's. Images and tables have the bindings behind them.
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
  writes[2].dstBinding = LICHEN_BINDING_IMAGE(0);
  writes[2].descriptorCount = LICHEN_SET_IMAGES;
  writes[2].descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  writes[2].pImageInfo = images.data();
  vkUpdateDescriptorSets(device->device(), std::uint32_t(writes.size()), writes.data(), 0, nullptr);
  host.useSet(set);
  CHECK(host.evaluate(tiling_maps_comp, 0, host.use(), points, kMaps.size()) == expected);
  vkDestroyDescriptorPool(device->device(), pool, nullptr);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a dynamic uniform buffer's offset selects the uniforms") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<Point> points = somePoints();
  PluginHost plain(*device, glb);
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.flags = LICHEN_VULKAN_DYNAMIC_UNIFORMS;
  PluginHost dynamic(*device, glb, info);
  CHECK(dynamic.evaluate(tiling_maps_comp, 0, dynamic.use(), points, kMaps.size()) ==
        plain.evaluate(tiling_maps_comp, 0, plain.use(), points, kMaps.size()));
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("retired assets live until their last frame has completed") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kMaps));
  const LichenVulkanFunctions functions = Proxy::functions();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  LichenVulkanContext context = nullptr;
  REQUIRE(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_SUCCESS);
  const int withoutAssets = Proxy::alive;
  int perGeneration = 0;
  std::uint64_t frame = 0;
  for (const std::uint64_t framesInFlight : {1u, 2u, 3u})
    for (int reload = 0; reload < 20; ++reload, ++frame) { // each bundle is used in one frame
      LichenVulkanAssets assets = nullptr;
      REQUIRE(lichenVulkanCreateAssets(context, bundle, &assets, nullptr) == LICHEN_SUCCESS);
      if (frame == 0)
        perGeneration = Proxy::alive - withoutAssets;
      lichenVulkanReleaseStaging(assets);
      lichenVulkanRetireAssets(assets, frame);
      if (frame + 1 >= framesInFlight)
        lichenVulkanFrameCompleted(context, frame + 1 - framesInFlight);
      const int most = int(framesInFlight) * perGeneration;
      CHECK(Proxy::alive - withoutAssets < most);
      CHECK((Proxy::alive > withoutAssets) == (framesInFlight > 1));
    }
  lichenVulkanDestroyContext(context); // also destroys the last two generations
  CHECK(Proxy::alive == 0);
  lichenDestroyBundle(bundle);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("synchronization validation reports a missing barrier of the upload") {
  const auto device = requireDevice();
  LichenVulkanFunctions functions = loadedFunctions();
  functions.cmdPipelineBarrier = brokenBarrier;
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  PluginHost host(*device, syntheticGlb(kMaps), info);
  (void)host.evaluate(tiling_maps_comp, 0, host.use(), somePoints(), kMaps.size());
  REQUIRE(device->messages().errors() > 0);
  CHECK(device->messages().texts().front().find("SYNC-HAZARD") != std::string::npos);
}
