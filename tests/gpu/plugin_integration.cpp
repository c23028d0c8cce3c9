// SPDX-License-Identifier: MIT
// Runs the C host of docs/integration.md on a device: drawing, and reloading with frames in flight.
#include "integration_host.h"
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <tiling_maps.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::array<SyntheticMap, 3> kMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32}}};
constexpr std::uint32_t kFramesInFlight = 2;
constexpr std::uint32_t kGenerations = 4;
constexpr std::uint32_t kMaterials = 2;
constexpr std::int64_t kCameraTile[2] = {1000000, -3};

using Values = std::vector<std::array<float, 4>>;

/// A file with two materials that differ only in their seed.
std::vector<std::byte> twoMaterials() {
  BundleFile file = syntheticBundle(kMaps);
  MaterialNoise second;
  second.noise = 1;
  second.seed = 7;
  file.bundle.noises.push_back(file.bundle.noises.front());
  file.bundle.noises.back().name = "second";
  file.bundle.materials.emplace_back(second);
  file.previews.emplace_back();
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  INFO((glb ? std::string() : glb.error().message));
  REQUIRE(glb.ok());
  return std::move(glb).value();
}

/// The engine around the documented code: a pool and a uniform buffer.
struct Engine {
  explicit Engine(VulkanDevice& d) : device(d) {
    constexpr std::uint32_t kSets = kGenerations * kMaterials;
    const VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kSets},
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, kSets},
        {VK_DESCRIPTOR_TYPE_SAMPLER, kSets * 2},
        {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, kSets * LICHEN_SET_IMAGES}};
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = kSets;
    info.poolSizeCount = 4;
    info.pPoolSizes = sizes;
    REQUIRE(vkCreateDescriptorPool(d.device(), &info, nullptr, &host.pool) == VK_SUCCESS);
    uniforms = d.createBuffer(kMaterials * kFramesInFlight * BLOCK_STRIDE,
                              VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true)
                   .value();
    host.instance = d.instance();
    host.physicalDevice = d.physicalDevice();
    host.device = d.device();
    host.getInstanceProcAddr = vkGetInstanceProcAddr;
    host.framesInFlight = kFramesInFlight;
    host.uniformBuffer = uniforms.handle;
    host.mappedUniforms = reinterpret_cast<unsigned char*>(uniforms.mapped);
    LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
    REQUIRE(createContext(&host, &context, &setLayout, &diagnostic) == LICHEN_SUCCESS);
  }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  ~Engine() {
    lichenVulkanDestroyContext(context);
    vkDestroyDescriptorPool(device.device(), host.pool, nullptr);
  }

  NoiseBundle load(std::span<const std::byte> file) {
    NoiseBundle loaded{};
    LichenResult result = LICHEN_SUCCESS;
    const auto submitted = device.submit([&](VkCommandBuffer commands) {
      result = loadBundle(context, file.data(), file.size(), commands, &loaded, &diagnostic);
    });
    REQUIRE(submitted.ok());
    INFO(diagnostic.text);
    REQUIRE(result == LICHEN_SUCCESS);
    return loaded;
  }

  /// The last use of the bundle.
  std::array<NoiseMaterial, kMaterials> addMaterials(NoiseBundle& loaded) {
    std::array<NoiseMaterial, kMaterials> materials{};
    for (std::uint32_t k = 0; k < kMaterials; ++k) {
      REQUIRE(addMaterial(&host, &loaded, k, k, &materials[k], &diagnostic) == LICHEN_SUCCESS);
      std::copy(std::begin(kCameraTile), std::end(kCameraTile), materials[k].placement.tileOrigin);
    }
    finishLoading(&loaded);
    return materials;
  }

  /// Evaluates all materials in one command buffer. The uniforms of all are written before
  /// submission; each draw selects its own by the dynamic offset of its set.
  std::vector<Values> draw(const std::array<NoiseMaterial, kMaterials>& materials,
                           std::uint64_t frame, const std::vector<Point>& points) {
    std::array<std::uint32_t, kMaterials> offsets{};
    for (std::uint32_t k = 0; k < kMaterials; ++k)
      REQUIRE(updateMaterial(&host, &materials[k], std::uint32_t(frame % kFramesInFlight),
                             &offsets[k], &diagnostic) == LICHEN_SUCCESS);
    std::array<ComputeRun, kMaterials> runs;
    for (std::uint32_t k = 0; k < kMaterials; ++k) {
      setArrays<Values::value_type>(runs[k], points, kMaps.size());
      runs[k].spirv = tiling_maps_comp;
      runs[k].layout = setLayout;
      runs[k].set = materials[k].set;
      runs[k].dynamicOffsets = {offsets[k]};
    }
    std::vector<Values> values;
    for (const std::vector<std::byte>& bytes : runComputes(device, runs))
      values.push_back(asArray<Values::value_type>(bytes));
    return values;
  }

  VulkanDevice& device;
  DeviceBuffer uniforms;
  Host host{};
  LichenVulkanContext context = nullptr;
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  LichenDiagnostic diagnostic;
};

} // namespace

TEST_CASE("the documented host draws two materials like the tests' host, even after reloading") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = twoMaterials();
  std::vector<Point> points(200);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{float(k) * 0.013f, float(k) * -0.007f}, {0.02f, 0.0f}, {0.0f, 0.05f}, {}};
  PluginHost plain(*device, glb);
  std::vector<Values> expected;
  for (std::uint32_t k = 0; k < kMaterials; ++k) {
    MaterialUse use = plain.use(k);
    std::copy(std::begin(kCameraTile), std::end(kCameraTile), use.placement.tileOrigin);
    expected.push_back(plain.evaluate(tiling_maps_comp, 0, use, points, kMaps.size()));
  }
  REQUIRE(expected[0] != expected[1]);
  {
    Engine engine(*device);
    NoiseBundle loaded = engine.load(glb);
    std::uint64_t frame = 0;
    for (std::uint32_t generation = 0; generation < kGenerations; ++generation) {
      const auto materials = engine.addMaterials(loaded);
      for (std::uint32_t k = 0; k < kFramesInFlight + 1; ++k, ++frame) {
        CHECK(engine.draw(materials, frame, points) == expected);
        if (frame >= kFramesInFlight)
          lichenVulkanFrameCompleted(engine.context, frame - kFramesInFlight);
      }
      NoiseBundle next{};
      if (generation + 1 < kGenerations)
        next = engine.load(glb);
      unloadBundle(&loaded, frame - 1);
      loaded = next;
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("the documented host continues after an invalid file") {
  const auto device = requireDevice();
  {
    Engine engine(*device);
    const std::vector<std::byte> glb = syntheticGlb(kMaps);
    NoiseBundle loaded{};
    const auto submitted = device->submit([&](VkCommandBuffer commands) {
      CHECK(loadBundle(engine.context, glb.data(), glb.size() / 2, commands, &loaded,
                       &engine.diagnostic) == LICHEN_ERROR_BAD_BUNDLE);
    });
    CHECK(submitted.ok());
    CHECK(loaded.assets == nullptr);
    loaded = engine.load(glb);
    NoiseMaterial material{};
    CHECK(addMaterial(&engine.host, &loaded, 1, 0, &material, &engine.diagnostic) ==
          LICHEN_ERROR_USAGE);
    CHECK(addMaterial(&engine.host, &loaded, 0, 0, &material, &engine.diagnostic) ==
          LICHEN_SUCCESS);
    unloadBundle(&loaded, 0);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
