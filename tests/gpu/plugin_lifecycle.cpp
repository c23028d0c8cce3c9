// SPDX-License-Identifier: MIT
// The plugin from a host's view: function table and loader, dynamic uniforms, several devices and
// threads, uploads by another queue, hot reload.
#include "plugin_calls.h"
#include "plugin_host.h"
#include "require_device.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <future>
#include <memory>
#include <tiling_maps.comp.h>
#include <tiling_maps.comp.rebound.h>

using namespace lichen;
using namespace lichen::test;

namespace {

using Values = std::vector<std::array<float, 4>>;

/// The values of kThreeMaps, by a shader with bindings from 0.
Values valuesOf(PluginHost& host, std::span<const std::uint32_t> spirv = tiling_maps_comp) {
  return host.evaluate(spirv, 0, host.use(), linePoints(), kThreeMaps.size());
}

const std::vector<std::byte>& threeMaps() {
  static const std::vector<std::byte> glb = syntheticGlb(kThreeMaps);
  return glb;
}

/// What a host draws that leaves everything to the plugin.
const Values& plainValues() {
  static const Values values = [] {
    const auto device = requireDevice();
    PluginHost host(*device, threeMaps());
    return valuesOf(host);
  }();
  return values;
}

} // namespace

TEST_CASE("hosts of every kind draw the same values") {
  const auto device = requireDevice();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  LichenVulkanFunctions functions = loadedFunctions();
  SECTION("the offset of a dynamic uniform buffer") {
    info.flags = LICHEN_VULKAN_DYNAMIC_UNIFORMS;
    PluginHost host(*device, threeMaps(), info);
    CHECK(valuesOf(host) == plainValues());
  }
  SECTION("bindings from 7") {
    info.firstBinding = 7;
    PluginHost host(*device, threeMaps(), info);
    CHECK(valuesOf(host, tiling_maps_comp_rebound) == plainValues());
  }
  SECTION("a function table and the host's own memory") {
    HostMemory memory(*device);
    info.getInstanceProcAddr = nullptr;
    info.instance = VK_NULL_HANDLE;
    info.functions = &functions;
    info.deviceAllocator = &memory.callbacks;
    {
      PluginHost host(*device, threeMaps(), info);
      CHECK(memory.alive == 3); // images, constants and staging
      CHECK(valuesOf(host) == plainValues());
      CHECK(memory.alive == 2); // the staging buffer is released
    }
    CHECK(memory.alive == 0);
  }
  SECTION("images whose sizes are no multiples of their alignment") {
    functions.getImageMemoryRequirements = [](VkDevice d, VkImage image,
                                              VkMemoryRequirements* requirements) {
      vkGetImageMemoryRequirements(d, image, requirements);
      ++requirements->size;
    };
    info.functions = &functions;
    PluginHost host(*device, threeMaps(), info);
    CHECK(valuesOf(host) == plainValues());
  }
  SECTION("images that exceed one allocation") {
    // Two of these images exceed the 1 GiB that every device can allocate at once.
    static std::vector<VkDeviceSize> requested;
    requested.clear();
    functions = Proxy::functions();
    functions.getImageMemoryRequirements = [](VkDevice d, VkImage image,
                                              VkMemoryRequirements* requirements) {
      vkGetImageMemoryRequirements(d, image, requirements);
      requirements->size = VkDeviceSize(600) << 20;
    };
    functions.allocateMemory = [](VkDevice d, const VkMemoryAllocateInfo* allocation,
                                  const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
      requested.push_back(allocation->allocationSize);
      VkMemoryAllocateInfo real = *allocation;
      real.allocationSize = std::min(real.allocationSize, VkDeviceSize(16) << 20);
      return Proxy::create<&vkAllocateMemory>(d, &real, callbacks, memory);
    };
    info.functions = &functions;
    {
      PluginHost host(*device, threeMaps(), info);
      // images, their staging; constants
      CHECK(requested.size() == 2 * (2 * kThreeMaps.size() + 2) + 1);
      CHECK(*std::max_element(requested.begin(), requested.end()) <= VkDeviceSize(1) << 30);
      CHECK(valuesOf(host) == plainValues());
    }
    CHECK(Proxy::alive == 0);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("retired assets live until their last frame has completed") {
  const auto device = requireDevice();
  LichenBundle bundle = parseOrThrow(threeMaps());
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
      lichenVulkanReleaseStaging(assets);
      if (frame == 0)
        perGeneration = Proxy::alive - withoutAssets;
      lichenVulkanRetireAssets(assets, frame);
      if (frame + 1 >= framesInFlight)
        lichenVulkanFrameCompleted(context, frame + 1 - framesInFlight);
      // Of the frames that have not completed: all their assets and no more.
      CHECK(Proxy::alive - withoutAssets == (int(framesInFlight) - 1) * perGeneration);
    }
  REQUIRE(perGeneration > 0);
  lichenVulkanDestroyContext(context); // also destroys the last two generations
  CHECK(Proxy::alive == 0);
  lichenDestroyBundle(bundle);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("two devices in two threads draw one bundle at once, with the same values") {
  const std::shared_ptr<LichenBundle_T> bundle(parseOrThrow(threeMaps()), lichenDestroyBundle);
  const auto first = requireDevice(), second = requireDevice();
  const auto draw = [&](VulkanDevice& device) {
    PluginContext context(device);
    PluginHost host(context, bundle);
    return valuesOf(host);
  };
  auto ofFirst = std::async(std::launch::async, draw, std::ref(*first));
  auto ofSecond = std::async(std::launch::async, draw, std::ref(*second));
  CHECK(ofFirst.get() == plainValues());
  CHECK(ofSecond.get() == plainValues());
  CHECK(first->messages().texts() == std::vector<std::string>{});
  CHECK(second->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("the buffers have the documented sizes") {
  const auto device = requireDevice();
  static std::vector<VkDeviceSize> sizes;
  sizes.clear();
  LichenVulkanFunctions functions = loadedFunctions();
  functions.createBuffer = [](VkDevice d, const VkBufferCreateInfo* info,
                              const VkAllocationCallbacks* callbacks, VkBuffer* buffer) {
    sizes.push_back(info->size);
    return vkCreateBuffer(d, info, callbacks, buffer);
  };
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  const PluginHost host(*device, threeMaps(), info);
  LichenBundleProperties properties;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  REQUIRE(lichenGetBundleProperties(host.bundle(), &properties) == LICHEN_SUCCESS);
  constexpr VkDeviceSize kAlignment = 16; // of each mip level
  VkDeviceSize staging = properties.noiseCount * LICHEN_NOISE_BYTES;
  LichenCopy copy;
  LICHEN_INIT(copy, LICHEN_STRUCTURE_COPY);
  for (std::uint32_t image = 0; image < properties.imageCount; ++image)
    for (std::uint32_t level = 0;
         lichenGetCopy(host.bundle(), image, level, &copy) == LICHEN_SUCCESS; ++level)
      staging += (copy.byteCount + kAlignment - 1) / kAlignment * kAlignment;
  CHECK(sizes == std::vector<VkDeviceSize>{properties.noiseCount * LICHEN_NOISE_BYTES, staging});
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

namespace {

/// Records the barriers of an upload on another queue. The device of the tests has one family, so
/// the proxy drops the release and clears the families of the acquisition, whose source stages then
/// order it after the copies, as they order it after a semaphore. It takes over the release's
/// source access.
struct Transfers {
  static inline std::vector<VkImageMemoryBarrier> images;
  static inline std::vector<VkBufferMemoryBarrier> buffers;
  static inline std::vector<VkPipelineStageFlags> sources, targets;

  static void VKAPI_CALL barrier(VkCommandBuffer commands, VkPipelineStageFlags source,
                                 VkPipelineStageFlags target, VkDependencyFlags flags,
                                 std::uint32_t memoryCount, const VkMemoryBarrier* memory,
                                 std::uint32_t bufferCount, const VkBufferMemoryBarrier* buffer,
                                 std::uint32_t imageCount, const VkImageMemoryBarrier* image) {
    if (image[0].srcQueueFamilyIndex == VK_QUEUE_FAMILY_IGNORED) // before the copies
      return vkCmdPipelineBarrier(commands, source, target, flags, memoryCount, memory, bufferCount,
                                  buffer, imageCount, image);
    images.push_back(image[0]);
    buffers.push_back(buffer[0]);
    sources.push_back(source);
    targets.push_back(target);
    if (buffer[0].dstAccessMask == 0)
      return; // the release
    std::vector<VkImageMemoryBarrier> changed(image, image + imageCount);
    for (VkImageMemoryBarrier& one : changed) {
      one.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
      one.srcQueueFamilyIndex = one.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    }
    VkBufferMemoryBarrier constants = buffer[0];
    constants.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    constants.srcQueueFamilyIndex = constants.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    vkCmdPipelineBarrier(commands, source, target, flags, 0, nullptr, 1, &constants, imageCount,
                         changed.data());
  }
};

} // namespace

TEST_CASE("an upload on a transfer queue releases what the other family acquires") {
  const auto device = requireDevice();
  LichenVulkanFunctions functions = loadedFunctions();
  functions.cmdPipelineBarrier = Transfers::barrier;
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  PluginHost host(*device, threeMaps(), info);
  constexpr std::uint32_t kTransfer = 2, kGraphics = 0;
  // One command buffer for both queues, since validation does not look across submissions.
  const auto submitted = device->submit([&](VkCommandBuffer commands) {
    CHECK(lichenVulkanRecordTransfer(host.assets(), commands, kTransfer, kTransfer) ==
          LICHEN_ERROR_USAGE);
    CHECK(lichenVulkanRecordTransfer(host.assets(), commands, kTransfer, kGraphics) ==
          LICHEN_SUCCESS);
    CHECK(lichenVulkanRecordAcquire(host.assets(), commands, kTransfer, kGraphics) ==
          LICHEN_SUCCESS);
  });
  REQUIRE(submitted.ok());
  REQUIRE(Transfers::images.size() == 2);
  for (const VkImageMemoryBarrier& barrier : Transfers::images) {
    CHECK(barrier.srcQueueFamilyIndex == kTransfer);
    CHECK(barrier.dstQueueFamilyIndex == kGraphics);
    CHECK(barrier.oldLayout == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    CHECK(barrier.newLayout == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  }
  CHECK(Transfers::images[0].srcAccessMask == VK_ACCESS_TRANSFER_WRITE_BIT);
  CHECK(Transfers::images[0].dstAccessMask == 0);
  CHECK(Transfers::images[1].srcAccessMask == 0);
  CHECK(Transfers::images[1].dstAccessMask == VK_ACCESS_SHADER_READ_BIT);
  // A queue that only transfers knows no other stages than these.
  CHECK(Transfers::sources[0] == VK_PIPELINE_STAGE_TRANSFER_BIT);
  CHECK(Transfers::targets[0] == VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
  // The acquisition waits for a semaphore in any stage.
  CHECK(Transfers::sources[1] == VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
  CHECK(Transfers::buffers[0].srcQueueFamilyIndex == kTransfer);
  CHECK(Transfers::buffers[1].dstQueueFamilyIndex == kGraphics);
  host.noteUploaded();
  CHECK(valuesOf(host) == plainValues());
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("synchronization validation reports a missing barrier of the upload") {
  const auto device = requireDevice();
  LichenVulkanFunctions functions = loadedFunctions();
  functions.cmdPipelineBarrier =
      [](VkCommandBuffer commands, VkPipelineStageFlags source, VkPipelineStageFlags,
         VkDependencyFlags flags, std::uint32_t, const VkMemoryBarrier*, std::uint32_t,
         const VkBufferMemoryBarrier*, std::uint32_t count, const VkImageMemoryBarrier* images) {
        vkCmdPipelineBarrier(commands, source, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, flags, 0,
                             nullptr, 0, nullptr, count, images);
      };
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  PluginHost host(*device, threeMaps(), info);
  (void)valuesOf(host);
  const std::vector<std::string> texts = device->messages().texts();
  CHECK(std::ranges::any_of(texts, [](const std::string& text) {
    return text.find("SYNC-HAZARD") != std::string::npos;
  }));
}
