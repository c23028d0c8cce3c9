// SPDX-License-Identifier: MIT
// The plugin as a host meets it: function table and loader, plugin-made sets and the host's own,
// several maps, and every Vulkan call or allocation failing in turn.
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

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

LichenUniformInfo uniformInfo() {
  LichenUniformInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_UNIFORM_INFO);
  return info;
}

/// The functions that a host without volk would load one by one.
LichenVulkanFunctions loadedFunctions() {
  LichenVulkanFunctions f;
  LICHEN_INIT(f, LICHEN_STRUCTURE_VULKAN_FUNCTIONS);
  f.getPhysicalDeviceMemoryProperties = vkGetPhysicalDeviceMemoryProperties;
  f.getPhysicalDeviceFormatProperties = vkGetPhysicalDeviceFormatProperties;
  f.getPhysicalDeviceImageFormatProperties = vkGetPhysicalDeviceImageFormatProperties;
  f.allocateMemory = vkAllocateMemory;
  f.freeMemory = vkFreeMemory;
  f.mapMemory = vkMapMemory;
  f.createBuffer = vkCreateBuffer;
  f.destroyBuffer = vkDestroyBuffer;
  f.getBufferMemoryRequirements = vkGetBufferMemoryRequirements;
  f.bindBufferMemory = vkBindBufferMemory;
  f.createImage = vkCreateImage;
  f.destroyImage = vkDestroyImage;
  f.getImageMemoryRequirements = vkGetImageMemoryRequirements;
  f.bindImageMemory = vkBindImageMemory;
  f.createImageView = vkCreateImageView;
  f.destroyImageView = vkDestroyImageView;
  f.createSampler = vkCreateSampler;
  f.destroySampler = vkDestroySampler;
  f.createDescriptorSetLayout = vkCreateDescriptorSetLayout;
  f.destroyDescriptorSetLayout = vkDestroyDescriptorSetLayout;
  f.allocateDescriptorSets = vkAllocateDescriptorSets;
  f.updateDescriptorSets = vkUpdateDescriptorSets;
  f.cmdPipelineBarrier = vkCmdPipelineBarrier;
  f.cmdCopyBufferToImage = vkCmdCopyBufferToImage;
  return f;
}

/// Counts what a table of functions creates and destroys, and fails the n-th creation.
struct Proxy {
  static inline int untilFailure = 0; ///< counts down while positive
  static inline int alive = 0;

  static bool fails() { return untilFailure > 0 && --untilFailure == 0; }

  /// Wraps a creating function.
  template <auto* kFunction, class... Arguments>
  static VkResult VKAPI_CALL create(Arguments... arguments) {
    if (fails())
      return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    const VkResult result = (*kFunction)(arguments...);
    alive += result == VK_SUCCESS ? 1 : 0;
    return result;
  }
  /// Wraps a destroying function; destroying nothing does not count.
  template <auto* kFunction, class Handle>
  static void VKAPI_CALL destroy(VkDevice device, Handle handle,
                                 const VkAllocationCallbacks* callbacks) {
    (*kFunction)(device, handle, callbacks);
    alive -= handle != VK_NULL_HANDLE ? 1 : 0;
  }
  /// Wraps a function that may fail but creates nothing.
  template <auto* kFunction, class... Arguments>
  static VkResult VKAPI_CALL call(Arguments... arguments) {
    return fails() ? VK_ERROR_OUT_OF_HOST_MEMORY : (*kFunction)(arguments...);
  }
};

LichenVulkanFunctions proxiedFunctions() {
  LichenVulkanFunctions f = loadedFunctions();
  f.allocateMemory = Proxy::create<&vkAllocateMemory>;
  f.freeMemory = Proxy::destroy<&vkFreeMemory>;
  f.mapMemory = Proxy::call<&vkMapMemory>;
  f.createBuffer = Proxy::create<&vkCreateBuffer>;
  f.destroyBuffer = Proxy::destroy<&vkDestroyBuffer>;
  f.bindBufferMemory = Proxy::call<&vkBindBufferMemory>;
  f.createImage = Proxy::create<&vkCreateImage>;
  f.destroyImage = Proxy::destroy<&vkDestroyImage>;
  f.bindImageMemory = Proxy::call<&vkBindImageMemory>;
  f.createImageView = Proxy::create<&vkCreateImageView>;
  f.destroyImageView = Proxy::destroy<&vkDestroyImageView>;
  f.createSampler = Proxy::create<&vkCreateSampler>;
  f.destroySampler = Proxy::destroy<&vkDestroySampler>;
  f.createDescriptorSetLayout = Proxy::create<&vkCreateDescriptorSetLayout>;
  f.destroyDescriptorSetLayout = Proxy::destroy<&vkDestroyDescriptorSetLayout>;
  f.getPhysicalDeviceImageFormatProperties = Proxy::call<&vkGetPhysicalDeviceImageFormatProperties>;
  return f;
}

/// The barrier before the first read, without its second half.
void VKAPI_CALL brokenBarrier(VkCommandBuffer commands, VkPipelineStageFlags source,
                              VkPipelineStageFlags target, VkDependencyFlags flags,
                              std::uint32_t memoryCount, const VkMemoryBarrier* memory,
                              std::uint32_t bufferCount, const VkBufferMemoryBarrier* buffers,
                              std::uint32_t imageCount, const VkImageMemoryBarrier* images) {
  VkImageMemoryBarrier image = images[0];
  if (image.newLayout == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL) {
    image.dstAccessMask = 0;
    target = VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT;
  }
  vkCmdPipelineBarrier(commands, source, target, flags, memoryCount, memory, bufferCount, buffers,
                       imageCount, &image);
}

/// A host's own allocator: one VkDeviceMemory for each request, at an offset.
struct HostMemory {
  explicit HostMemory(HeadlessDevice& d) : device(d) {}

  HeadlessDevice& device;
  int alive = 0;
  int untilFailure = 0;
  LichenDeviceAllocator callbacks{this, allocate, release};

  static VkResult allocate(void* userData, const VkMemoryRequirements* requirements,
                           VkMemoryPropertyFlags properties, LichenDeviceMemory* memory) {
    auto& self = *static_cast<HostMemory*>(userData);
    if (self.untilFailure > 0 && --self.untilFailure == 0)
      return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    VkPhysicalDeviceMemoryProperties types{};
    vkGetPhysicalDeviceMemoryProperties(self.device.physicalDevice(), &types);
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    while ((requirements->memoryTypeBits & (1u << info.memoryTypeIndex)) == 0 ||
           (types.memoryTypes[info.memoryTypeIndex].propertyFlags & properties) != properties)
      ++info.memoryTypeIndex;
    memory->offset = requirements->alignment * 3;
    info.allocationSize = memory->offset + requirements->size;
    const VkResult result = vkAllocateMemory(self.device.device(), &info, nullptr, &memory->memory);
    if (result != VK_SUCCESS)
      return result;
    if (properties & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
      vkMapMemory(self.device.device(), memory->memory, memory->offset, requirements->size, 0,
                  &memory->mapped);
    ++self.alive;
    return VK_SUCCESS;
  }
  static void release(void* userData, const LichenDeviceMemory* memory) {
    auto& self = *static_cast<HostMemory*>(userData);
    vkFreeMemory(self.device.device(), memory->memory, nullptr);
    --self.alive;
  }
};

struct Created {
  LichenResult result = LICHEN_SUCCESS;
  std::string message;
};

/// Creates a context and assets, and destroys them again.
Created createAndDestroy(const LichenVulkanInfo& info, LichenBundle bundle) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  LichenVulkanContext context = nullptr;
  LichenVulkanAssets assets = nullptr;
  LichenResult result = lichenVulkanCreateContext(&info, &context, &diagnostic);
  if (result == LICHEN_SUCCESS)
    result = lichenVulkanCreateAssets(context, bundle, &assets, &diagnostic);
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
  return {result, diagnostic.text};
}

} // namespace

TEST_CASE("several maps share the taps: each is what it is in a noise of its own") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const Bundle bundle = parseBundle(glb, "synthetic").value();
  PluginHost host(*device, glb);
  const std::vector<Point> points = somePoints();
  const auto values = host.evaluate(tiling_maps_comp, 0, uniformInfo(), points, kMaps.size());
  for (std::size_t m = 0; m < kMaps.size(); ++m) {
    const TilingReference reference(bundle, bundle.noises[0].maps[m]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto expected =
          reference.evaluate(points[k], host.uniforms().noise, host.uniforms().maps[m]);
      for (std::size_t c = 0; c < 3; ++c) // the last map has 8 bits: see tiling_parity.cpp
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
  const auto expected = byLoader.evaluate(tiling_maps_comp, 0, uniformInfo(), points, kMaps.size());
  const LichenVulkanFunctions functions = loadedFunctions();
  HostMemory memory(*device);
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.getInstanceProcAddr = nullptr;
  info.instance = VK_NULL_HANDLE;
  info.functions = &functions;
  info.deviceAllocator = &memory.callbacks;
  {
    PluginHost byTable(*device, glb, info);
    CHECK(memory.alive == 2);
    CHECK(byTable.evaluate(tiling_maps_comp, 0, uniformInfo(), points, kMaps.size()) == expected);
    CHECK(memory.alive == 1); // the staging buffer is gone
  }
  CHECK(memory.alive == 0);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a set that the host writes from plain image infos gives the same values") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<Point> points = somePoints();
  PluginHost host(*device, glb);
  const auto expected = host.evaluate(tiling_maps_comp, 0, uniformInfo(), points, kMaps.size());

  std::array<VkDescriptorImageInfo, 2 * kMaps.size()> images{};
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  REQUIRE(lichenVulkanGetImageInfos(host.assets(), 0, images.data()) == LICHEN_SUCCESS);
  REQUIRE(lichenVulkanGetSetLayout(host.assets(), 0, &layout) == LICHEN_SUCCESS);
  const std::array<VkDescriptorPoolSize, 2> sizes{
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
       {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, std::uint32_t(images.size())}}};
  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = std::uint32_t(sizes.size());
  poolInfo.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  REQUIRE(vkCreateDescriptorPool(device->device(), &poolInfo, nullptr, &pool) == VK_SUCCESS);
  VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocation.descriptorPool = pool;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  REQUIRE(vkAllocateDescriptorSets(device->device(), &allocation, &set) == VK_SUCCESS);
  const VkDescriptorBufferInfo buffer{host.uniformBuffer(), 0, LICHEN_UNIFORM_BYTES};
  std::array<VkWriteDescriptorSet, 1 + images.size()> writes{};
  for (std::uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = set;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType =
        i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[i].pBufferInfo = i == 0 ? &buffer : nullptr;
    writes[i].pImageInfo = i == 0 ? nullptr : &images[i - 1];
  }
  vkUpdateDescriptorSets(device->device(), std::uint32_t(writes.size()), writes.data(), 0, nullptr);
  host.useSet(set);
  CHECK(host.evaluate(tiling_maps_comp, 0, uniformInfo(), points, kMaps.size()) == expected);
  vkDestroyDescriptorPool(device->device(), pool, nullptr);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a barrier taken out of the upload is reported by synchronization validation") {
  const auto device = requireDevice();
  LichenVulkanFunctions functions = loadedFunctions();
  functions.cmdPipelineBarrier = brokenBarrier;
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  PluginHost host(*device, syntheticGlb(kMaps), info);
  (void)host.evaluate(tiling_maps_comp, 0, uniformInfo(), somePoints(), kMaps.size());
  REQUIRE(device->messages().errors() > 0);
  CHECK(device->messages().texts().front().find("SYNC-HAZARD") != std::string::npos);
}

TEST_CASE("any Vulkan call that fails gives a code and a message, and leaves nothing behind") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kMaps));
  const LichenVulkanFunctions functions = proxiedFunctions();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  int failures = 0;
  for (int n = 1;; ++n) {
    Proxy::untilFailure = n;
    const Created created = createAndDestroy(info, bundle);
    CHECK(Proxy::alive == 0);
    if (Proxy::untilFailure > 0) { // not reached: everything succeeded
      CHECK(created.result == LICHEN_SUCCESS);
      break;
    }
    ++failures;
    INFO("call " << n << ": " << created.message);
    CHECK((created.result == LICHEN_ERROR_OUT_OF_DEVICE_MEMORY ||
           created.result == LICHEN_ERROR_OUT_OF_HOST_MEMORY));
    CHECK(created.message.find("memory") != std::string::npos);
  }
  Proxy::untilFailure = 0;
  // 2 samplers; format query, image, bind and view for 6 images; 2 blocks, 1 map; buffer and bind;
  // 1 layout.
  CHECK(failures == 2 + 4 * 6 + 2 + 1 + 2 + 1);
  lichenDestroyBundle(bundle);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a host's device allocator that fails gives a code, and gets back what it gave") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kMaps));
  HostMemory memory(*device);
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.deviceAllocator = &memory.callbacks;
  for (const int n : {1, 2}) {
    memory.untilFailure = n;
    CHECK(createAndDestroy(info, bundle).result == LICHEN_ERROR_OUT_OF_DEVICE_MEMORY);
    CHECK(memory.alive == 0);
  }
  memory.untilFailure = 3;
  CHECK(createAndDestroy(info, bundle).result == LICHEN_SUCCESS);
  CHECK(memory.alive == 0);
  lichenDestroyBundle(bundle);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a host that hands in too little is told what is missing") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kMaps));
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.device = VK_NULL_HANDLE;
  CHECK(createAndDestroy(info, bundle).message.find("device") != std::string::npos);
  info = defaultVulkanInfo(*device);
  info.getInstanceProcAddr = nullptr;
  CHECK(createAndDestroy(info, bundle).message.find("getInstanceProcAddr") != std::string::npos);
  LichenVulkanFunctions functions = loadedFunctions();
  functions.createImage = nullptr;
  info = defaultVulkanInfo(*device);
  info.functions = &functions;
  CHECK(createAndDestroy(info, bundle).result == LICHEN_ERROR_USAGE);
  lichenDestroyBundle(bundle);
}
