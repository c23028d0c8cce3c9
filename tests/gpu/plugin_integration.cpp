// SPDX-License-Identifier: MIT
// The C host of docs/integration.md on a device: what it draws, and reloading with frames in
// flight.
#include "integration_host.h"
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <array>
#include <tiling_maps.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::array<SyntheticMap, 3> kMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32}}};
constexpr std::uint32_t kFramesInFlight = 2;
constexpr std::uint32_t kGenerations = 4;

/// The engine around the integration's code: a pool and a uniform buffer.
struct Engine {
  explicit Engine(HeadlessDevice& d) : device(d) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, kGenerations},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                           kGenerations * 2 * std::uint32_t(kMaps.size())}};
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = kGenerations;
    info.poolSizeCount = 2;
    info.pPoolSizes = sizes;
    REQUIRE(vkCreateDescriptorPool(d.device(), &info, nullptr, &host.pool) == VK_SUCCESS);
    uniforms = d.createBuffer(kFramesInFlight * LICHEN_UNIFORM_BYTES,
                              VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true)
                   .value();
    host.instance = d.instance();
    host.physicalDevice = d.physicalDevice();
    host.device = d.device();
    host.getInstanceProcAddr = vkGetInstanceProcAddr;
    host.uniformBuffer = uniforms.handle;
    host.mappedUniforms = reinterpret_cast<unsigned char*>(uniforms.mapped);
    LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
    REQUIRE(createContext(&host, &context, &diagnostic) == LICHEN_SUCCESS);
  }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  ~Engine() {
    lichenVulkanDestroyContext(context);
    vkDestroyDescriptorPool(device.device(), host.pool, nullptr);
  }

  NoiseMaterial load(std::span<const std::byte> file) {
    NoiseMaterial material{};
    LichenResult result = LICHEN_SUCCESS;
    const auto submitted = device.submit([&](VkCommandBuffer commands) {
      result = loadMaterial(&host, context, file.data(), file.size(), 0, commands, &material,
                            &diagnostic);
    });
    REQUIRE(submitted.ok());
    INFO(diagnostic.text);
    REQUIRE(result == LICHEN_SUCCESS);
    return material;
  }

  std::vector<std::array<float, 4>> draw(const NoiseMaterial& material, std::uint64_t frame,
                                         const std::vector<Point>& points) {
    const std::int64_t cameraTile[2] = {1000000, -3};
    std::uint32_t offset = 0;
    REQUIRE(updateMaterial(&host, &material, std::uint32_t(frame % kFramesInFlight), cameraTile,
                           &offset, &diagnostic) == LICHEN_SUCCESS);
    ComputeRun run;
    run.spirv = tiling_maps_comp;
    run.layout = material.setLayout;
    run.set = material.set;
    run.dynamicOffsets = {offset};
    return runCompute<std::array<float, 4>>(device, run, points, kMaps.size());
  }

  HeadlessDevice& device;
  DeviceBuffer uniforms;
  Host host{};
  LichenVulkanContext context = nullptr;
  LichenDiagnostic diagnostic;
};

} // namespace

TEST_CASE("the documented host draws what the tests' own host draws, also after reloading") {
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  std::vector<Point> points(200);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{float(k) * 0.013f, float(k) * -0.007f}, {0.02f, 0.0f}, {0.0f, 0.05f}, {}};
  LichenUniformInfo uniforms;
  LICHEN_INIT(uniforms, LICHEN_STRUCTURE_UNIFORM_INFO);
  uniforms.tileOrigin[0] = 1000000;
  uniforms.tileOrigin[1] = -3;
  PluginHost plain(*device, glb);
  const auto expected = plain.evaluate(tiling_maps_comp, 0, uniforms, points, kMaps.size());
  {
    Engine engine(*device);
    NoiseMaterial material = engine.load(glb);
    std::uint64_t frame = 0;
    for (std::uint32_t generation = 0; generation < kGenerations; ++generation) {
      for (std::uint32_t k = 0; k < kFramesInFlight + 1; ++k, ++frame) {
        CHECK(engine.draw(material, frame, points) == expected);
        if (frame >= kFramesInFlight)
          lichenVulkanFrameCompleted(engine.context, frame - kFramesInFlight);
      }
      NoiseMaterial next{};
      if (generation + 1 < kGenerations)
        next = engine.load(glb);
      unloadMaterial(&material, frame - 1);
      material = next;
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("the documented host takes a refused file as it came, and goes on") {
  const auto device = requireDevice();
  {
    Engine engine(*device);
    const std::vector<std::byte> glb = syntheticGlb(kMaps);
    NoiseMaterial material{};
    const auto submitted = device->submit([&](VkCommandBuffer commands) {
      CHECK(loadMaterial(&engine.host, engine.context, glb.data(), glb.size() / 2, 0, commands,
                         &material, &engine.diagnostic) == LICHEN_ERROR_BAD_BUNDLE);
      CHECK(loadMaterial(&engine.host, engine.context, glb.data(), glb.size(), 1, commands,
                         &material, &engine.diagnostic) == LICHEN_ERROR_USAGE);
    });
    CHECK(submitted.ok());
    CHECK(material.assets == nullptr);
    material = engine.load(glb);
    unloadMaterial(&material, 0);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
