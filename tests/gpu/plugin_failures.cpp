// SPDX-License-Identifier: MIT
// Failures around the plugin: every Vulkan call and host allocation fails in turn, devices lack
// features, and hosts pass incomplete structs. Each gives a result code and a message, and leaks
// nothing.
#include "exhausted_memory.h"
#include "plugin_calls.h"
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::array<SyntheticMap, 3> kMaps{
    {{3, 32, 32, true}, {2, 16, 16, true}, {1, 32, 32, true}}};

/// A device and a bundle, with a pool and a buffer for one set. Checks that the validation layers
/// say nothing.
struct Fixture {
  Fixture() = default;
  Fixture(const Fixture&) = delete;
  Fixture& operator=(const Fixture&) = delete;
  ~Fixture() {
    lichenDestroyBundle(bundle);
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }

  std::unique_ptr<VulkanDevice> device = requireDevice();
  LichenBundle bundle = parseOrThrow(syntheticGlb(kMaps));
  DescriptorPool sets{device->device(), 1, kSetSizes};
  VkDescriptorPool pool = sets.handle();
  DeviceBuffer buffer =
      device->createBuffer(LICHEN_MATERIAL_BYTES, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true).value();
  VkDescriptorBufferInfo material{buffer.handle, 0, LICHEN_MATERIAL_BYTES};
};

struct Created {
  LichenResult result = LICHEN_SUCCESS;
  std::string message;
};

/// Creates a context, assets and a set, and destroys whatever exists.
Created createAndDestroy(const Fixture& fixture, const LichenVulkanInfo& info) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  LichenVulkanContext context = nullptr;
  LichenVulkanAssets assets = nullptr;
  VkDescriptorSet set = VK_NULL_HANDLE;
  LichenResult result = lichenVulkanCreateContext(&info, &context, &diagnostic);
  CHECK((context != nullptr) == (result == LICHEN_SUCCESS));
  if (result == LICHEN_SUCCESS) {
    result = lichenVulkanCreateAssets(context, fixture.bundle, &assets, &diagnostic);
    CHECK((assets != nullptr) == (result == LICHEN_SUCCESS));
  }
  if (result == LICHEN_SUCCESS) {
    result = lichenVulkanAllocateSet(assets, 0, fixture.pool, &fixture.material, &set, &diagnostic);
    CHECK((set != VK_NULL_HANDLE) == (result == LICHEN_SUCCESS));
  }
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
  vkResetDescriptorPool(fixture.device->device(), fixture.pool, 0);
  return {result, diagnostic.text};
}

Created createWith(const Fixture& fixture, const LichenVulkanFunctions& functions) {
  LichenVulkanInfo info = defaultVulkanInfo(*fixture.device);
  info.functions = &functions;
  return createAndDestroy(fixture, info);
}

/// Functions of a device with two ordinary memory types, 4 and 5, after several types for special
/// uses.
struct ManyMemoryTypes {
  static constexpr std::array<VkMemoryPropertyFlags, 4> kSpecial{
      VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD,
      VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD | VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD,
      VK_MEMORY_PROPERTY_PROTECTED_BIT, VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT};
  static inline std::vector<std::uint32_t> requested; ///< memory types of the allocations, in order
  static inline std::uint32_t full = 0;               ///< a type without free memory
  static inline std::uint32_t unmappable = 0;         ///< a type that cannot be mapped

  static void VKAPI_CALL properties(VkPhysicalDevice device,
                                    VkPhysicalDeviceMemoryProperties* target) {
    vkGetPhysicalDeviceMemoryProperties(device, target);
    target->memoryTypeCount = std::uint32_t(kSpecial.size()) + 2;
    for (std::uint32_t type = 0; type < target->memoryTypeCount; ++type)
      target->memoryTypes[type] = {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT |
                                       VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                       VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                                   0};
    for (std::size_t type = 0; type < kSpecial.size(); ++type)
      target->memoryTypes[type].propertyFlags |= kSpecial[type];
  }
  template <auto* kFunction, class Handle>
  static void VKAPI_CALL anyType(VkDevice device, Handle handle,
                                 VkMemoryRequirements* requirements) {
    (*kFunction)(device, handle, requirements);
    requirements->memoryTypeBits = ~0u;
  }
  static VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                      const VkAllocationCallbacks* callbacks,
                                      VkDeviceMemory* memory) {
    requested.push_back(info->memoryTypeIndex);
    if (info->memoryTypeIndex == full)
      return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    VkMemoryAllocateInfo real = *info;
    real.memoryTypeIndex = 0; // the device's real first type
    return Proxy::create<&vkAllocateMemory>(device, &real, callbacks, memory);
  }
  static VkResult VKAPI_CALL map(VkDevice device, VkDeviceMemory memory, VkDeviceSize offset,
                                 VkDeviceSize size, VkMemoryMapFlags flags, void** data) {
    if (requested.back() != unmappable)
      return vkMapMemory(device, memory, offset, size, flags, data);
    Proxy::fillWithGarbage(data);
    return VK_ERROR_MEMORY_MAP_FAILED;
  }
  static LichenVulkanFunctions functions() {
    LichenVulkanFunctions f = loadedFunctions();
    f.getPhysicalDeviceMemoryProperties = properties;
    f.getImageMemoryRequirements = anyType<&vkGetImageMemoryRequirements>;
    f.getBufferMemoryRequirements = anyType<&vkGetBufferMemoryRequirements>;
    f.allocateMemory = allocate;
    f.freeMemory = Proxy::destroy<&vkFreeMemory>;
    f.mapMemory = map;
    requested.clear();
    full = unmappable = VK_MAX_MEMORY_TYPES; // none
    return f;
  }
};

} // namespace

TEST_CASE("any failing Vulkan call gives a code and a message, and leaks nothing") {
  const Fixture fixture;
  const LichenVulkanFunctions functions = Proxy::functions();
  int failures = 0, ofPool = 0;
  for (int n = 1;; ++n) {
    Proxy::untilFailure = n;
    Proxy::exhausted = false;
    const Created created = createWith(fixture, functions);
    CHECK(Proxy::alive == 0);
    CHECK(Proxy::garbageDestroyed == 0);
    if (Proxy::untilFailure > 0) { // not reached, because everything succeeded
      CHECK(created.result == LICHEN_SUCCESS);
      break;
    }
    ++failures;
    INFO("call " << n << ": " << created.message);
    if (created.result == LICHEN_ERROR_OUT_OF_POOL_MEMORY) {
      ++ofPool;
      CHECK(created.message ==
            "allocating a descriptor set: the descriptor pool is too small: a set takes 2 uniform "
            "buffers, 2 samplers and 13 sampled images, with LICHEN_VULKAN_LAYERS 15");
    }
    CHECK((created.result == LICHEN_ERROR_OUT_OF_DEVICE_MEMORY ||
           created.result == LICHEN_ERROR_OUT_OF_HOST_MEMORY ||
           created.result == LICHEN_ERROR_OUT_OF_POOL_MEMORY));
    CHECK((created.message.find("memory") != std::string::npos ||
           created.message.find("pool is too small") != std::string::npos));
  }
  Proxy::untilFailure = 0;
  Proxy::exhausted = false;
  // 2 samplers; 1 layout; format query, image, bind and view for 6 images and 2 placeholders; 3
  // blocks, 1 map; buffer and bind of the constants and of staging; 1 set.
  CHECK(failures == 2 + 1 + 4 * 8 + 3 + 1 + 2 * 2 + 1);
  CHECK(ofPool == 1);
}

TEST_CASE("any failing host allocation in the plugin gives a code and leaks nothing") {
  const Fixture fixture;
  const LichenVulkanFunctions functions = Proxy::functions();
  LichenVulkanInfo info = defaultVulkanInfo(*fixture.device);
  info.functions = &functions;
  Proxy::enter = ExhaustedMemory::spare; // the layers allocate as well, and must not throw
  Proxy::leave = ExhaustedMemory::refuse;
  int failures = 0;
  for (int n = 1;; ++n) {
    LichenVulkanContext context = nullptr;
    LichenVulkanAssets assets = nullptr;
    VkDescriptorSet set = VK_NULL_HANDLE;
    LichenResult result = LICHEN_SUCCESS;
    bool reached = false;
    {
      const ExhaustedMemory memory(n);
      result = lichenVulkanCreateContext(&info, &context, nullptr);
      if (result == LICHEN_SUCCESS)
        result = lichenVulkanCreateAssets(context, fixture.bundle, &assets, nullptr);
      if (result == LICHEN_SUCCESS)
        result = lichenVulkanAllocateSet(assets, 0, fixture.pool, &fixture.material, &set, nullptr);
      reached = memory.reached();
    }
    lichenVulkanDestroyAssets(assets);
    lichenVulkanDestroyContext(context);
    vkResetDescriptorPool(fixture.device->device(), fixture.pool, 0);
    INFO("allocation " << n);
    CHECK(Proxy::alive == 0);
    CHECK(result == (reached ? LICHEN_ERROR_OUT_OF_HOST_MEMORY : LICHEN_SUCCESS));
    if (!reached)
      break;
    ++failures;
  }
  Proxy::enter = Proxy::leave = [] {};
  CHECK(failures > 10);
}

TEST_CASE("a failing host allocation while recording leaves the command buffer unchanged") {
  const Fixture fixture;
  static int commands;
  LichenVulkanFunctions functions = loadedFunctions();
  functions.cmdPipelineBarrier = [](auto...) { ++commands; };
  functions.cmdCopyBufferToImage = [](auto...) { ++commands; };
  functions.cmdCopyBuffer = [](auto...) { ++commands; };
  LichenVulkanInfo info = defaultVulkanInfo(*fixture.device);
  info.functions = &functions;
  LichenVulkanContext context = nullptr;
  LichenVulkanAssets assets = nullptr;
  REQUIRE(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_SUCCESS);
  REQUIRE(lichenVulkanCreateAssets(context, fixture.bundle, &assets, nullptr) == LICHEN_SUCCESS);
  const auto anyBuffer = reinterpret_cast<VkCommandBuffer>(&commands); // is not used
  const auto failEachAllocation = [&](const auto& record) {
    for (int n = 1;; ++n) {
      commands = 0;
      LichenResult result = LICHEN_SUCCESS;
      bool reached = false;
      {
        const ExhaustedMemory memory(n, 0, Failing::nth);
        result = record();
        reached = memory.reached();
      }
      INFO("allocation " << n);
      CHECK(result == (reached ? LICHEN_ERROR_OUT_OF_HOST_MEMORY : LICHEN_SUCCESS));
      CHECK((commands == 0) == reached);
      if (!reached)
        return;
    }
  };
  failEachAllocation([&] { return lichenVulkanRecordUpload(assets, anyBuffer); });
  failEachAllocation([&] { return lichenVulkanRecordTransfer(assets, anyBuffer, 2, 0); });
  lichenVulkanReleaseStaging(assets); // an acquisition needs none
  failEachAllocation([&] { return lichenVulkanRecordAcquire(assets, anyBuffer, 2, 0); });
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
}

TEST_CASE("a device that allows no more allocations is out of device memory") {
  const Fixture fixture;
  LichenVulkanFunctions functions = Proxy::functions();
  functions.allocateMemory = [](VkDevice, const VkMemoryAllocateInfo*, const VkAllocationCallbacks*,
                                VkDeviceMemory*) { return VK_ERROR_TOO_MANY_OBJECTS; };
  const Created created = createWith(fixture, functions);
  CHECK(created.result == LICHEN_ERROR_OUT_OF_DEVICE_MEMORY);
  CHECK(created.message ==
        "memory for the images: more objects than the device allows; destroy some, or set a "
        "deviceAllocator that takes memory from larger blocks");
  CHECK(Proxy::alive == 0);
}

TEST_CASE("a failing host allocator gives a code and gets its memory back") {
  const Fixture fixture;
  HostMemory memory(*fixture.device);
  LichenVulkanInfo info = defaultVulkanInfo(*fixture.device);
  info.deviceAllocator = &memory.callbacks;
  for (const int n : {1, 2, 3}) {
    memory.untilFailure = n;
    CHECK(createAndDestroy(fixture, info).result == LICHEN_ERROR_OUT_OF_DEVICE_MEMORY);
    CHECK(memory.alive == 0);
  }
  memory.untilFailure = 4;
  CHECK(createAndDestroy(fixture, info).result == LICHEN_SUCCESS);
  CHECK(memory.alive == 0);
}

TEST_CASE("exceptions of a host allocator do not leave the plugin") {
  const Fixture fixture;
  const LichenVulkanFunctions functions = Proxy::functions();
  HostMemory memory(*fixture.device);
  static decltype(LichenDeviceAllocator::release) release;
  release = memory.callbacks.release;
  LichenVulkanInfo info = defaultVulkanInfo(*fixture.device);
  info.functions = &functions;
  info.deviceAllocator = &memory.callbacks;
  SECTION("release") {
    memory.callbacks.release = [](void* userData, const LichenDeviceMemory* piece) {
      release(userData, piece);
      throw std::runtime_error("release");
    };
    CHECK(createAndDestroy(fixture, info).result == LICHEN_SUCCESS);
  }
  SECTION("allocate") {
    memory.callbacks.allocate = [](void*, const LichenMemoryRequest*,
                                   LichenDeviceMemory*) -> VkResult {
      throw std::runtime_error("allocate");
    };
    CHECK(createAndDestroy(fixture, info).result == LICHEN_ERROR_INTERNAL);
  }
  CHECK(memory.alive == 0);
  CHECK(Proxy::alive == 0);
}

TEST_CASE("the error for a device that cannot filter a table's format or size names the table") {
  const Fixture fixture;
  LichenVulkanFunctions functions = loadedFunctions();
  SECTION("no linear filter for the inverse table of slopes") {
    functions.getPhysicalDeviceFormatProperties = [](VkPhysicalDevice device, VkFormat format,
                                                     VkFormatProperties* properties) {
      vkGetPhysicalDeviceFormatProperties(device, format, properties);
      if (format == VK_FORMAT_R16G16B16A16_SFLOAT)
        properties->optimalTilingFeatures &=
            ~VkFormatFeatureFlags(VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT);
    };
    const Created created = createWith(fixture, functions);
    CHECK(created.result == LICHEN_ERROR_UNSUPPORTED);
    CHECK(created.message.find("VkFormat 97 and 64 x 64 x 1") != std::string::npos);
  }
  SECTION("no image of the format") {
    functions.getPhysicalDeviceImageFormatProperties =
        [](VkPhysicalDevice, VkFormat, VkImageType, VkImageTiling, VkImageUsageFlags,
           VkImageCreateFlags, VkImageFormatProperties*) { return VK_ERROR_FORMAT_NOT_SUPPORTED; };
    CHECK(createWith(fixture, functions).result == LICHEN_ERROR_UNSUPPORTED);
  }
  SECTION("3-D images that are not deep enough") {
    functions.getPhysicalDeviceImageFormatProperties =
        [](VkPhysicalDevice device, VkFormat format, VkImageType type, VkImageTiling tiling,
           VkImageUsageFlags usage, VkImageCreateFlags flags, VkImageFormatProperties* properties) {
          const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
              device, format, type, tiling, usage, flags, properties);
          properties->maxExtent.depth = 16;
          return result;
        };
    const Created created = createWith(fixture, functions);
    CHECK(created.result == LICHEN_ERROR_UNSUPPORTED);
    CHECK(created.message.find("32 x 32 x 32") != std::string::npos);
  }
  SECTION("Vulkan 1.0, which reports no transfer features, works") {
    functions.getPhysicalDeviceFormatProperties = [](VkPhysicalDevice device, VkFormat format,
                                                     VkFormatProperties* properties) {
      vkGetPhysicalDeviceFormatProperties(device, format, properties);
      properties->optimalTilingFeatures &= ~VkFormatFeatureFlags(
          VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT);
    };
    CHECK(createWith(fixture, functions).result == LICHEN_SUCCESS);
  }
}

TEST_CASE(
    "the plugin allocates ordinary memory only, of the next type if a heap is full or cannot be "
    "mapped") {
  using Types = std::vector<std::uint32_t>;
  const Fixture fixture;
  LichenVulkanFunctions functions = ManyMemoryTypes::functions();
  SECTION("ordinary") {
    CHECK(createWith(fixture, functions).result == LICHEN_SUCCESS);
    CHECK(ManyMemoryTypes::requested == Types{4, 4, 4});
  }
  SECTION("no ordinary type") {
    functions.getPhysicalDeviceMemoryProperties = [](VkPhysicalDevice device,
                                                     VkPhysicalDeviceMemoryProperties* target) {
      ManyMemoryTypes::properties(device, target);
      target->memoryTypeCount = std::uint32_t(ManyMemoryTypes::kSpecial.size());
    };
    const Created created = createWith(fixture, functions);
    CHECK(created.result == LICHEN_ERROR_UNSUPPORTED);
    CHECK(created.message.find("no ordinary memory type") != std::string::npos);
    CHECK(ManyMemoryTypes::requested.empty());
  }
  SECTION("full") {
    ManyMemoryTypes::full = 4;
    CHECK(createWith(fixture, functions).result == LICHEN_SUCCESS);
    CHECK(ManyMemoryTypes::requested == Types{4, 5, 4, 5, 4, 5});
  }
  SECTION("cannot be mapped") {
    ManyMemoryTypes::unmappable = 4;
    CHECK(createWith(fixture, functions).result == LICHEN_SUCCESS);
    CHECK(ManyMemoryTypes::requested == Types{4, 4, 4, 5});
  }
  SECTION("if all types fail, the first type's error is returned") {
    ManyMemoryTypes::unmappable = 4;
    ManyMemoryTypes::full = 5;
    const Created created = createWith(fixture, functions);
    CHECK(created.message.find("cannot map it") != std::string::npos);
    CHECK(ManyMemoryTypes::requested == Types{4, 4, 4, 5});
  }
  CHECK(Proxy::alive == 0);
}

TEST_CASE("incomplete or unknown host input gives an error that names it") {
  const Fixture fixture;
  const LichenVulkanInfo good = defaultVulkanInfo(*fixture.device);
  LichenVulkanFunctions noImages = loadedFunctions(), older = loadedFunctions();
  noImages.createImage = nullptr;
  older.size = offsetof(LichenVulkanFunctions, cmdPipelineBarrier); // an older header's table
  HostMemory noRelease(*fixture.device), otherType(*fixture.device);
  noRelease.callbacks.release = nullptr;
  otherType.callbacks.type = LICHEN_STRUCTURE_DIAGNOSTIC;
  constexpr LichenResult kUsage = LICHEN_ERROR_USAGE, kVersion = LICHEN_ERROR_VERSION;
  struct Wrong {
    std::function<void(LichenVulkanInfo&)> change;
    LichenResult result;
    const char* word;
  };
  const Wrong rows[] = {
      {[](auto& info) { info.device = VK_NULL_HANDLE; }, kUsage, "device"},
      {[](auto& info) { info.getInstanceProcAddr = nullptr; }, kUsage, "getInstanceProcAddr"},
      {[&](auto& info) { info.functions = &noImages; }, kUsage, "functions"},
      {[&](auto& info) { info.functions = &older; }, kUsage, "functions"},
      {[&](auto& info) { info.deviceAllocator = &noRelease.callbacks; }, kUsage, "release"},
      {[&](auto& info) { info.deviceAllocator = &otherType.callbacks; }, kUsage, "type"},
      {[](auto& info) { info.flags = 4; }, kUsage, "flags 0x4"},
      {[](auto& info) { info.maxAnisotropy = std::nanf(""); }, kUsage, "maxAnisotropy"},
      {[](auto& info) { info.maxAnisotropy = 65.0f; }, kUsage, "maxAnisotropy"},
      {[](auto& info) { info.firstBinding = UINT32_MAX; }, kUsage, "firstBinding"},
      {[](auto& info) { info.headerVersion = 0; }, kVersion, "headerVersion"},
      {[](auto& info) { info.headerVersion += 0x10000u; }, kVersion, "headerVersion"},
      {[](auto& info) { info.next = &info; }, kVersion, "next"},
      {[](auto& info) { info.reserved = 1; }, kVersion, "reserved"}};
  for (const Wrong& row : rows) {
    LichenVulkanInfo info = good;
    row.change(info);
    const Created created = createAndDestroy(fixture, info);
    INFO(row.word << ": " << created.message);
    CHECK(created.result == row.result);
    CHECK(created.message.find(row.word) != std::string::npos);
  }
  LichenVulkanInfo info = good;
  // A newer header with additions that this host does not use.
  info.headerVersion = LICHEN_HEADER_VERSION + 1;
  CHECK(createAndDestroy(fixture, info).result == LICHEN_SUCCESS);
  info = good;
  // An older header that ends before `stages`: the default applies.
  info.size = offsetof(LichenVulkanInfo, stages);
  info.stages = ~0u;
  CHECK(createAndDestroy(fixture, info).result == LICHEN_SUCCESS);
}

TEST_CASE("NULL handles and outputs, and indices out of range, are errors") {
  const Fixture fixture;
  const LichenVulkanInfo info = defaultVulkanInfo(*fixture.device);
  LichenVulkanContext context = nullptr;
  LichenVulkanAssets assets = nullptr;
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
  VkDescriptorBufferInfo constants{};
  std::array<VkDescriptorImageInfo, LICHEN_SET_IMAGES> images{};
  CHECK(lichenVulkanCreateContext(&info, nullptr, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanCreateContext(nullptr, &context, nullptr) == LICHEN_ERROR_USAGE);
  REQUIRE(lichenVulkanCreateContext(&info, &context, nullptr) == LICHEN_SUCCESS);
  CHECK(lichenVulkanCreateAssets(nullptr, fixture.bundle, &assets, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanCreateAssets(context, nullptr, &assets, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanCreateAssets(context, fixture.bundle, nullptr, nullptr) == LICHEN_ERROR_USAGE);
  REQUIRE(lichenVulkanCreateAssets(context, fixture.bundle, &assets, nullptr) == LICHEN_SUCCESS);
  CHECK(lichenVulkanGetSetLayout(nullptr, &layout) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetSetLayout(context, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetSamplers(nullptr, &sampler, &sampler) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetSamplers(context, nullptr, &sampler) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetSamplers(context, &sampler, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetDescriptors(nullptr, 0, &constants, images.data()) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetDescriptors(assets, 1, &constants, images.data()) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetDescriptors(assets, 0, nullptr, images.data()) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanGetDescriptors(assets, 0, &constants, nullptr) == LICHEN_ERROR_USAGE);
  const auto allocate = [&](LichenVulkanAssets a, std::uint32_t noise, VkDescriptorPool pool,
                            const VkDescriptorBufferInfo* material, VkDescriptorSet* target) {
    return lichenVulkanAllocateSet(a, noise, pool, material, target, nullptr);
  };
  const VkDescriptorBufferInfo noBuffer{VK_NULL_HANDLE, 0, LICHEN_MATERIAL_BYTES};
  const VkDescriptorBufferInfo tooShort{fixture.buffer.handle, 0, LICHEN_MATERIAL_BYTES - 1};
  CHECK(allocate(nullptr, 0, fixture.pool, &fixture.material, &set) == LICHEN_ERROR_USAGE);
  CHECK(allocate(assets, 1, fixture.pool, &fixture.material, &set) == LICHEN_ERROR_USAGE);
  CHECK(allocate(assets, 0, VK_NULL_HANDLE, &fixture.material, &set) == LICHEN_ERROR_USAGE);
  CHECK(allocate(assets, 0, fixture.pool, nullptr, &set) == LICHEN_ERROR_USAGE);
  CHECK(allocate(assets, 0, fixture.pool, &noBuffer, &set) == LICHEN_ERROR_USAGE);
  CHECK(allocate(assets, 0, fixture.pool, &tooShort, &set) == LICHEN_ERROR_USAGE);
  CHECK(allocate(assets, 0, fixture.pool, &fixture.material, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanRecordUpload(nullptr, VK_NULL_HANDLE) == LICHEN_ERROR_USAGE);
  CHECK(lichenVulkanRecordUpload(assets, VK_NULL_HANDLE) == LICHEN_ERROR_USAGE);
  lichenVulkanReleaseStaging(assets);
  const auto submitted = fixture.device->submit([&](VkCommandBuffer commands) {
    CHECK(lichenVulkanRecordUpload(assets, commands) == LICHEN_ERROR_USAGE);
  });
  CHECK(submitted.ok());
  lichenVulkanReleaseStaging(nullptr);
  lichenVulkanRetireAssets(nullptr, 0);
  lichenVulkanFrameCompleted(nullptr, 0);
  lichenVulkanDestroyAssets(nullptr);
  lichenVulkanDestroyContext(nullptr);
  lichenVulkanDestroyAssets(assets);
  lichenVulkanDestroyContext(context);
}
