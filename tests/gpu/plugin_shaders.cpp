// SPDX-License-Identifier: MIT
// How shaders meet noises: one shader for bundles with different maps, and several noises of one
// bundle in one shader, with descriptors of the host's own.
#include "glb_of.h"
#include "plugin_host.h"
#include "screen_pass.h"
#include "shared_device.h"
#include "synthetic_texton.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <four_noises.frag.h>
#include <roles.comp.h>
#include <view.vert.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr std::size_t kRoles = LICHEN_MAX_MAPS;
constexpr SyntheticMap kColor = kThreeMaps[0], kSlopes = kThreeMaps[1], kOrm = kThreeMaps[2];

} // namespace

TEST_CASE("one shader and pipeline draw bundles with different maps") {
  VulkanDevice* const device = sharedDevice();
  PluginContext& context = sharedContext();
  const std::vector<Point> points = linePoints();
  for (const std::vector<SyntheticMap>& maps :
       {std::vector{kColor}, std::vector{kSlopes, kOrm}, std::vector{kColor, kSlopes, kOrm}}) {
    const std::vector<std::byte> glb = syntheticGlb(maps);
    const Bundle bundle = parseBundle(glb, "synthetic").value();
    PluginHost host(context, glb);
    const auto values = host.evaluate(roles_comp, 0, host.use(), points, kRoles);
    std::array<bool, kRoles> isThere{};
    for (std::size_t m = 0; m < maps.size(); ++m) {
      const std::uint32_t role = roleOf(bundle.noises[0].maps[m].target);
      isThere[role] = true;
      const TilingReference reference(bundle, m);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto expected = reference.evaluate(points[k], host.material());
        for (std::size_t c = 0; c < 3; ++c)
          REQUIRE(double(values[k * kRoles + role][c]) ==
                  Approx(expected.value[c]).margin(1.0 / 255.0));
      }
    }
    for (std::size_t role = 0; role < kRoles; ++role)
      for (std::size_t k = 0; k < points.size(); ++k)
        REQUIRE((values[k * kRoles + role][0] == -1.0f) == !isThere[role]);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

namespace {

constexpr std::uint32_t kNoises = 4;

/// Three tilings and a texton noise, each with a base colour and a material of its own.
std::vector<std::byte> fourNoises() {
  BundleFile file = syntheticBundle(std::span(&kColor, 1));
  for (std::uint32_t n = 1; n < kNoises; ++n) {
    const SyntheticMap map{3, 16u << n, 48};
    const Bundle added =
        n == 2 ? syntheticTextonBundle({}).bundle : syntheticBundle(std::span(&map, 1)).bundle;
    Noise noise = added.noises[0];
    noise.name = "noise " + std::to_string(n);
    const std::size_t first = file.bundle.tables.size();
    if (auto* tiling = std::get_if<TilingMap>(&noise.maps[0].data)) {
      tiling->gaussian += first;
      tiling->inverseTable = *tiling->inverseTable + first;
    } else {
      noise.maps[0].as<TextonMap>().image += first;
    }
    file.bundle.tables.insert(file.bundle.tables.end(), added.tables.begin(), added.tables.end());
    file.bundle.noises.push_back(std::move(noise));
    MaterialNoise material;
    material.noise = n;
    material.seed = n;
    material.scale = 0.5 + 0.25 * n;
    file.bundle.materials.emplace_back(material);
    file.previews.emplace_back();
  }
  return glbOf(file);
}

/// The host's own descriptors: binding -> type and count, as four_noises.frag declares them.
constexpr std::array<VkDescriptorPoolSize, 6> kBindings{
    {{VK_DESCRIPTOR_TYPE_SAMPLER, 1},
     {VK_DESCRIPTOR_TYPE_SAMPLER, 1},
     {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, kNoises},
     {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, kNoises},
     {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
     {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}}};

struct OwnSet {
  explicit OwnSet(VkDevice d) : device(d), pool(d, 1, kBindings) {
    std::array<VkDescriptorSetLayoutBinding, kBindings.size()> bindings{};
    for (std::uint32_t i = 0; i < kBindings.size(); ++i)
      bindings[i] = {i, kBindings[i].type, kBindings[i].descriptorCount,
                     VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    layoutInfo.bindingCount = std::uint32_t(bindings.size());
    layoutInfo.pBindings = bindings.data();
    REQUIRE(vkCreateDescriptorSetLayout(device, &layoutInfo, nullptr, &layout) == VK_SUCCESS);
    set = pool.allocate(layout);
  }
  OwnSet(const OwnSet&) = delete;
  OwnSet& operator=(const OwnSet&) = delete;
  ~OwnSet() { vkDestroyDescriptorSetLayout(device, layout, nullptr); }

  void write(std::uint32_t binding, const VkDescriptorImageInfo* images,
             const VkDescriptorBufferInfo* buffer) const {
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = binding;
    write.descriptorCount = kBindings[binding].descriptorCount;
    write.descriptorType = kBindings[binding].type;
    write.pImageInfo = images;
    write.pBufferInfo = buffer;
    vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
  }

  VkDevice device;
  DescriptorPool pool;
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
};

} // namespace

TEST_CASE("four noises of two methods in one fragment shader, with descriptors of the host's own") {
  VulkanDevice* const device = sharedDevice();
  const std::vector<std::byte> glb = fourNoises();
  constexpr std::uint32_t kSide = 16; // [pixels] of a view of kUvPerScreen
  constexpr float kUvPerScreen = 0.5f, kUvPerPixel = kUvPerScreen / float(kSide);
  std::vector<Point> points;
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x)
      points.push_back({{(float(x) + 0.5f) * kUvPerPixel, (float(y) + 0.5f) * kUvPerPixel},
                        {kUvPerPixel, 0.0f},
                        {0.0f, kUvPerPixel},
                        {}});
  PluginHost host(sharedContext(), glb);
  // Each noise alone, by the plugin's set; the first run uploads all of them.
  std::vector<std::vector<std::array<float, 4>>> expected;
  for (std::uint32_t n = 0; n < kNoises; ++n) {
    host.setNoise(n);
    expected.push_back(host.evaluate(roles_comp, 0, host.use(n), points, kRoles));
  }

  const OwnSet own(device->device());
  std::array<VkSampler, 2> samplers{};
  REQUIRE(lichenVulkanGetSamplers(host.context().context(), &samplers[0], &samplers[1]) ==
          LICHEN_SUCCESS);
  std::array<std::array<VkDescriptorImageInfo, kNoises>, 2> images{}; // images, tables
  VkDescriptorBufferInfo noises{};
  for (std::uint32_t n = 0; n < kNoises; ++n) {
    VkDescriptorBufferInfo constants{};
    std::array<VkDescriptorImageInfo, LICHEN_SET_IMAGES> all{};
    REQUIRE(lichenVulkanGetDescriptors(host.assets(), n, &constants, all.data()) == LICHEN_SUCCESS);
    images[0][n] = all[LICHEN_BASE_COLOR];
    images[1][n] = all[LICHEN_MAX_MAPS + LICHEN_BASE_COLOR];
    CHECK(constants.offset == n * LICHEN_NOISE_BYTES);
    noises = {constants.buffer, 0, VK_WHOLE_SIZE};
  }
  const DeviceBuffer materials =
      device
          ->createBuffer(kNoises * LICHEN_MATERIAL_BYTES, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true)
          .value();
  for (std::uint32_t n = 0; n < kNoises; ++n) {
    const MaterialUse use = host.use(n);
    REQUIRE(lichenFillMaterial(&use.parameters, &use.placement,
                               materials.mapped + n * LICHEN_MATERIAL_BYTES,
                               nullptr) == LICHEN_SUCCESS);
  }
  const VkDescriptorBufferInfo blocks{materials.handle, 0, VK_WHOLE_SIZE};
  for (std::uint32_t k = 0; k < 2; ++k) {
    const VkDescriptorImageInfo sampler{samplers[k], VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED};
    own.write(k, &sampler, nullptr);
    own.write(2 + k, images[k].data(), nullptr);
  }
  own.write(4, nullptr, &noises);
  own.write(5, nullptr, &blocks);

  DeviceImageInfo info;
  info.format = bench::kScreenFormat;
  info.extent = {kSide, kSide, 1};
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const DeviceImage target = device->createImage(info).value();
  bench::ScreenPass pass(*device, view_vert, four_noises_frag, own.layout);
  (void)pass.draw(target, own.set, {kUvPerScreen, kUvPerScreen, 1.0f});
  const std::vector<std::byte> texels =
      device->readImage(target, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, 4).value();
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const float noise = expected[k % kNoises][k * kRoles + LICHEN_BASE_COLOR][c];
      REQUIRE(std::to_integer<int>(texels[4 * k + c]) ==
              Approx(255.0f * std::clamp(noise, 0.0f, 1.0f)).margin(0.75));
    }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
