// SPDX-License-Identifier: MIT
// Triplanar noise in the shader, through the plugin, against the CPU twin. Tiling is also compared
// with a double-precision oracle that blends planes of the tiling oracle.
#include "../property/example_exemplar.h"
#include "plugin_host.h"
#include "shared_device.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/bundle_writer.h>
#include <lichen/local_random_phase.h>
#include <lichen/local_random_phase_evaluate.h>
#include <lichen/quilting.h>
#include <lichen/quilting_evaluate.h>
#include <lichen/texton_evaluate.h>
#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

/// The numbering of triplanar_evaluate.comp.
enum Quantity { kValue, kGaussian, kWeights };

/// The input layout of triplanar_evaluate.comp.
struct SpacePoint {
  std::array<float, 4> position{}; ///< w: the mix weight
  std::array<float, 4> gradientX{}, gradientY{}, normal{};
};

/// Points some tiles around the origin with any normal, a fifth of them along an axis or in a plane
/// of two axes. Footprints range from an eighth of a texel to a whole tile.
std::vector<SpacePoint> samplePoints(float sizeTexels, std::size_t count) {
  std::mt19937 generator(5u);
  std::uniform_real_distribution<float> tiles(-4.0f, 4.0f), level(-3.0f, 7.0f), weight(0.0f, 1.0f);
  std::normal_distribution<float> gaussian;
  std::vector<SpacePoint> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    SpacePoint& point = points[k];
    const float pixel = std::exp2(level(generator)) / sizeTexels;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = tiles(generator);
      point.normal[axis] = gaussian(generator);
      point.gradientX[axis] = pixel * gaussian(generator);
      point.gradientY[axis] = 0.5f * pixel * gaussian(generator);
    }
    if (k % 5 == 0)
      point.normal[k % 3] = 0.0f;
    if (k % 10 == 0)
      point.normal[(k + 1) % 3] = 0.0f;
    point.position[3] = weight(generator);
  }
  return points;
}

MaterialUse inPlanes(MaterialUse use) {
  use.parameters.mapping = LICHEN_MAPPING_TRIPLANAR;
  return use;
}

/// Uses that together change every parameter.
std::vector<MaterialUse> manyUses(const MaterialUse& own) {
  std::vector<MaterialUse> all(4, inPlanes(own));
  all[1].parameters.scale = 0.8;
  all[1].parameters.rotation = 0.6;
  all[1].parameters.offset[0] = 0.25;
  all[1].parameters.offset[1] = -7.5;
  all[1].parameters.seed = 4294967295u;
  all[1].parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  all[2].placement.tileOrigin[0] = -(std::int64_t(1) << 40);
  all[2].placement.tileOrigin[1] = 10000000;
  all[2].placement.tileOrigin[2] = -77;
  all[2].parameters.contrast = 1.4;
  all[2].parameters.planeSharpness = 2.0;
  all[3].parameters.blendSharpness = 3.0;
  all[3].parameters.planeSharpness = 64.0;
  // Two of them also rotate their tiles, the last by quarter turns.
  for (const std::size_t k : {1u, 2u}) {
    MaterialUse use = all[k];
    use.parameters.tileRotation = k == 2 ? 4 : 2;
    all.push_back(use);
  }
  return all;
}

TriplanarFootprint footprintOf(const SpacePoint& point) {
  TriplanarFootprint at;
  std::copy_n(point.position.begin(), 3, at.position.begin());
  std::copy_n(point.gradientX.begin(), 3, at.dx.begin());
  std::copy_n(point.gradientY.begin(), 3, at.dy.begin());
  std::copy_n(point.normal.begin(), 3, at.normal.begin());
  return at;
}

/// The format's steps in double precision, built on the oracle of one plane.
class TriplanarReference {
public:
  TriplanarReference(const Bundle& bundle, const shader::LichenTriplanarMaterial& material)
      : plane_(bundle), material_(material), noise_(shaderNoise(bundle, 0)),
        map_(shaderMap(bundle, bundle.noises[0], 0)) {}

  /// The Gaussian value and the lost variance; for slopes, their gradient and its lost variance.
  [[nodiscard]] std::array<double, 4> at(const SpacePoint& point) const {
    std::array<double, 3> weights{};
    double most = 0.0, squares = 0.0, length2 = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, std::abs(double(point.normal[k])));
      length2 += double(point.normal[k]) * double(point.normal[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = std::pow(std::abs(double(point.normal[k])) / most,
                                    double(material_.material.planeSharpness));
      weights[k] = std::max(0.0, share - 1.0 / 64.0);
      squares += weights[k] * weights[k];
    }
    const bool isSlope = map_.encoding == LICHEN_ENCODING_SLOPE;
    std::array<double, 4> sum{};
    if (!isSlope)
      sum = {0.5, 0.5, 0.5, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      if (weights[k] == 0.0)
        continue;
      const double weight = weights[k] / std::sqrt(squares);
      const TilingReference::Sample sample = sampleOf(point, k);
      if (isSlope) {
        addSlopes(sum, sample.value, weight, k);
        const double cosine2 = double(point.normal[k]) * double(point.normal[k]) / length2;
        sum[3] += weight * weight * sample.value[2] * (1.0 + cosine2) / 2.0;
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += weight * (sample.gaussian[c] - 0.5);
      sum[3] += weight * weight * sample.gaussian[3];
    }
    return sum;
  }

private:
  static std::array<float, 2> onto(const std::array<float, 4>& v, std::size_t axis) {
    const std::array<std::array<float, 2>, 3> all{{{-v[2], -v[1]}, {v[0], v[2]}, {v[0], -v[1]}}};
    return all[axis];
  }

  [[nodiscard]] TilingReference::Sample sampleOf(const SpacePoint& point, std::size_t axis) const {
    shader::LichenMaterial material = material_.material;
    if (axis > 0) {
      const shader::LichenPlane& own = axis == 1 ? material_.planeY : material_.planeZ;
      material.cellI = own.cellI;
      material.cellJ = own.cellJ;
      material.offsetX = own.offsetX;
      material.offsetY = own.offsetY;
      material.seedWord = own.seedWord;
    }
    // A tile is tileSizeMetres wide; its height is that over its aspect.
    material.uvToTileXX /= noise_.tileSizeMetres;
    material.uvToTileXY /= noise_.tileSizeMetres;
    material.uvToTileYX *= noise_.tileAspect / noise_.tileSizeMetres;
    material.uvToTileYY *= noise_.tileAspect / noise_.tileSizeMetres;
    return plane_.evaluate(
        {onto(point.position, axis), onto(point.gradientX, axis), onto(point.gradientY, axis), {}},
        material);
  }

  /// The rotation applies to the exemplar; its slopes are to the right and up.
  void addSlopes(std::array<double, 4>& sum, const std::array<double, 4>& slopes, double weight,
                 std::size_t axis) const {
    const double angle =
        std::atan2(double(material_.material.uvToTileXY), double(material_.material.uvToTileXX));
    const double right = std::cos(angle) * slopes[0] + std::sin(angle) * slopes[1];
    const double up = std::cos(angle) * slopes[1] - std::sin(angle) * slopes[0];
    const std::array<std::array<double, 3>, 3> all{
        {{0.0, up, -right}, {right, 0.0, -up}, {right, up, 0.0}}};
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] += weight * all[axis][k];
  }

  TilingReference plane_;
  shader::LichenTriplanarMaterial material_;
  shader::LichenNoise noise_;
  shader::LichenMap map_;
};

struct Difference {
  double largest = 0.0;
  double fractionBeyond = 0.0; ///< of values that differ by more than 1/1024

  template <class A, class B>
  void note(const std::vector<A>& values, const std::vector<B>& expected, std::size_t first,
            std::size_t last) {
    for (std::size_t k = 0; k < values.size(); ++k)
      for (std::size_t c = first; c < last; ++c) {
        const double error = std::abs(double(values[k][c]) - double(expected[k][c]));
        largest = std::max(largest, error);
        fractionBeyond += error > 1.0 / 1024.0 ? 1.0 / double((last - first) * values.size()) : 0.0;
      }
  }
};

/// A noise on a device.
struct OnDevice {
  explicit OnDevice(const std::vector<std::byte>& glb)
      : bundle(parseBundle(glb, "synthetic").value()), host(sharedContext(), glb) {}
  ~OnDevice() { CHECK(device->messages().texts() == std::vector<std::string>{}); }

  std::vector<std::array<float, 4>> shader(Quantity quantity, const MaterialUse& use,
                                           const std::vector<SpacePoint>& points) {
    static const std::vector<std::uint32_t> committed = committedShader("triplanar_evaluate.comp");
    return host.evaluate(committed, quantity, use, points);
  }

  VulkanDevice* device = sharedDevice();
  Bundle bundle;
  PluginHost host;
};

const std::vector<SyntheticMap> kMaps = {{3, 64, 64},
                                         {2, 64, 32, false, 3, SyntheticTable::joint, Grain::x},
                                         {1, 48, 80, false, 5, SyntheticTable::joint, Grain::y},
                                         {3, 64, 64, false, 0, SyntheticTable::none},
                                         {2, 64, 32, false, 0, SyntheticTable::none}};

} // namespace

TEST_CASE("triplanar tiling matches the CPU twin and the oracle: 99.9 % within 1/1024 and all "
          "within 1/255") {
  for (std::size_t m = 0; m < kMaps.size(); ++m) {
    const SyntheticMap& map = kMaps[m];
    OnDevice noise(syntheticGlb(std::span(&map, 1)));
    const TilingEvaluator twin = TilingEvaluator::create(noise.bundle, 0).value();
    const std::vector<SpacePoint> points = samplePoints(float(map.width), 500);
    // All uses with the first map, whose tiles are square, and one of the others with each other
    // map.
    const std::vector<MaterialUse> uses = manyUses(noise.host.use());
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (m > 0 && i != m % uses.size())
        continue;
      const MaterialUse& use = uses[i];
      const auto values = noise.shader(kValue, use, points);
      const auto gaussians = noise.shader(kGaussian, use, points);
      const TriplanarReference reference(noise.bundle, noise.host.planes());
      std::vector<std::array<float, 4>> twinValues, twinGaussians;
      std::vector<std::array<double, 4>> expected;
      for (const SpacePoint& point : points) {
        twinValues.push_back(twin.evaluate(0, noise.host.planes(), footprintOf(point)));
        twinGaussians.push_back(twin.gaussian(0, noise.host.planes(), footprintOf(point)));
        expected.push_back(reference.at(point));
      }
      const bool isSlope = noise.host.map().encoding == LICHEN_ENCODING_SLOPE;
      const auto channels = std::size_t(map.dimensions);
      Difference toTwin, toOracle;
      toTwin.note(values, twinValues, 0, isSlope ? 4 : 3);
      toTwin.note(gaussians, twinGaussians, 0, channels);
      toTwin.note(gaussians, twinGaussians, 3, 4);
      toOracle.note(isSlope ? values : gaussians, expected, 0, isSlope ? 3 : channels);
      toOracle.note(isSlope ? values : gaussians, expected, 3, 4);
      INFO("D = " << map.dimensions << ", table " << int(map.table) << ", use " << i);
      for (const Difference& difference : {toTwin, toOracle}) {
        CHECK(difference.largest <= 1.0 / 255.0);
        CHECK(difference.fractionBeyond <= 0.001);
      }
    }
  }
}

TEST_CASE("with any grain, a point in space has one value from every tile origin") {
  for (const Grain grain : {Grain::none, Grain::x, Grain::y}) {
    const SyntheticMap map{3, 64, 64, false, 5, SyntheticTable::joint, grain};
    const Bundle bundle = syntheticBundle(std::span(&map, 1)).bundle;
    const auto referenceAt = [&](const std::array<int, 3>& origin) {
      MaterialNoise material;
      material.mapping = Mapping::triplanar;
      Placement placement;
      placement.tileOriginX = origin[0];
      placement.tileOriginY = origin[1];
      placement.tileOriginZ = origin[2];
      return TriplanarReference(bundle, shaderMaterial(bundle, material, placement));
    };
    const TriplanarReference atZero = referenceAt({0, 0, 0});
    for (const std::array<int, 3>& origin : {std::array{1, 2, 3}, {4, -5, 6}, {-7, 0, 1001}}) {
      const TriplanarReference reference = referenceAt(origin);
      for (SpacePoint point : samplePoints(64.0f, 200)) {
        for (std::size_t axis = 0; axis < 3; ++axis) // exact in float, also 1,001 tiles away
          point.position[axis] = std::round(32.0f * point.position[axis]) / 32.0f;
        const auto there = reference.at(point);
        for (std::size_t axis = 0; axis < 3; ++axis)
          point.position[axis] += float(origin[axis]);
        const auto expected = atZero.at(point);
        INFO("grain " << int(grain));
        for (std::size_t c = 0; c < 4; ++c)
          REQUIRE(there[c] == Approx(expected[c]).margin(1e-9));
      }
    }
  }
}

TEST_CASE("triplanar textons match the CPU twin: 99.9 % within 1/1024 and all within 1/255") {
  const SyntheticTexton textons[] = {{},
                                     {.mipLevels = 2, .channels = 2},
                                     {.order = 3, .channels = 1},
                                     {.steps = 3, .channels = 1}};
  for (std::size_t t = 0; t < std::size(textons); ++t) {
    const SyntheticTexton& texton = textons[t];
    OnDevice noise(syntheticTextonGlb(texton));
    const TextonEvaluator twin = TextonEvaluator::create(noise.bundle, 0).value();
    const std::vector<SpacePoint> points = samplePoints(float(texton.texelsPerTileX), 250);
    const auto values = noise.shader(kValue, manyUses(noise.host.use())[t], points);
    std::vector<std::array<float, 4>> expected;
    for (const SpacePoint& point : points)
      expected.push_back(
          twin.evaluate(0, noise.host.planes(), footprintOf(point), {point.position[3], {}}));
    Difference difference;
    difference.note(values, expected, 0, 4);
    INFO("order " << texton.order << ", channels " << texton.channels << ", steps "
                  << texton.steps);
    CHECK(difference.largest <= 1.0 / 255.0);
    CHECK(difference.fractionBeyond <= 0.001);
  }
}

TEST_CASE("triplanar local random-phase noise matches the CPU twin: 99.9 % within 1/1024 and all "
          "within 1/255") {
  const MapExemplar map = threeMaterials(64, 48, 5);
  for (const double structure : {0.0, 0.7}) {
    LocalRandomPhaseOptions options;
    options.bits = 16;
    options.cosines = 24;
    options.structure = options.guide = structure;
    Result<LocalRandomPhaseBake> bake = bakeLocalRandomPhase("noise", {&map, 1}, options);
    REQUIRE(bake);
    BundleFile file;
    file.bundle.tables = std::move(bake.value().tables);
    file.bundle.noises = {std::move(bake.value().noise)};
    file.bundle.materials = {MaterialNoise()};
    file.previews.emplace_back();
    file.shape = PreviewShape::none;
    OnDevice noise(encodeGlb(file).value());
    const LocalRandomPhaseEvaluator twin =
        LocalRandomPhaseEvaluator::create(noise.bundle, 0).value();
    const std::vector<SpacePoint> points = samplePoints(64.0f, 500);
    std::vector<MaterialUse> uses = manyUses(noise.host.use());
    uses.resize(3); // of which the last has another tile origin in each plane
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const auto values = noise.shader(kValue, uses[i], points);
      std::vector<std::array<float, 4>> expected;
      for (const SpacePoint& point : points)
        expected.push_back(twin.evaluate(0, noise.host.planes(), footprintOf(point)));
      Difference difference;
      difference.note(values, expected, 0, 3);
      INFO("structure " << structure << ", use " << i);
      CHECK(difference.largest <= 1.0 / 255.0);
      CHECK(difference.fractionBeyond <= 0.001);
    }
  }
}

TEST_CASE("but for rounded fetches of cells triplanar quilting matches its CPU twin") {
  constexpr int kWidth = 64, kHeight = 48;
  const MapExemplar map = threeMaterials(kWidth, kHeight, 5);
  for (const double guide : {0.0, 1.0}) {
    QuiltingOptions options;
    options.bits = 16;
    options.guide = guide;
    Result<QuiltingBake> bake = bakeQuilting("noise", {&map, 1}, options);
    REQUIRE(bake);
    BundleFile file;
    file.bundle.tables = std::move(bake.value().tables);
    file.bundle.noises = {std::move(bake.value().noise)};
    file.bundle.materials = {MaterialNoise()};
    file.previews.emplace_back();
    file.shape = PreviewShape::none;
    OnDevice noise(encodeGlb(file).value());
    const QuiltingEvaluator twin = QuiltingEvaluator::create(noise.bundle, 0).value();
    const std::vector<SpacePoint> points = samplePoints(float(kWidth), 300);
    std::vector<MaterialUse> uses = manyUses(noise.host.use());
    uses.resize(4); // quilting does not rotate tiles
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const auto values = noise.shader(kValue, uses[i], points);
      const shader::LichenTriplanarMaterial& planes = noise.host.planes();
      Difference difference;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const TriplanarFootprint at = footprintOf(points[k]);
        const auto expected = twin.evaluate(0, planes, at);
        // As in quilting_parity.cpp: a sampler rounds the position of a fetch of cells to 1/256 of
        // their texel. Each plane has three.
        constexpr float kRounding = 1.0f / 512.0f, kFetches = 3.0f;
        const float texel =
            1.0f / (0.5f * float(kHeight) *
                    std::hypot(planes.material.uvToTileYX, planes.material.uvToTileYY));
        std::array<float, 4> allowed{};
        for (int beside = 0; beside < 27; ++beside) {
          TriplanarFootprint there = at;
          for (std::size_t axis = 0, rest = std::size_t(beside); axis < 3; ++axis, rest /= 3)
            there.position[axis] += (float(rest % 3) - 1.0f) * kRounding * texel;
          const auto value = twin.evaluate(0, planes, there);
          for (std::size_t c = 0; c < 4; ++c)
            allowed[c] = std::max(allowed[c], kFetches * std::abs(value[c] - expected[c]));
        }
        std::array<float, 4> excess{};
        for (std::size_t c = 0; c < 4; ++c)
          excess[c] = std::max(0.0f, std::abs(values[k][c] - expected[c]) - allowed[c]);
        difference.note(std::vector{excess}, std::vector{std::array<float, 4>{}}, 0, 4);
      }
      INFO("guide " << guide << ", use " << i);
      CHECK(difference.largest <= 1.0 / 255.0);
      CHECK(difference.fractionBeyond <= 0.001 * double(points.size()));
    }
  }
}

TEST_CASE("planes with a small weight are dropped, and the squares of the other weights sum to "
          "1") {
  OnDevice noise(syntheticGlb(std::span(kMaps.data(), 1)));
  const std::vector<SpacePoint> points = samplePoints(64.0f, 2000);
  for (const double sharpness : {1.0, 8.0, 64.0}) {
    MaterialUse use = inPlanes(noise.host.use());
    use.parameters.planeSharpness = sharpness;
    const auto weights = noise.shader(kWeights, use, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& n = points[k].normal;
      const float most = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
      double squares = 0.0;
      int counted = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        squares += double(weights[k][axis]) * double(weights[k][axis]);
        const double share = std::pow(double(std::abs(n[axis]) / most), sharpness);
        counted += share > 1.0 / 64.0 ? 1 : 0;
        // 64th powers of floats have an error of some 1e-5.
        if (std::abs(share * 64.0 - 1.0) > 1e-4)
          CHECK((weights[k][axis] > 0.0f) == (share > 1.0 / 64.0));
      }
      CHECK(squares == Approx(1.0).margin(1e-5));
      CHECK(int(weights[k][3]) == counted);
    }
  }
}
