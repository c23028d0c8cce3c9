// SPDX-License-Identifier: MIT
// The plugin from a host's view: function table and loader, dynamic uniforms, several maps, several
// devices and threads, uploads by another queue, hot reload.
#include "plugin_calls.h"
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"
#include "tiling_reference.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <memory>
#include <tiling_maps.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::array<SyntheticMap, 3> kMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32}}};

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
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(std::abs(double(values[k * kMaps.size() + m][c]) - expected.value[c]) <
                1.0 / 255.0);
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a cooked bundle gives the values of its glTF file") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<std::byte> cooked = cookBundle(parseBundle(glb, "synthetic").value());
  const std::vector<Point> points = somePoints();
  PluginHost fromGlb(*device, glb);
  PluginHost fromCooked(*device, cooked);
  CHECK(fromCooked.evaluate(tiling_maps_comp, 0, fromCooked.use(), points, kMaps.size()) ==
        fromGlb.evaluate(tiling_maps_comp, 0, fromGlb.use(), points, kMaps.size()));
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
      lichenVulkanReleaseStaging(assets);
      if (frame == 0)
        perGeneration = Proxy::alive - withoutAssets;
      lichenVulkanRetireAssets(assets, frame);
      if (frame + 1 >= framesInFlight)
        lichenVulkanFrameCompleted(context, frame + 1 - framesInFlight);
      // Those of the frames that have not completed, all of them and no more.
      CHECK(Proxy::alive - withoutAssets == (int(framesInFlight) - 1) * perGeneration);
    }
  REQUIRE(perGeneration > 0);
  lichenVulkanDestroyContext(context); // also destroys the last two generations
  CHECK(Proxy::alive == 0);
  lichenDestroyBundle(bundle);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("two devices in two threads draw one bundle at once, with the same values") {
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::shared_ptr<LichenBundle_T> bundle(parseOrThrow(glb), lichenDestroyBundle);
  const std::vector<Point> points = somePoints();
  const auto first = requireDevice(), second = requireDevice();
  const auto draw = [&](VulkanDevice& device) {
    PluginContext context(device);
    PluginHost host(context, bundle);
    return host.evaluate(tiling_maps_comp, 0, host.use(), points, kMaps.size());
  };
  auto ofFirst = std::async(std::launch::async, draw, std::ref(*first));
  auto ofSecond = std::async(std::launch::async, draw, std::ref(*second));
  const auto values = ofFirst.get();
  CHECK(ofSecond.get() == values);
  CHECK(draw(*first) == values); // as by one thread
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
  const PluginHost host(*device, syntheticGlb(kMaps), info);
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
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const std::vector<Point> points = somePoints();
  PluginHost plain(*device, glb);
  const auto expected = plain.evaluate(tiling_maps_comp, 0, plain.use(), points, kMaps.size());
  LichenVulkanFunctions functions = loadedFunctions();
  functions.cmdPipelineBarrier = Transfers::barrier;
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.functions = &functions;
  PluginHost host(*device, glb, info);
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
  CHECK(host.evaluate(tiling_maps_comp, 0, host.use(), points, kMaps.size()) == expected);
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
