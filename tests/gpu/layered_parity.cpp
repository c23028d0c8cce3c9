// SPDX-License-Identifier: MIT
// Layered noises in the shader, through the plugin, against the CPU twins.
#include "../property/example_exemplar.h"
#include "../property/layered_example.h"
#include "parity_errors.h"
#include "plugin_host.h"
#include "shared_device.h"
#include "slopes_of_color.h"

#include <lichen/bundle_writer.h>
#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/noise_evaluator.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <layered_evaluate.comp.three_layers.h>
#include <layered_evaluate.comp.two_layers.h>
#include <memory>
#include <random>
#include <span>

using namespace lichen;
using namespace lichen::test;

namespace {

/// The input layout of layered_evaluate.comp.
struct LayeredPoint {
  std::array<float, 4> uvAndGradientX{}, uvGradientY{};
  std::array<float, 4> position{}, gradientX{}, gradientY{}, normal{};
};

constexpr int kWidth = 64, kHeight = 48;

/// Of 16 bits, as rounding of tables has a test of its own for all methods.
Bundle bakedAs(Method method, std::span<const MapExemplar> maps) {
  const auto with = [](auto options) {
    options.bits = 16;
    return options;
  };
  switch (method) {
  case Method::tiling:
    return bundleOf(bakeTiling("noise", maps, with(TilingOptions())));
  case Method::texton: {
    TextonOptions options;
    options.support = 16;
    return bundleOf(bakeTexton("noise", maps, options));
  }
  case Method::localRandomPhase: {
    LocalRandomPhaseOptions options;
    options.cosines = 24;
    options.structure = 0.0;
    return bundleOf(bakeLocalRandomPhase("noise", maps, with(options)));
  }
  case Method::multipleKernels: {
    MultipleKernelsOptions options;
    options.kernels = 6;
    return bundleOf(bakeMultipleKernels("noise", maps, with(options)));
  }
  case Method::quilting: // is no layer
    break;
  }
  return {};
}

struct Kind {
  std::vector<Method> methods; ///< by layer
  Mapping mapping;
  MapTarget first = MapTarget::baseColor; ///< the map that is compared; colours are another
};

/// A colour map as one with another target.
MapExemplar asTarget(MapTarget target, MapExemplar color) {
  if (target == MapTarget::normal)
    return slopesOf(std::move(color));
  color.target = target;
  if (target == MapTarget::occlusionRoughnessMetallic) {
    color.channels = {MapChannel::occlusion, MapChannel::roughness, MapChannel::metallic};
    color.encoding = ValueEncoding::linear;
  }
  return color;
}

/// The pass for so many layers.
std::vector<std::uint32_t> passFor(std::size_t layers) {
  if (layers == 4)
    return committedShader("layered_evaluate.comp");
  const std::span<const std::uint32_t> code =
      layers == 2 ? std::span<const std::uint32_t>(layered_evaluate_comp_two_layers)
                  : layered_evaluate_comp_three_layers;
  return {code.begin(), code.end()};
}

std::vector<std::byte> bakedGlb(const Kind& kind) {
  std::vector<Bundle> layers;
  std::vector<double> shares;
  for (std::size_t layer = 0; layer < kind.methods.size(); ++layer) {
    const MapExemplar color = threeMaterials(kWidth, kHeight, 5 + layer);
    std::vector<MapExemplar> maps{color};
    if (kind.first != MapTarget::baseColor)
      maps.insert(maps.begin(), asTarget(kind.first, color));
    layers.push_back(bakedAs(kind.methods[layer], maps));
    shares.push_back(0.8 / double(kind.methods.size()));
  }
  shares.pop_back();
  BundleFile file;
  file.bundle = layeredExample(layers, examplePatches(kWidth, kHeight), shares, 0.2);
  file.bundle.materials[0]->mapping = kind.mapping;
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  INFO((glb ? std::string() : glb.error().message));
  REQUIRE(glb);
  return std::move(glb).value();
}

/// Points some tiles around the origin, with footprints from a quarter of a texel to a tile.
std::vector<LayeredPoint> samplePoints(std::size_t count) {
  std::mt19937 generator(17u);
  std::uniform_real_distribution<float> tiles(-3.0f, 3.0f), level(-2.0f, 6.0f);
  std::normal_distribution<float> gaussian;
  std::vector<LayeredPoint> points(count);
  for (LayeredPoint& point : points) {
    const float length = std::exp2(level(generator)) / float(kWidth);
    point.uvAndGradientX = {tiles(generator), tiles(generator), length * gaussian(generator),
                            length * gaussian(generator)};
    point.uvGradientY = {length * gaussian(generator), length * gaussian(generator), 0.0f, 0.0f};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = tiles(generator);
      point.gradientX[axis] = length * gaussian(generator);
      point.gradientY[axis] = length * gaussian(generator);
      point.normal[axis] = gaussian(generator);
    }
  }
  return points;
}

std::array<float, 3> firstThree(const std::array<float, 4>& all) {
  return {all[0], all[1], all[2]};
}

NoiseEvaluator::Value expectedAt(const NoiseEvaluator& twin, Mapping mapping,
                                 const LayeredPoint& point) {
  if (mapping == Mapping::triplanar)
    return twin.evaluate(0,
                         TriplanarFootprint{firstThree(point.position), firstThree(point.gradientX),
                                            firstThree(point.gradientY), firstThree(point.normal)});
  if (mapping == Mapping::solid)
    return twin.evaluate(0, SolidFootprint{firstThree(point.position), firstThree(point.gradientX),
                                           firstThree(point.gradientY)});
  const auto& [u, v, dux, dvx] = point.uvAndGradientX;
  return twin.evaluateUv(0, {{u, v}, {dux, dvx}, {point.uvGradientY[0], point.uvGradientY[1]}});
}

} // namespace

TEST_CASE("the shader of layered noises matches its CPU twin: 99.9 % within 1/1024, all within "
          "1/255") {
  constexpr Method kTiling = Method::tiling, kTexton = Method::texton,
                   kCosines = Method::localRandomPhase, kKernels = Method::multipleKernels;
  constexpr MapTarget kSlopes = MapTarget::normal;
  VulkanDevice* const device = sharedDevice();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.flags = LICHEN_VULKAN_LAYERS;
  PluginContext context(*device, info);
  for (const Kind& kind :
       {Kind{{kTiling, kTiling}, Mapping::uv}, Kind{{kTiling, kKernels}, Mapping::uv, kSlopes},
        Kind{{kTiling, kTiling}, Mapping::uv, MapTarget::occlusionRoughnessMetallic},
        Kind{{kTiling, kTexton, kKernels}, Mapping::uv, kSlopes},
        Kind{{kTexton, kTiling, kCosines, kKernels}, Mapping::uv},
        Kind{{kTexton, kTiling}, Mapping::triplanar, kSlopes},
        Kind{{kTiling, kTiling, kTexton}, Mapping::triplanar},
        Kind{{kCosines, kKernels}, Mapping::solid, kSlopes},
        Kind{{kKernels, kKernels, kCosines}, Mapping::solid}}) {
    INFO("layers: " << kind.methods.size() << ", mapping " << nameOf(kind.mapping) << ", "
                    << nameOf(kind.first));
    const std::vector<std::byte> glb = bakedGlb(kind);
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(context, glb);
    MaterialUse use = host.use();
    use.parameters.seed = 77;
    use.parameters.scale = 0.8;
    use.parameters.offset[0] = 0.25;
    use.parameters.contrast = 1.2;
    use.placement.tileOrigin[0] = -(std::int64_t(1) << 40);
    use.placement.tileOrigin[1] = 1000001;
    MaterialNoise material = *bundle.materials[0];
    material.seed = 77;
    material.scale = 0.8;
    material.offset = {0.25, 0.0};
    material.contrast = 1.2;
    Placement placement;
    placement.tileOriginX = use.placement.tileOrigin[0];
    placement.tileOriginY = use.placement.tileOrigin[1];
    const auto twin = NoiseEvaluator::create(bundle, material, placement).value();
    // Each other constant is a pipeline of its own, which takes lavapipe 7 s to compile.
    const bool isTiling =
        std::ranges::count(kind.methods, kTiling) == std::ptrdiff_t(kind.methods.size());
    const std::int32_t methods = isTiling ? 1 : 15;
    const std::vector<LayeredPoint> points = samplePoints(400);
    const auto values = host.evaluate(passFor(kind.methods.size()), methods, use, points);
    ParityErrors errors;
    for (std::size_t k = 0; k < points.size(); ++k)
      errors.add(values[k], expectedAt(*twin, kind.mapping, points[k]));
    errors.check();
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }
}

TEST_CASE("a set without the bindings of layers is refused for a layered noise") {
  VulkanDevice* const device = sharedDevice();
  PluginContext context(*device, defaultVulkanInfo(*device));
  const std::vector<std::byte> glb =
      bakedGlb({{Method::tiling, Method::tiling}, Mapping::uv, MapTarget::baseColor});
  const std::shared_ptr<LichenBundle_T> bundle(parseOrThrow(glb), lichenDestroyBundle);
  LichenVulkanAssets assets = nullptr;
  REQUIRE(lichenVulkanCreateAssets(context.context(), bundle.get(), &assets, nullptr) ==
          LICHEN_SUCCESS);
  const VkDescriptorPool pool = context.createPool(1);
  const VkDescriptorBufferInfo buffer{VK_NULL_HANDLE, 0, LICHEN_LAYERED_MATERIAL_BYTES};
  VkDescriptorSet set = VK_NULL_HANDLE;
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  CHECK(lichenVulkanAllocateSet(assets, 0, pool, &buffer, &set, &diagnostic) == LICHEN_ERROR_USAGE);
  CHECK(std::string(diagnostic.text) ==
        "noise 0 is layered; create the context with the flag LICHEN_VULKAN_LAYERS");
  vkDestroyDescriptorPool(device->device(), pool, nullptr);
  lichenVulkanDestroyAssets(assets);
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
