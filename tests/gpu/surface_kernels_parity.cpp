// SPDX-License-Identifier: MIT
// Multiple-kernels noise on surfaces in the shader, through the plugin, against the CPU twin; and
// both against an oracle in double precision that sums the impacts of all cubes around a point.
#include "plane_parity.h"
#include "shared_device.h"
#include "slopes_of_color.h"
#include "surface_points.h"

#include <lichen/lattice.h>
#include <lichen/multiple_kernels.h>
#include <lichen/multiple_kernels_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr const char* kPass = "surface_evaluate.comp";
/// The numbering of surface_evaluate.comp.
enum Quantity { kValue, kGaussian, kImpacts, kLost };

struct Kind {
  KernelWindow window = KernelWindow::gabor;
  bool isSlope = false;
  int rings = 0; // so many of the kernels are turned into rings
};

std::vector<std::byte> bakedGlb(const Kind& kind) {
  MapExemplar map = threeMaterials(kWidth, kHeight, 5);
  if (kind.isSlope)
    map = slopesOf(std::move(map));
  MultipleKernelsOptions options;
  options.bits = 16;
  options.window = kind.window;
  options.kernels = 6;
  Result<MultipleKernelsBake> bake = bakeMultipleKernels("noise", {&map, 1}, options);
  REQUIRE(bake);
  BundleFile file;
  file.bundle.tables = std::move(bake.value().tables);
  file.bundle.noises = {std::move(bake.value().noise)};
  Noise& noise = file.bundle.noises[0];
  Table& image = file.bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels];
  std::vector<KernelRow> rows = kernelRows(image, noise.as<MultipleKernelsNoise>());
  noise.as<MultipleKernelsNoise>().rings = kind.rings;
  for (std::size_t k = rows.size() - std::size_t(kind.rings); k < rows.size(); ++k) {
    rows[k].frequency = {std::hypot(rows[k].frequency[0], rows[k].frequency[1]), 0.0f};
    const double scale = double(rows[k].toWindow[3]); // of a support of the area pi / scale^2
    rows[k].toWindow = {float(scale), 0.0f, 0.0f, float(scale)};
    rows[k].amplitude =
        float(scale * std::sqrt(7.0 * 64.0 / (std::numbers::pi * rows[k].columns * rows[k].rows)));
  }
  image.texels = kernelTable(rows).texels;
  file.bundle.materials = {MaterialNoise()};
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  return glbOf(file);
}

using Vec = std::array<double, 3>;

double product(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// A slow evaluation at a position in tile widths: all cubes within the reach of any support. It
/// shares only the integer hashes with the code under test.
Vec reference(const Bundle& bundle, const Vec& position, const SurfaceFrame& frame,
              std::uint32_t seed) {
  constexpr double kAspect = double(kWidth) / kHeight, kPi = std::numbers::pi;
  const Noise& noise = bundle.noises[0];
  const auto& shared = noise.as<MultipleKernelsNoise>();
  const std::vector<KernelRow> rows =
      kernelRows(bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels], shared);
  Vec sum{0.5, 0.5, 0.5};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KernelRow& row = rows[k];
    const std::uint32_t own = pcg(latticeSeed(seed, 3) + std::uint32_t(k));
    const double side = 8.0 / row.cubes;
    const Vec q{double(row.toWindow[0]), double(row.toWindow[1])},
        r{double(row.toWindow[2]), double(row.toWindow[3])};
    const double area = kPi / (std::abs(q[0] * r[1] - q[1] * r[0]) * kAspect);
    const double thickness = std::sqrt(area);
    // The integral of the squared window (1 - r^2)^3 over the disk is 1 / 7 of the area.
    const double amplitude = std::sqrt(3.0 * side * side * side * 7.0 / (thickness * area));
    std::array<std::int64_t, 3> near{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      near[axis] = std::int64_t(std::floor(position[axis] / side));
    constexpr std::int64_t kReach = 8;
    for (std::int64_t n = 0; n < std::int64_t(std::pow(2 * kReach + 1, 3)); ++n) {
      constexpr std::int64_t kAcross = 2 * kReach + 1;
      const std::array<std::int64_t, 3> cube{near[0] + n % kAcross - kReach,
                                             near[1] + n / kAcross % kAcross - kReach,
                                             near[2] + n / (kAcross * kAcross) - kReach};
      const std::array<std::uint32_t, 3> cell{std::uint32_t(cube[0]), std::uint32_t(cube[1]),
                                              std::uint32_t(cube[2])};
      const std::uint32_t word = pcg(pcg3d({cell[0], cell[1], own})[0] + cell[2]);
      Vec offset{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t bits = word >> (21 - 10 * axis) & 1023u;
        offset[axis] = position[axis] - side * (double(cube[axis]) + (double(bits) + 0.5) / 1024.0);
      }
      const double height = std::abs(product(offset, frame.outward));
      const double weight = std::max(0.0, 1.0 - 2.0 * height / thickness);
      const double dx = product(offset, frame.right);
      const double dy = kAspect * product(offset, frame.down);
      const double p = q[0] * dx + q[1] * dy, s = r[0] * dx + r[1] * dy;
      const double left = std::max(0.0, 1.0 - p * p - s * s);
      const std::uint32_t other = pcg(~word);
      double fx = double(row.frequency[0]), fy = double(row.frequency[1]);
      if (int(k) >= shared.kernels - shared.rings) {
        const double angle =
            2.0 * kPi *
            double(cell[0] * 0xC13FA9A9u + cell[1] * 0x91E10DA5u + cell[2] * 0xABC98389u + own) /
            std::exp2(32.0);
        fy = fx * std::sin(angle);
        fx *= std::cos(angle);
      }
      const double turns = fx * dx + fy * dy + ((other >> 4 & 1u) != 0 ? 0.125 : -0.125);
      const double wave = (word >> 31 != 0 ? -1.0 : 1.0) * amplitude * weight * left * left * left *
                          std::sqrt(2.0) * std::cos(2.0 * kPi * turns);
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t w = 0; w < 4; ++w)
          sum[c] += double(row.colors[c][w]) * ((other >> w & 1u) != 0 ? -wave : wave);
    }
  }
  return sum;
}

} // namespace

TEST_CASE("the shader of kernels on surfaces matches its CPU twin: 99.9 % within 1/1024, all "
          "within 1/255") {
  for (const Kind& kind : {Kind{}, Kind{.rings = 2}, Kind{.window = KernelWindow::sinc},
                           Kind{.window = KernelWindow::gaussianSinc, .isSlope = true}}) {
    VulkanDevice* const device = sharedDevice();
    const std::vector<std::byte> glb = bakedGlb(kind);
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const MultipleKernelsEvaluator twin = MultipleKernelsEvaluator::create(bundle, 0).value();
    const std::vector<std::uint32_t> pass = committedShader(kPass);
    std::vector<SurfacePoint> points = surfacePoints(kWidth, 400);
    for (SurfacePoint& point : points)
      point.position[3] = 0.0f; // no mix
    int number = 0;
    for (const MaterialUse& use : surfaceUses(host.use())) {
      const auto values = host.evaluate(pass, kValue, use, points);
      const auto gaussians = host.evaluate(pass, kGaussian, use, points);
      const auto lost = host.evaluate(pass, kLost, use, points);
      ParityErrors ofValues, ofGaussians, ofLost;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const SurfaceFootprint at = footprintOf(points[k]);
        const auto gaussian = twin.gaussian(0, host.material(), at);
        ofValues.add(values[k], twin.evaluate(0, host.material(), at));
        for (std::size_t c = 0; c < 3; ++c)
          ofGaussians.add(double(gaussians[k][c]) - double(gaussian[c]));
        ofLost.add(double(lost[k][0]) - double(gaussian[3]));
      }
      INFO(nameOf(kind.window) << (kind.isSlope ? ", slopes" : "") << ", rings " << kind.rings
                               << ", use " << number++);
      ofValues.check();
      ofGaussians.check();
      ofLost.check();
    }
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }
}

TEST_CASE("kernels on surfaces match the oracle, which sums over all impacts") {
  for (const int rings : {0, 2}) {
    const std::vector<std::byte> glb = bakedGlb({.rings = rings});
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const MultipleKernelsEvaluator twin = MultipleKernelsEvaluator::create(bundle, 0).value();
    MaterialUse use = onSurface(host.use());
    use.parameters.rotation = 0.4;
    use.parameters.seed = 77;
    use.placement.tileOrigin[0] = 12;
    use.placement.tileOrigin[1] = -5;
    use.placement.tileOrigin[2] = 3;
    std::vector<SurfacePoint> points = surfacePoints(kWidth, 40);
    for (SurfacePoint& point : points) {
      point.position[3] = 0.0f;
      point.gradientX = point.gradientY = {};
    }
    const auto values = host.evaluate(committedShader(kPass), kGaussian, use, points);
    double largest = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      Vec position{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        position[axis] = double(points[k].position[axis]) + double(use.placement.tileOrigin[axis]);
      const Vec expected =
          reference(bundle, position, frameOf(points[k], use.parameters.rotation), 77);
      const auto found = twin.gaussian(0, host.material(), footprintOf(points[k]));
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max({largest, std::abs(double(values[k][c]) - expected[c]),
                            std::abs(double(found[c]) - expected[c])});
    }
    INFO("rings " << rings << ", largest " << largest);
    // Places of 8 tiles are rounded to 2^-21 tiles, waves of 30 cycles to 1e-4 turns.
    CHECK(largest < 1e-3);
  }
}

TEST_CASE("kernels on surfaces lie where the tile is, however far from the origin") {
  const std::vector<std::byte> glb = bakedGlb({});
  PluginHost host(sharedContext(), glb);
  MaterialUse near = onSurface(host.use());
  for (const std::int64_t tile : {std::int64_t(1) << 20, -(std::int64_t(1) << 20)}) {
    MaterialUse far = near;
    far.placement.tileOrigin[0] = tile;
    far.placement.tileOrigin[1] = 3 - tile;
    far.placement.tileOrigin[2] = tile + 5;
    std::vector<SurfacePoint> point(1);
    point[0].normal = {0.0f, 0.6f, 0.8f, 0.0f};
    point[0].tangent = {1.0f, 0.0f, 0.0f, 1.0f};
    const auto expected = host.evaluate(committedShader(kPass), kGaussian, far, point);
    point[0].position = {float(tile), float(3 - tile), float(tile + 5), 0.0f};
    const auto found = host.evaluate(committedShader(kPass), kGaussian, near, point);
    INFO("tile " << tile);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(double(found[0][c]) == Approx(double(expected[0][c])).margin(1e-5));
  }
}
