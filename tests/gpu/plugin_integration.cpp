// SPDX-License-Identifier: MIT
// Runs the C host of docs/integration.md on a device: drawing, and reloading with two frames in
// flight.
#include "glb_of.h"
#include "integration_host.h"
#include "plugin_host.h"
#include "require_device.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <tiling_maps.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::uint32_t kFramesInFlight = 2;
constexpr std::uint32_t kGenerations = 4;
constexpr std::uint32_t kMaterials = 2;
constexpr std::uint32_t kFramesPerGeneration = kFramesInFlight + 1;

using Values = std::vector<std::array<float, 4>>;

/// The camera moves on each frame, so that a frame which reads another's uniforms differs.
void setCamera(LichenPlacement& placement, std::uint64_t frame) {
  placement.tileOrigin[0] = 1000000 + std::int64_t(frame);
  placement.tileOrigin[1] = -3;
}

/// A file with two materials that differ only in their seed.
std::vector<std::byte> twoMaterials() {
  BundleFile file = syntheticBundle(kThreeMaps);
  MaterialNoise second;
  second.noise = 1;
  second.seed = 7;
  file.bundle.noises.push_back(file.bundle.noises.front());
  file.bundle.noises.back().name = "second";
  file.bundle.materials.emplace_back(second);
  file.previews.emplace_back();
  return glbOf(file);
}

/// The engine around the documented code: a pool and a uniform buffer.
struct Engine {
  static constexpr std::uint32_t kSets = kGenerations * kMaterials;
  static constexpr std::array<VkDescriptorPoolSize, 4> kSizes{
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kSets},
       {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, kSets},
       {VK_DESCRIPTOR_TYPE_SAMPLER, kSets * 2},
       {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, kSets* LICHEN_SET_IMAGES}}};

  explicit Engine(VulkanDevice& d)
      : device(d), pool(d.device(), kSets, kSizes), pipelines(d.device()) {
    host.pool = pool.handle();
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
  ~Engine() { lichenVulkanDestroyContext(context); }

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
    for (std::uint32_t k = 0; k < kMaterials; ++k)
      REQUIRE(addMaterial(&host, &loaded, k, k, &materials[k], &diagnostic) == LICHEN_SUCCESS);
    finishLoading(&loaded);
    return materials;
  }

  /// Submits a frame that evaluates all materials, and does not wait for it. The uniforms of all
  /// are written before submission; each draw selects its own by the dynamic offset of its set.
  std::unique_ptr<PendingRuns> draw(std::array<NoiseMaterial, kMaterials>& materials,
                                    std::uint64_t frame, const std::vector<Point>& points) {
    std::vector<ComputeRun> runs(kMaterials);
    for (std::uint32_t k = 0; k < kMaterials; ++k) {
      setCamera(materials[k].placement, frame);
      std::uint32_t offset = 0;
      REQUIRE(updateMaterial(&host, &materials[k], std::uint32_t(frame % kFramesInFlight), &offset,
                             &diagnostic) == LICHEN_SUCCESS);
      setArrays<Values::value_type>(runs[k], points, kThreeMaps.size());
      runs[k].spirv = tiling_maps_comp;
      runs[k].layout = setLayout;
      runs[k].set = materials[k].set;
      runs[k].dynamicOffsets = {offset};
      runs[k].pipelines = &pipelines;
    }
    return std::make_unique<PendingRuns>(device, std::move(runs));
  }

  VulkanDevice& device;
  DescriptorPool pool;
  DeviceBuffer uniforms;
  Host host{};
  LichenVulkanContext context = nullptr;
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  ComputePipelines pipelines;
  LichenDiagnostic diagnostic;
};

} // namespace

TEST_CASE("the documented host draws two materials like the tests' host, even after reloading") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = twoMaterials();
  const std::vector<Point> points = linePoints();
  PluginHost plain(*device, glb);
  std::vector<std::vector<Values>> expected; // of each frame: one for each material
  for (std::uint64_t frame = 0; frame < kGenerations * kFramesPerGeneration; ++frame) {
    expected.emplace_back();
    for (std::uint32_t k = 0; k < kMaterials; ++k) {
      MaterialUse use = plain.use(k);
      setCamera(use.placement, frame);
      expected.back().push_back(
          plain.evaluate(tiling_maps_comp, 0, use, points, kThreeMaps.size()));
    }
  }
  REQUIRE(expected[0][0] != expected[0][1]);
  REQUIRE(expected[0][0] != expected[1][0]);
  {
    Engine engine(*device);
    std::deque<std::unique_ptr<PendingRuns>> inFlight;
    std::uint64_t completed = 0;
    const auto complete = [&] {
      std::vector<Values> values;
      for (const std::vector<std::byte>& bytes : inFlight.front()->outputs())
        values.push_back(asArray<Values::value_type>(bytes));
      CHECK((values == expected[completed])); // too many to print
      inFlight.pop_front();
      lichenVulkanFrameCompleted(engine.context, completed++);
    };
    NoiseBundle loaded = engine.load(glb);
    std::uint64_t frame = 0;
    for (std::uint32_t generation = 0; generation < kGenerations; ++generation) {
      auto materials = engine.addMaterials(loaded);
      NoiseBundle next{};
      for (std::uint32_t k = 0; k < kFramesPerGeneration; ++k, ++frame) {
        if (inFlight.size() == kFramesInFlight)
          complete(); // its block of uniforms is free again
        inFlight.push_back(engine.draw(materials, frame, points));
        if (k == 0 && generation + 1 < kGenerations)
          next = engine.load(glb);
      }
      REQUIRE(inFlight.size() == kFramesInFlight); // both draw what is unloaded now
      unloadBundle(&loaded, frame - 1);
      loaded = next;
    }
    while (!inFlight.empty())
      complete();
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("the documented host continues after an invalid file") {
  const auto device = requireDevice();
  {
    Engine engine(*device);
    const std::vector<std::byte> glb = syntheticGlb(kThreeMaps);
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
