// SPDX-License-Identifier: MIT
// Solid noise in the shader, through the plugin, against the CPU twins; and these against oracles
// in double precision that sum the cosines of all vertices, or the impacts of all cells, around a
// point.
#include "../property/example_exemplar.h"
#include "../property/solid_twin.h"
#include "parity_errors.h"
#include "plugin_host.h"
#include "shared_device.h"
#include "slopes_of_color.h"

#include <lichen/bundle_writer.h>
#include <lichen/lattice.h>
#include <lichen/local_random_phase.h>
#include <lichen/local_random_phase_evaluate.h>
#include <lichen/multiple_kernels.h>
#include <lichen/multiple_kernels_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr const char* kPass = "solid_evaluate.comp";
/// The numbering of solid_evaluate.comp.
enum Quantity { kValue, kGaussian };

/// The input layout of solid_evaluate.comp.
struct SolidPoint {
  std::array<float, 4> position{}, gradientX{}, gradientY{};
};

constexpr int kWidth = 64, kHeight = 48;

template <class Bake>
std::vector<std::byte> glbOf(Result<Bake> bake) {
  REQUIRE(bake);
  BundleFile file;
  file.bundle.tables = std::move(bake.value().tables);
  file.bundle.noises = {std::move(bake.value().noise)};
  file.bundle.materials = {MaterialNoise()};
  file.bundle.materials[0]->mapping = Mapping::solid;
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  REQUIRE(glb);
  return std::move(glb).value();
}

/// Of 16 bits, as rounding of tables has a test of its own for all methods.
std::vector<std::byte> bakedGlb(Method method, bool isSlope, GaussianOnly gaussian) {
  MapExemplar map = threeMaterials(kWidth, kHeight, 5);
  if (isSlope)
    map = slopesOf(std::move(map));
  if (method == Method::multipleKernels) {
    MultipleKernelsOptions options;
    options.bits = 16;
    options.gaussian = gaussian;
    options.kernels = 6;
    return glbOf(bakeMultipleKernels("noise", {&map, 1}, options));
  }
  LocalRandomPhaseOptions options;
  options.bits = 16;
  options.cosines = 24;
  options.gaussian = gaussian;
  options.structure = 0.0;
  return glbOf(bakeLocalRandomPhase("noise", {&map, 1}, options));
}

/// Such a bundle with the last two kernels turned into rings.
Bundle withRings() {
  Bundle bundle =
      parseBundle(bakedGlb(Method::multipleKernels, false, GaussianOnly::no), "noise").value();
  Noise& noise = bundle.noises[0];
  Table& image = bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels];
  std::vector<KernelRow> rows = kernelRows(image, noise.as<MultipleKernelsNoise>());
  constexpr int kRings = 2;
  noise.as<MultipleKernelsNoise>().rings = kRings;
  for (std::size_t k = rows.size() - kRings; k < rows.size(); ++k) {
    rows[k].frequency = {std::hypot(rows[k].frequency[0], rows[k].frequency[1]), 0.0f};
    rows[k].toWindow = {rows[k].toWindow[3], 0.0f, 0.0f, rows[k].toWindow[3]};
  }
  image.texels = kernelTable(rows).texels;
  return bundle;
}

/// Points some tiles around the origin, a tenth of them on vertices and edges of the lattice.
/// Footprints range from a quarter of a texel to a tile, and are round to very long.
std::vector<SolidPoint> samplePoints(std::size_t count) {
  std::mt19937 generator(11u);
  std::uniform_real_distribution<float> tiles(-3.0f, 3.0f), level(-2.0f, 6.0f),
      stretch(0.0f, 14.0f);
  std::normal_distribution<float> gaussian;
  std::vector<SolidPoint> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    SolidPoint& point = points[k];
    const float length = std::exp2(level(generator)) / float(kWidth);
    const float other = length * std::exp2(-stretch(generator));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = k % 10 == 0 ? 0.0f : tiles(generator);
      point.gradientX[axis] = length * gaussian(generator);
      point.gradientY[axis] = other * gaussian(generator);
    }
    if (k % 20 == 0)
      point.position[k / 20 % 3] = tiles(generator);
  }
  return points;
}

/// Uses that together change every parameter.
std::vector<MaterialUse> manyUses(const MaterialUse& own) {
  std::vector<MaterialUse> all(3, own);
  all[1].parameters.scale = 0.8;
  all[1].parameters.rotation = 0.6;
  all[1].parameters.offset[0] = 0.25;
  all[1].parameters.offset[1] = -31.5;
  all[1].parameters.seed = 4294967295u;
  all[2].placement.tileOrigin[0] = -(std::int64_t(1) << 40);
  all[2].placement.tileOrigin[1] = (std::int64_t(1) << 40) - 1;
  all[2].placement.tileOrigin[2] = -77;
  all[2].parameters.contrast = 1.4;
  return all;
}

SolidFootprint footprintOf(const SolidPoint& point) {
  SolidFootprint at;
  std::copy_n(point.position.begin(), 3, at.position.begin());
  std::copy_n(point.gradientX.begin(), 3, at.dx.begin());
  std::copy_n(point.gradientY.begin(), 3, at.dy.begin());
  return at;
}

/// Local random phase, slowly. It takes the windows of all vertices of 7^3 cells, and shares only
/// the integer hashes with the code under test.
class Reference {
public:
  explicit Reference(const Bundle& bundle)
      : noise_(bundle.noises[0]), shared_(noise_.as<LocalRandomPhaseNoise>()),
        texels_(cosineTexels(
            decodeLevel(bundle.tables[noise_.maps[0].as<LocalRandomPhaseMap>().cosines], 0),
            CosineImageLayout(shared_))) {}

  /// The Gaussian value at a position in metres, of an unscaled noise and a point without a
  /// footprint.
  [[nodiscard]] std::array<double, 3> at(double x, double y, double z, std::uint32_t seed) const {
    std::array<double, 3> sum{0.5, 0.5, 0.5};
    std::size_t first = 0;
    for (std::size_t octave = 0; octave < shared_.cosines.size(); ++octave) {
      const auto count = std::size_t(shared_.cosines[octave]);
      addOctave(sum, {x, -kAspect * y, z}, octave, first, count, seed);
      first += count;
    }
    return sum;
  }

private:
  static constexpr double kAspect = double(kWidth) / kHeight;

  void addOctave(std::array<double, 3>& sum, const std::array<double, 3>& tile, std::size_t octave,
                 std::size_t first, std::size_t count, std::uint32_t seed) const {
    const double across = std::round(shared_.columns * 0.84) / 8.0 * std::exp2(double(octave));
    const double down =
        std::round(shared_.rows * std::sqrt(0.75) * 0.84) / 8.0 * std::exp2(double(octave));
    const std::array<double, 3> cubes{tile[0] * across, tile[1] * down, tile[2] * across};
    // A vertex (i, j, k) lies where the body-centred cubic lattice turned to the diagonal has it.
    const double third = (cubes[0] + cubes[1] + cubes[2]) / 3.0;
    std::array<std::int64_t, 3> near{};
    for (std::size_t k = 0; k < 3; ++k)
      near[k] = std::int64_t(std::floor(cubes[k] + third));
    const std::uint32_t octaveSeed = pcg(latticeSeed(seed, 4) + std::uint32_t(octave));
    std::array<double, 3> own{};
    double squares = 0.0;
    for (int n = 0; n < 7 * 7 * 7; ++n) {
      const std::array<std::int64_t, 3> vertex{near[0] + n % 7 - 3, near[1] + n / 7 % 7 - 3,
                                               near[2] + n / 49 - 3};
      const double sixth = double(vertex[0] + vertex[1] + vertex[2]) / 6.0;
      std::array<double, 3> offset{};
      double square = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        offset[k] = cubes[k] - (double(vertex[k]) - sixth);
        square += offset[k] * offset[k];
      }
      const double left = 1.0 - 2.0 * square;
      if (left <= 0.0)
        continue;
      const double window = left * left * left;
      squares += window * window;
      std::uint32_t state = vertexHash(std::uint32_t(vertex[0]), std::uint32_t(vertex[1]),
                                       pcg(octaveSeed + std::uint32_t(vertex[2])));
      const auto share = [](std::uint32_t bits) {
        return double(std::int32_t(bits)) / std::exp2(32.0);
      };
      std::uint32_t depth = state << 7;
      const std::size_t column = 1 + (state >> 27 & std::uint32_t(shared_.variants - 1));
      for (std::size_t k = first; k < first + count; ++k) {
        state = state * 747796405u + 2891336453u;
        const auto* row = &texels_[k / 2 * (1 + std::size_t(shared_.variants))];
        const CosineTexel &box = row[0][k % 2], &vector = row[column][k % 2];
        const double fx = double(box[0]) + double(box[2]) * share(state << 21);
        const double fy = double(box[1]) + double(box[3]) * share(state << 11);
        const double fz = 2.4 * std::hypot(fx, kAspect * fy) * share(depth);
        depth += 0x9E3779B9u;
        const double turns = fx * offset[0] / across + fy * offset[1] / down +
                             fz * offset[2] / across + share(state) + double(vector[3]);
        for (std::size_t c = 0; c < 3; ++c)
          own[c] += window * double(vector[c]) * std::cos(2.0 * std::numbers::pi * turns);
      }
    }
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += own[c] / std::sqrt(squares);
  }

  const Noise& noise_;
  const LocalRandomPhaseNoise& shared_;
  std::vector<std::array<CosineTexel, kRowCosines>> texels_;
};

/// Multiple kernels, slowly: the impacts of all cells within reach, at a position in metres. It
/// shares only the integer hashes with the code under test.
std::array<double, 3> sumOfImpacts(const Bundle& bundle, const std::array<double, 3>& metres,
                                   std::uint32_t seed) {
  constexpr double kAspect = double(kWidth) / kHeight;
  constexpr std::int64_t kReach = 20;
  const Noise& noise = bundle.noises[0];
  const auto& shared = noise.as<MultipleKernelsNoise>();
  const std::vector<KernelRow> rows =
      kernelRows(bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels], shared);
  const std::array<double, 3> tile{metres[0], -kAspect * metres[1], metres[2]};
  std::array<double, 3> sum{0.5, 0.5, 0.5};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KernelRow& row = rows[k];
    const std::array<double, 3> perTile{row.columns / 8.0, row.rows / 8.0, row.layers / 8.0};
    std::array<std::int64_t, 3> near{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      near[axis] = std::int64_t(std::floor(tile[axis] * perTile[axis]));
    // Planes of the window in space, 15 / 14 times as wide, have the spread of that in the plane.
    // Integrals of squared windows (1 - r^2)^3: pi / 7 in the plane, and in space
    // 2 pi B(3 / 2, 7).
    const double wider = std::sqrt(15.0 / 14.0);
    const double integrals = 14.0 * std::beta(1.5, 7.0);
    const double amplitude =
        double(row.amplitude) /
        std::sqrt(perTile[2] * integrals * std::pow(wider, 3.0) / double(row.toWindowZ));
    for (std::int64_t n = near[2] - kReach; n <= near[2] + kReach; ++n) {
      const std::uint32_t own = pcg(latticeSeed(seed, 4) + std::uint32_t(k));
      const std::uint32_t layerSeed = pcg(own + std::uint32_t(n));
      for (std::int64_t j = near[1] - kReach; j <= near[1] + kReach; ++j)
        for (std::int64_t i = near[0] - kReach; i <= near[0] + kReach; ++i) {
          const std::uint32_t word = vertexHash(std::uint32_t(i), std::uint32_t(j), layerSeed);
          const std::uint32_t other = pcg(~word);
          const double dx =
              tile[0] - (double(i) + (double(word >> 21) + 0.5) / 2048.0) / perTile[0];
          const double dy =
              tile[1] - (double(j) + (double(word >> 10 & 2047u) + 0.5) / 2048.0) / perTile[1];
          const double dz =
              tile[2] - (double(n) + (double(other >> 16) + 0.5) / 65536.0) / perTile[2];
          const double p = double(row.toWindow[0]) * dx + double(row.toWindow[1]) * dy;
          const double q = double(row.toWindow[2]) * dx + double(row.toWindow[3]) * dy;
          const double r = double(row.toWindowZ) * dz;
          const double left = std::max(0.0, 1.0 - (p * p + q * q + r * r) / (wider * wider));
          double fx = double(row.frequency[0]), fy = double(row.frequency[1]);
          if (int(k) >= shared.kernels - shared.rings) {
            const double angle =
                2.0 * std::numbers::pi *
                double(std::uint32_t(i) * 0xC13FA9A9u + std::uint32_t(j) * 0x91E10DA5u +
                       std::uint32_t(n) * 0xABC98389u + own) /
                std::exp2(32.0);
            fy = fx * std::sin(angle);
            fx *= std::cos(angle);
          }
          const double fz =
              1.2 * std::hypot(fx, kAspect * fy) * double(std::int16_t(other & 0xFFFFu)) / 32768.0;
          const double window = amplitude * left * left * left;
          const double angle = 2.0 * std::numbers::pi * (fx * dx + fy * dy + fz * dz);
          const auto signOf = [&](std::size_t bit) { return (word >> bit & 1u) != 0 ? -1.0 : 1.0; };
          for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t s = 0; s < 4; ++s)
              sum[c] += double(row.colors[c][s]) * window * signOf(s) * std::sqrt(2.0) *
                        std::cos(angle + signOf(4) * -std::numbers::pi / 4.0);
        }
    }
  }
  return sum;
}

} // namespace

TEST_CASE("the solid shader matches its CPU twin: 99.9 % within 1/1024 and all within 1/255") {
  struct Kind {
    Method method;
    bool isSlope;
    GaussianOnly gaussian;
  };
  for (const Kind& kind : {Kind{Method::localRandomPhase, false, GaussianOnly::no},
                           Kind{Method::localRandomPhase, false, GaussianOnly::yes},
                           Kind{Method::localRandomPhase, true, GaussianOnly::no},
                           Kind{Method::localRandomPhase, true, GaussianOnly::yes},
                           Kind{Method::multipleKernels, false, GaussianOnly::no},
                           Kind{Method::multipleKernels, true, GaussianOnly::no},
                           Kind{Method::multipleKernels, true, GaussianOnly::yes}}) {
    VulkanDevice* const device = sharedDevice();
    const std::vector<std::byte> glb = bakedGlb(kind.method, kind.isSlope, kind.gaussian);
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const SolidTwin twin(bundle);
    const std::vector<std::uint32_t> pass = committedShader(kPass);
    const std::vector<SolidPoint> points = samplePoints(1000);
    int number = 0;
    for (const MaterialUse& use : manyUses(host.use())) {
      const auto values = host.evaluate(pass, kValue, use, points);
      const auto gaussians = host.evaluate(pass, kGaussian, use, points);
      ParityErrors errors;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const SolidFootprint at = footprintOf(points[k]);
        errors.add(values[k], twin.evaluate(host.material(), at));
        errors.add(gaussians[k], twin.gaussian(host.material(), at));
      }
      INFO(nameOf(kind.method) << ", slopes " << kind.isSlope << ", table "
                               << (kind.gaussian == GaussianOnly::no) << ", use " << number++);
      errors.check();
    }
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }
}

TEST_CASE("solid noise is the sum of the cosines of all vertices under their windows") {
  const Bundle bundle =
      parseBundle(bakedGlb(Method::localRandomPhase, false, GaussianOnly::no), "noise").value();
  const LocalRandomPhaseEvaluator twin = LocalRandomPhaseEvaluator::create(bundle, 0).value();
  const Reference reference(bundle);
  std::mt19937 generator(3u);
  std::uniform_real_distribution<float> metres(-9.0f, 9.0f);
  for (const std::int64_t origin : {0, 21, -8}) {
    MaterialNoise material;
    material.mapping = Mapping::solid;
    material.seed = 7;
    Placement placement;
    placement.tileOriginX = origin;
    placement.tileOriginY = 3 * origin; // whole tiles of the exemplar, whose aspect is 4 / 3
    placement.tileOriginZ = -origin;
    const shader::LichenMaterial constants = shaderMaterial(bundle, material, placement).material;
    double largest = 0.0;
    for (int k = 0; k < 300; ++k) {
      const SolidFootprint at{{metres(generator), metres(generator), metres(generator)}, {}, {}};
      const auto value = twin.gaussian(0, constants, at);
      const auto expected = reference.at(double(at.position[0]) + double(origin),
                                         double(at.position[1]) + 3.0 * double(origin),
                                         double(at.position[2]) - double(origin), 7);
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(double(value[c]) - expected[c]));
    }
    INFO("origin " << origin);
    // As in the plane (local_random_phase_parity.cpp), at frequencies up to sqrt(3) times as high.
    CHECK(largest < 6e-4);
  }
}

TEST_CASE("solid noise of kernels is the sum over the impacts of all cells") {
  const Bundle bundle = withRings();
  const MultipleKernelsEvaluator twin = MultipleKernelsEvaluator::create(bundle, 0).value();
  std::mt19937 generator(3u);
  std::uniform_real_distribution<float> metres(-9.0f, 9.0f);
  for (const std::int64_t origin : {0, 21, -8}) {
    MaterialNoise material;
    material.mapping = Mapping::solid;
    material.seed = 7;
    Placement placement;
    placement.tileOriginX = origin;
    placement.tileOriginY = 3 * origin;
    placement.tileOriginZ = -origin;
    const shader::LichenMaterial constants = shaderMaterial(bundle, material, placement).material;
    for (int k = 0; k < 20; ++k) {
      const SolidFootprint at{{metres(generator), metres(generator), metres(generator)}, {}, {}};
      const auto value = twin.gaussian(0, constants, at);
      const auto expected = sumOfImpacts(bundle,
                                         {double(at.position[0]) + double(origin),
                                          double(at.position[1]) + 3.0 * double(origin),
                                          double(at.position[2]) - double(origin)},
                                         7);
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(double(value[c]) == Approx(expected[c]).margin(2e-3));
    }
  }
}
