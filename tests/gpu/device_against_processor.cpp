// SPDX-License-Identifier: MIT
// Every method on every mapping, with each of its options: the committed SPIR-V on a device,
// through the plugin, against the same shader library compiled as C++. Both share their formulas,
// which the oracles of the files beside this one check.
#include "../property/layered_example.h"
#include "baked_noises.h"
#include "device_noise.h"
#include "shared_device.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <layered_evaluate.comp.three_layers.h>
#include <layered_evaluate.comp.two_layers.h>
#include <string>
#include <tiling_evaluate.comp.joint_table.h>
#include <tiling_evaluate.comp.nearest_level.h>
#include <tiling_evaluate.comp.no_rotation.h>
#include <tiling_evaluate.comp.no_table.h>
#include <triplanar_evaluate.comp.no_rotation.h>

using namespace lichen;
using namespace lichen::test;

namespace {

using enum Method;
using enum SyntheticTable;
using Spirv = std::span<const std::uint32_t>;
constexpr MapTarget kColor = MapTarget::baseColor, kSlopes = MapTarget::normal,
                    kHeight = MapTarget::height;

BundleFile tilingFile(const SyntheticMap& map) { return syntheticBundle(std::span(&map, 1)); }

struct Case {
  std::string name;
  BundleFile file;
  Mapping mapping = Mapping::uv;
  std::uint32_t tileRotation = 1;
  Spirv spirv = {}; ///< instead of the committed pass
  EvaluationOptions options = {};
};

std::vector<Case> tilingCases() {
  const auto& [colors, slopes, orm, plainColors, plainSlopes, height] = kTilingMaps;
  std::vector<Case> all;
  for (const SyntheticMap& map : kTilingMaps)
    all.push_back({"tiling", tilingFile(map), Mapping::uv, map.width == map.height ? 4u : 2u});
  for (const SyntheticMap& map : {colors, slopes, height})
    all.push_back({"triplanar tiling", tilingFile(map), Mapping::triplanar, 2});
  // Shaders of hosts that leave code out.
  for (const SyntheticMap& map : {colors, slopes, orm})
    all.push_back(
        {"joint tables alone", tilingFile(map), Mapping::uv, 2, tiling_evaluate_comp_joint_table});
  all.push_back(
      {"no table at all", tilingFile(plainColors), Mapping::uv, 2, tiling_evaluate_comp_no_table});
  all.push_back(
      {"no rotation", tilingFile(slopes), Mapping::uv, 1, tiling_evaluate_comp_no_rotation});
  all.push_back({"nearest table level",
                 tilingFile(colors),
                 Mapping::uv,
                 2,
                 tiling_evaluate_comp_nearest_level,
                 {.nearestTableLevel = true}});
  return all;
}

std::vector<Case> textonCases() {
  const SyntheticTexton colors, order3{.order = 3, .channels = 1},
      slopes{.coefficientsX = 8, .coefficientsY = 30, .mipLevels = 2, .channels = 2},
      mix{.order = 3, .steps = 3, .channels = 1};
  std::vector<Case> all;
  const auto add = [&](const char* name, const SyntheticTexton& texton, Mapping mapping) {
    all.push_back({name, syntheticTextonBundle(texton), mapping});
  };
  add("order 0", {.order = 0, .channels = 1}, Mapping::uv);
  add("order 1", {.order = 1, .channels = 1}, Mapping::uv);
  add("no mips", {.order = 3, .mipLevels = 1}, Mapping::uv);
  for (const Mapping mapping : {Mapping::uv, Mapping::triplanar, Mapping::surface}) {
    add("slopes", slopes, mapping);
    add("mix", mix, mapping);
  }
  add("colours on a surface", colors, Mapping::surface);
  add("order 3 on a surface", order3, Mapping::surface);
  return all;
}

std::vector<Case> bakedCases() {
  constexpr GaussianOnly kNoTable = GaussianOnly::yes;
  using enum KernelWindow;
  std::vector<Case> all;
  const auto add = [&](const Baked& kind, Mapping mapping = Mapping::uv) {
    all.push_back({std::string(nameOf(kind.method)), baked(kind), mapping});
  };
  add({localRandomPhase, {kHeight}});
  add({localRandomPhase, {kSlopes}, kNoTable});
  add({.method = localRandomPhase, .targets = {kHeight}, .structure = 0.6});
  add({.method = localRandomPhase, .structure = 0.5, .guide = 1.0});
  add({.method = localRandomPhase, .structure = 1.0, .guide = 1.0});
  add({.method = localRandomPhase, .structure = 0.7, .guide = 0.7}, Mapping::triplanar);
  add({localRandomPhase}, Mapping::solid);
  add({localRandomPhase, {kSlopes}, kNoTable}, Mapping::solid);
  add({.method = multipleKernels, .targets = {kHeight}, .rings = 2, .patternCosines = 7});
  add({.method = multipleKernels, .targets = {kHeight}, .gaussian = kNoTable, .window = sinc});
  add({.method = multipleKernels, .window = gaussianSinc});
  add({multipleKernels, {kSlopes}}, Mapping::triplanar);
  add({.method = multipleKernels, .rings = 2}, Mapping::solid);
  add({multipleKernels, {kSlopes}, kNoTable}, Mapping::solid);
  add({.method = multipleKernels, .rings = 2}, Mapping::surface);
  add({.method = multipleKernels, .targets = {kHeight}, .window = sinc}, Mapping::surface);
  add({.method = multipleKernels, .targets = {kSlopes}, .window = gaussianSinc}, Mapping::surface);
  for (const Mapping mapping : {Mapping::uv, Mapping::triplanar}) {
    add({quilting, {kHeight}}, mapping);
    add({.method = quilting, .guide = 1.0, .grain = Grain::x}, mapping);
  }
  return all;
}

/// By how much quilting varies around a point, as far as a sampler with 8 bits below the texel
/// rounds the position of a fetch of cells: a cut between two of them is a texel wide, and the
/// weights there have a slope of 16. Each of the three fetches of a plane is rounded by itself.
DeviceNoise::Value roundedFetches(const DeviceNoise& noise, const SamplePoint& point) {
  constexpr float kRounding = 1.0f / 512.0f, kFetches = 3.0f;
  constexpr float kCellsX = kExemplarWidth / 2.0f, kCellsY = kExemplarHeight / 2.0f;
  const DeviceNoise::Value here = noise.value(point);
  return std::visit(
      [&](auto at) {
        const std::size_t axes = at.position.size();
        const shader::LichenMaterial& m = noise.host.material();
        // Texels of cells: along the tile's axes, or in space.
        const float texel = axes == 2 ? 1.0f : 1.0f / std::hypot(m.uvToTileYX, m.uvToTileYY);
        DeviceNoise::Value most{};
        for (std::size_t beside = 0; beside < (axes == 2 ? 9u : 27u); ++beside) {
          auto there = at;
          for (std::size_t axis = 0, rest = beside; axis < axes; ++axis, rest /= 3)
            there.position[axis] += (float(rest % 3) - 1.0f) * kRounding * texel /
                                    (axes == 2 && axis == 0 ? kCellsX : kCellsY);
          const auto value = noise.evaluator->evaluate(0, noise.host.planes(), there);
          for (std::size_t c = 0; c < 4; ++c)
            most[c] = std::max(most[c], kFetches * std::abs(value[c] - here[c]));
        }
        return most;
      },
      noise.footprint(point));
}

/// Rounding may move a point across the border of a coefficient of order 0, or of a step of a mix.
/// Coordinates of some 100 texels are rounded to 2^-17: with 30 impacts, a fraction of 3e-4 of
/// points has one on the other side of one of two borders.
void check(const Differences& differences, bool hasBorders) {
  if (hasBorders)
    CHECK(differences.fractionBeyond() <= 0.003);
  else
    differences.check();
}

/// The map's value and its slopes, for bumps of heights.
void compareGradients(DeviceNoise& noise, const MaterialUse& use,
                      const std::vector<SamplePoint>& points, bool hasBorders) {
  const auto found = noise.drawn(kGradient, use, points);
  Differences values;
  double squares = 0.0, errors = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::array<float, 3> expected = noise.gradient(points[k]);
    values.add(double(found[k][0]), double(expected[0]));
    for (std::size_t c = 1; c < 3; ++c) {
      const double slope = double(expected[c]), error = double(found[k][c]) - slope;
      squares += slope * slope;
      errors += error * error;
      if (noise.method == texton)
        values.add(error / 64.0, 0.0); // per texel, as the values
    }
  }
  check(values, hasBorders);
  if (noise.method != texton)
    CHECK(std::sqrt(errors / squares) < 0.01); // differences within tables are rounded
}

/// Compares values and, but for quilting and passes that are not committed, what they are decoded
/// from.
void compareValues(DeviceNoise& noise, const MaterialUse& use,
                   const std::vector<SamplePoint>& points, Spirv spirv, bool hasBorders) {
  const auto found = noise.drawn(kValue, use, points, spirv);
  Differences values;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto expected = noise.value(points[k]);
    const auto rounded =
        noise.method == quilting ? roundedFetches(noise, points[k]) : DeviceNoise::Value{};
    for (std::size_t c = 0; c < 4; ++c)
      values.add(std::max(0.0f, std::abs(found[k][c] - expected[c]) - rounded[c]), 0.0);
  }
  check(values, hasBorders);
  if (noise.method == quilting || !spirv.empty())
    return;
  const auto decoded = noise.drawnGaussian(use, points);
  const std::size_t channels = noise.bundle.noises[0].maps[0].channels.size();
  Differences gaussians, losses;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [value, lost] = noise.gaussian(points[k]);
    gaussians.add(decoded[k].value, value, channels);
    losses.add(decoded[k].lost, lost, channels);
  }
  check(gaussians, hasBorders);
  check(losses, hasBorders);
}

void compare(const std::vector<Case>& cases) {
  const std::vector<SamplePoint> points = samplePoints(400);
  for (const Case& one : cases) {
    DeviceNoise noise(one.file, one.mapping, one.options);
    const std::vector<MaterialUse> uses = manyUses(noise.host.use(), one.tileRotation);
    const Noise& stored = noise.bundle.noises[0];
    const auto* shape = std::get_if<TextonShape>(&stored.data);
    const bool isConstant = shape != nullptr && shape->order == 0;
    const bool hasGradients =
        one.mapping == Mapping::uv && stored.maps[0].target == MapTarget::height;
    for (std::size_t u = 0; u < uses.size(); ++u) {
      INFO(one.name << ", " << nameOf(one.mapping) << ", " << nameOf(stored.maps[0].target)
                    << ", use " << u);
      compareValues(noise, uses[u], points, one.spirv, isConstant);
      if (hasGradients)
        compareGradients(noise, uses[u], points, isConstant || isMix(stored));
    }
  }
}

} // namespace

TEST_CASE("tiling draws on a device what it computes in C++: 99.9 % within 1/1024, all within "
          "1/255") {
  compare(tilingCases());
}

TEST_CASE("textons draw on a device what they compute in C++") { compare(textonCases()); }

TEST_CASE("cosines, kernels and quilting draw on a device what they compute in C++") {
  compare(bakedCases());
}

TEST_CASE("shaders without the code of an option leave it out, and those with it do not") {
  const std::vector<SamplePoint> points = samplePoints(500);
  const auto differing = [](const auto& a, const auto& b) {
    Differences differences;
    for (std::size_t k = 0; k < a.size(); ++k)
      differences.add(a[k], b[k], 1);
    return differences.fractionBeyond();
  };
  for (const auto& [mapping, without] :
       {std::pair<Mapping, Spirv>{Mapping::uv, tiling_evaluate_comp_no_rotation},
        {Mapping::triplanar, triplanar_evaluate_comp_no_rotation}}) {
    DeviceNoise noise(tilingFile({2, 64, 32, false, 3}), mapping);
    MaterialUse turned = noise.host.use();
    const auto plain = noise.drawn(kValue, turned, points);
    turned.parameters.tileRotation = 2;
    CHECK(differing(noise.drawn(kValue, turned, points, without), plain) == 0.0);
    CHECK(differing(noise.drawn(kValue, turned, points), plain) > 0.2);
  }
  DeviceNoise noise(tilingFile({3, 64, 64}));
  const MaterialUse own = noise.host.use();
  const auto whole = noise.drawn(kValue, own, points);
  for (const Spirv without :
       {Spirv(tiling_evaluate_comp_no_table), Spirv(tiling_evaluate_comp_nearest_level)})
    CHECK(differing(noise.drawn(kValue, own, points, without), whole) > 0.1);
}

TEST_CASE("a point far from the origin has the impacts of its tile, even if the number of cells "
          "overflows an int") {
  const BundleFile textons =
      syntheticTextonBundle({.texelsPerTileX = 16384, .texelsPerTileY = 16384, .channels = 1});
  const BundleFile kernels = baked({multipleKernels});
  for (const auto& [file, mapping, tile, period] :
       {std::tuple{&textons, Mapping::uv, 1 << 20, 0.0},
        {&textons, Mapping::uv, -(1 << 24), 2.0},
        {&textons, Mapping::surface, 1 << 24, 0.0},
        {&textons, Mapping::surface, -(1 << 27), 0.0},
        {&kernels, Mapping::surface, 1 << 20, 0.0},
        {&kernels, Mapping::surface, -(1 << 20), 0.0}}) {
    DeviceNoise noise(*file, mapping);
    MaterialUse near = noise.host.use();
    near.parameters.impacts = 1000.0; // of textons: 25,343 cells per tile of the plane
    near.placement.periodTiles[0] = near.placement.periodTiles[1] = period;
    MaterialUse far = near;
    const std::array<int, 3> place{tile, -tile, tile};
    std::ranges::copy(place, far.placement.tileOrigin);
    std::vector<SamplePoint> point(1);
    point[0].normal = {0.0f, 0.6f, 0.8f};
    point[0].tangent = {1.0f, 0.0f, 0.0f, 1.0f};
    const auto expected = noise.drawnGaussian(far, point);
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[0].position[axis] = float(place[axis]);
    point[0].plane.uv = {float(place[0]), float(place[1])};
    const auto found = noise.drawnGaussian(near, point);
    INFO(nameOf(noise.method) << ", " << nameOf(mapping) << ", tile " << tile);
    Differences onDevice, inCpp;
    onDevice.add(found[0].value, expected[0].value, 1);
    inCpp.add(noise.gaussian(point[0]).value, expected[0].value, 1);
    CHECK(onDevice.largest < 1e-5);
    CHECK(inCpp.largest < 1e-4);
  }
}

namespace {

struct Layered {
  std::vector<Method> methods; ///< by layer
  MapTarget target;
  Mapping mapping = Mapping::uv;
};

BundleFile layeredFile(const Layered& kind) {
  std::vector<Bundle> layers;
  std::vector<double> shares;
  for (std::size_t layer = 0; layer < kind.methods.size(); ++layer) {
    std::vector<MapTarget> targets{kind.target};
    if (kind.target != kColor)
      targets.push_back(kColor);
    layers.push_back(
        baked({.method = kind.methods[layer], .targets = targets, .exemplar = 5 + layer}).bundle);
    shares.push_back(0.8 / double(kind.methods.size()));
  }
  shares.pop_back();
  const Bundle index =
      examplePatches(kExemplarWidth, kExemplarHeight, kind.mapping == Mapping::solid, 16);
  BundleFile file = fileOf(layeredExample(layers, index, shares, 0.2));
  MaterialNoise& material = *file.bundle.materials[0];
  material.mapping = kind.mapping;
  material.seed = 77;
  material.scale = 0.8;
  material.offset = {0.25, 0.0};
  material.contrast = 1.2;
  return file;
}

/// The input layout of layered_evaluate.comp.
std::array<std::array<float, 4>, 6> layeredPoint(const SamplePoint& p) {
  const auto& [uv, dx, dy, unused] = p.plane;
  const auto rowOf = [](const std::array<float, 3>& v) {
    return std::array{v[0], v[1], v[2], 0.0f};
  };
  return {std::array{uv[0], uv[1], dx[0], dx[1]},
          {dy[0], dy[1], 0.0f, 0.0f},
          rowOf(p.position),
          rowOf(p.dx),
          rowOf(p.dy),
          rowOf(p.normal)};
}

NoiseEvaluator::Value valueAt(const NoiseEvaluator& noise, Mapping mapping, const SamplePoint& p) {
  if (mapping == Mapping::uv)
    return noise.evaluateUv(0, {p.plane.uv, p.plane.gradientX, p.plane.gradientY});
  return noise.evaluate(0, inSpace(mapping, p));
}

} // namespace

TEST_CASE("layered noises draw on a device what they compute in C++") {
  VulkanDevice* const device = sharedDevice();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.flags = LICHEN_VULKAN_LAYERS;
  PluginContext context(*device, info);
  const std::vector<SamplePoint> points = samplePoints(400);
  std::vector<std::array<std::array<float, 4>, 6>> inputs;
  std::ranges::transform(points, std::back_inserter(inputs), layeredPoint);
  const std::vector<std::uint32_t> four = committedShader("layered_evaluate.comp");
  const std::array<Spirv, 5> passes{
      {{}, {}, layered_evaluate_comp_two_layers, layered_evaluate_comp_three_layers, four}};
  // Few pipelines: lavapipe compiles each for 7 s.
  for (const Layered& kind :
       {Layered{{tiling, tiling}, MapTarget::occlusionRoughnessMetallic},
        Layered{{tiling, texton, multipleKernels}, kSlopes},
        Layered{{tiling, tiling, texton}, kSlopes, Mapping::triplanar},
        Layered{{localRandomPhase, multipleKernels, multipleKernels}, kSlopes, Mapping::solid},
        Layered{{texton, tiling, localRandomPhase, multipleKernels}, kColor}}) {
    INFO(kind.methods.size() << " layers, " << nameOf(kind.mapping));
    const std::vector<std::byte> glb = encodeGlb(layeredFile(kind)).value();
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(context, glb);
    MaterialUse use = host.use();
    Placement placement;
    use.placement.tileOrigin[0] = placement.tileOriginX = -(std::int64_t(1) << 40);
    use.placement.tileOrigin[1] = placement.tileOriginY = 1000001;
    const auto noise = NoiseEvaluator::create(bundle, *bundle.materials[0], placement).value();
    const auto values = host.evaluate(passes[kind.methods.size()], 0, use, inputs);
    Differences differences;
    for (std::size_t k = 0; k < points.size(); ++k)
      differences.add(values[k], valueAt(*noise, kind.mapping, points[k]), 4);
    differences.check();
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }
}

TEST_CASE("a set without the bindings or the range of layers is refused for a layered noise") {
  VulkanDevice* const device = sharedDevice();
  const std::vector<std::byte> glb = encodeGlb(layeredFile({{tiling, tiling}, kColor})).value();
  const std::shared_ptr<LichenBundle_T> bundle(parseOrThrow(glb), lichenDestroyBundle);
  for (const bool hasLayers : {false, true}) {
    LichenVulkanInfo info = defaultVulkanInfo(*device);
    info.flags = hasLayers ? LICHEN_VULKAN_LAYERS : 0;
    PluginContext context(*device, info);
    LichenVulkanAssets assets = nullptr;
    REQUIRE(lichenVulkanCreateAssets(context.context(), bundle.get(), &assets, nullptr) ==
            LICHEN_SUCCESS);
    const DescriptorPool pool = context.createPool(1);
    const VkDescriptorBufferInfo buffer{VK_NULL_HANDLE, 0, LICHEN_TRIPLANAR_MATERIAL_BYTES};
    VkDescriptorSet set = VK_NULL_HANDLE;
    LichenDiagnostic diagnostic;
    LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
    CHECK(lichenVulkanAllocateSet(assets, 0, pool.handle(), &buffer, &set, &diagnostic) ==
          LICHEN_ERROR_USAGE);
    CHECK(std::string(diagnostic.text) ==
          (hasLayers
               ? "material needs a buffer and a range of at least 1344 bytes; its range is 192"
               : "noise 0 is layered; create the context with the flag LICHEN_VULKAN_LAYERS"));
    lichenVulkanDestroyAssets(assets);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
