// SPDX-License-Identifier: MIT
// Multiple-kernels noise in the shader, through the plugin, against the CPU twin; and the twin
// against an oracle in double precision that sums the impacts of all cells around a point.
#include "plane_parity.h"
#include "shared_device.h"

#include <lichen/lattice.h>
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

constexpr const char* kPass = "multiple_kernels_evaluate.comp";
/// The numbering of multiple_kernels_evaluate.comp.
enum Quantity { kValue, kGaussian, kGradient };

struct Kind {
  std::size_t channels;
  GaussianOnly gaussian;
  KernelWindow window;
  int rings = 0;   // so many of the kernels are turned into rings
  int cosines = 0; // of a pattern
};

/// Of 16 bits, as rounding of tables has a test of its own for all methods.
BundleFile bakedFile(const Kind& kind) {
  const MapExemplar map = ofChannels(kind.channels);
  MultipleKernelsOptions options;
  options.bits = 16;
  options.gaussian = kind.gaussian;
  options.window = kind.window;
  options.kernels = 6;
  if (kind.cosines > 0) {
    options.perturbation.emplace();
    options.perturbation->cosines = kind.cosines;
  }
  Result<MultipleKernelsBake> bake = bakeMultipleKernels("noise", {&map, 1}, options);
  REQUIRE(bake);
  BundleFile file;
  file.bundle.tables = std::move(bake.value().tables);
  file.bundle.noises = {std::move(bake.value().noise)};
  Noise& noise = file.bundle.noises[0];
  Table& image = file.bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels];
  std::vector<KernelRow> rows = kernelRows(image, noise.as<MultipleKernelsNoise>());
  const std::vector<PatternCosine> pattern =
      patternCosines(image, noise.as<MultipleKernelsNoise>());
  noise.as<MultipleKernelsNoise>().rings = kind.rings;
  for (std::size_t k = rows.size() - std::size_t(kind.rings); k < rows.size(); ++k) {
    rows[k].frequency = {std::hypot(rows[k].frequency[0], rows[k].frequency[1]), 0.0f};
    rows[k].toWindow = {rows[k].toWindow[3], 0.0f, 0.0f, rows[k].toWindow[3]};
  }
  const std::string name = image.name;
  image = kernelTable(rows, pattern);
  image.name = name;
  file.bundle.materials = {MaterialNoise()};
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  return file;
}

/// A slow evaluation: the impacts of all cells within the reach of each kernel's support, in double
/// precision. It shares only the integer hashes with the code under test.
std::array<double, 3> reference(const Bundle& bundle, double x, double y, std::uint32_t seed) {
  const Noise& noise = bundle.noises[0];
  const auto& shared = noise.as<MultipleKernelsNoise>();
  const std::vector<KernelRow> rows =
      kernelRows(bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels], shared);
  std::array<double, 3> sum{0.5, 0.5, 0.5};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KernelRow& row = rows[k];
    const std::uint32_t own = pcg(latticeSeed(seed, 0) + std::uint32_t(k));
    const double columns = row.columns / 8.0, rowsOfTile = row.rows / 8.0;
    const auto nearI = std::int64_t(std::floor(x * columns));
    const auto nearJ = std::int64_t(std::floor(y * rowsOfTile));
    constexpr std::int64_t kReach = 30;
    for (std::int64_t j = nearJ - kReach; j <= nearJ + kReach; ++j)
      for (std::int64_t i = nearI - kReach; i <= nearI + kReach; ++i) {
        const std::uint32_t word = vertexHash(std::uint32_t(i), std::uint32_t(j), own);
        const double dx = x - (double(i) + (double(word >> 21) + 0.5) / 2048.0) / columns;
        const double dy =
            y - (double(j) + (double(word >> 10 & 2047u) + 0.5) / 2048.0) / rowsOfTile;
        const double p = double(row.toWindow[0]) * dx + double(row.toWindow[1]) * dy;
        const double q = double(row.toWindow[2]) * dx + double(row.toWindow[3]) * dy;
        double fx = double(row.frequency[0]), fy = double(row.frequency[1]);
        if (int(k) >= shared.kernels - shared.rings) {
          const double angle =
              2.0 * std::numbers::pi *
              double(std::uint32_t(i) * 0xC13FA9A9u + std::uint32_t(j) * 0x91E10DA5u + own) /
              std::exp2(32.0);
          fy = fx * std::sin(angle);
          fx *= std::cos(angle);
        }
        const double left = std::max(0.0, 1.0 - p * p - q * q);
        const double window = double(row.amplitude) * left * left * left;
        const double angle = 2.0 * std::numbers::pi * (fx * dx + fy * dy);
        const auto signOf = [&](std::size_t bit) { return (word >> bit & 1u) != 0 ? -1.0 : 1.0; };
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t s = 0; s < 4; ++s)
            sum[c] += double(row.colors[c][s]) * window * signOf(s) * std::sqrt(2.0) *
                      std::cos(angle + signOf(4) * -std::numbers::pi / 4.0);
      }
  }
  for (const PatternCosine& cosine :
       patternCosines(bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels], shared)) {
    const double angle = 2.0 * std::numbers::pi *
                         (double(cosine.frequency[0]) * x + double(cosine.frequency[1]) * y);
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += double(cosine.waves[c][0]) * std::cos(angle) +
                double(cosine.waves[c][1]) * std::sin(angle);
  }
  return sum;
}

} // namespace

TEST_CASE("the multiple-kernels shader matches its CPU twin: 99.9 % within 1/1024, all within "
          "1/255") {
  for (const Kind& kind : {Kind{3, GaussianOnly::no, KernelWindow::gabor},
                           Kind{1, GaussianOnly::no, KernelWindow::sinc},
                           Kind{3, GaussianOnly::yes, KernelWindow::gaussianSinc},
                           Kind{1, GaussianOnly::no, KernelWindow::gabor, 2},
                           Kind{3, GaussianOnly::no, KernelWindow::gabor, 0, 7}}) {
    VulkanDevice* const device = sharedDevice();
    const std::vector<std::byte> glb = glbOf(bakedFile(kind));
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const MultipleKernelsEvaluator twin = MultipleKernelsEvaluator::create(bundle, 0).value();
    INFO("channels " << kind.channels << ", " << nameOf(kind.window) << ", rings " << kind.rings);
    checkPlaneParity(host, twin, committedShader(kPass), samplePoints(600));
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }
}

TEST_CASE("the gradient of kernels in the shader matches its CPU twin") {
  for (const Kind& kind : {Kind{1, GaussianOnly::no, KernelWindow::gabor, 1, 4},
                           Kind{1, GaussianOnly::yes, KernelWindow::sinc},
                           Kind{1, GaussianOnly::no, KernelWindow::gaussianSinc}}) {
    const std::vector<std::byte> glb = glbOf(bakedFile(kind));
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const MultipleKernelsEvaluator twin = MultipleKernelsEvaluator::create(bundle, 0).value();
    const std::vector<Point> points = samplePoints(300);
    for (const MaterialUse& use : manyUses(host.use())) {
      const auto found = host.evaluate(committedShader(kPass), kGradient, use, points);
      double squares = 0.0, differences = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const TileFootprint at = footprintOf(points[k], host.material());
        const auto expected = twin.gradient(0, host.material(), at);
        CHECK(double(found[k][0]) == Approx(double(expected[0])).margin(1.0 / 255.0));
        for (std::size_t axis = 1; axis < 3; ++axis) {
          squares += double(expected[axis]) * double(expected[axis]);
          const double difference = double(found[k][axis]) - double(expected[axis]);
          differences += difference * difference;
        }
      }
      // Differences within a table are rounded.
      CHECK(std::sqrt(differences / squares) < 0.01); // as of local random phase
    }
  }
}

TEST_CASE("multiple-kernels noise is the sum of its kernels over the impacts of all cells") {
  const Bundle bundle =
      parseBundle(glbOf(bakedFile({3, GaussianOnly::no, KernelWindow::gabor, 1, 4})), "noise")
          .value();
  const MultipleKernelsEvaluator twin = MultipleKernelsEvaluator::create(bundle, 0).value();
  std::mt19937 generator(3u);
  std::uniform_real_distribution<float> tiles(-9.0f, 9.0f);
  for (const std::int64_t origin : {0, 21, -8}) {
    Placement placement;
    placement.tileOriginX = origin;
    placement.tileOriginY = -origin;
    const shader::LichenMaterial material =
        shaderMaterial(bundle, MaterialNoise(), placement).material;
    for (int k = 0; k < 60; ++k) {
      const float x = tiles(generator), y = tiles(generator);
      const auto found = twin.gaussian(0, material, TileFootprint{{x, y}, {}, {}});
      const auto expected = reference(bundle, double(origin) + double(x),
                                      double(-origin) + double(y), MaterialNoise().seed);
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(double(found[c]) == Approx(expected[c]).margin(2e-3));
    }
  }
}
