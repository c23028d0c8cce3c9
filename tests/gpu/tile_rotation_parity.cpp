// SPDX-License-Identifier: MIT
// Rotated tiles in the shader combined with other options: fewer taps, triplanar mapping, and hosts
// that compile rotation out. tiling_parity.cpp compares them with the oracle.
#include "plugin_host.h"
#include "shared_device.h"
#include "synthetic_noise.h"

#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tiling_evaluate.comp.fewest_taps.h>
#include <tiling_evaluate.comp.no_rotation.h>
#include <triplanar_evaluate.comp.fewest_taps.h>
#include <triplanar_evaluate.comp.no_rotation.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr float kTexels = 64.0f;
constexpr TilingQuality kFewest{2, 1.0 / 128.0}; // the shaders are compiled with these values

/// The input layout of triplanar_evaluate.comp.
struct SpacePoint {
  std::array<float, 4> position{}, gradientX{}, gradientY{}, normal{};
};

std::vector<SpacePoint> samplePoints(std::size_t count) {
  std::mt19937 generator(23u);
  std::uniform_real_distribution<float> tiles(-6.0f, 6.0f), level(-3.0f, 6.0f);
  std::normal_distribution<float> gaussian;
  std::vector<SpacePoint> points(count);
  for (SpacePoint& point : points) {
    const float pixel = std::exp2(level(generator)) / kTexels;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = tiles(generator);
      point.normal[axis] = gaussian(generator);
      point.gradientX[axis] = pixel * gaussian(generator);
      point.gradientY[axis] = pixel * gaussian(generator);
    }
  }
  return points;
}

std::vector<Point> flattened(const std::vector<SpacePoint>& points) {
  std::vector<Point> flat;
  for (const SpacePoint& point : points)
    flat.push_back({{point.position[0], point.position[1]},
                    {point.gradientX[0], point.gradientX[1]},
                    {point.gradientY[0], point.gradientY[1]},
                    {}});
  return flat;
}

TileFootprint footprintOf(const Point& point) {
  return {point.uv, point.gradientX, point.gradientY};
}

TriplanarFootprint footprintOf(const SpacePoint& point) {
  const auto three = [](const std::array<float, 4>& v) { return std::array{v[0], v[1], v[2]}; };
  return {three(point.position), three(point.gradientX), three(point.gradientY),
          three(point.normal)};
}

MaterialUse turned(MaterialUse use, std::uint32_t steps,
                   LichenMapping mapping = LICHEN_MAPPING_UV) {
  use.parameters.tileRotation = steps;
  use.parameters.mapping = mapping;
  return use;
}

/// The fraction of values that differ by more than 1/1024, and the greatest difference.
struct Difference {
  void note(const std::array<float, 4>& found, const std::array<float, 4>& expected) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::abs(double(found[c]) - double(expected[c]));
      largest = std::max(largest, error);
      beyond += error > 1.0 / 1024.0 ? 1 : 0;
      ++count;
    }
  }
  double largest = 0.0;
  int beyond = 0, count = 0;
};

/// Colours, and slopes of an exemplar that is not square.
constexpr std::array kMaps{SyntheticMap{3, 64, 64}, SyntheticMap{2, 64, 32, false, 3},
                           SyntheticMap{2, 64, 64, false, 3}};

} // namespace

TEST_CASE("rotated tiles with fewer taps match the CPU twin, with uv and with triplanar mapping") {
  VulkanDevice* const device = sharedDevice();
  for (const SyntheticMap& map : kMaps) {
    const std::vector<std::byte> glb = syntheticGlb(std::span(&map, 1));
    const Bundle bundle = parseBundle(glb, "synthetic").value();
    const TilingEvaluator twin = TilingEvaluator::create(bundle, 0, kFewest).value();
    PluginHost host(sharedContext(), glb);
    const MaterialUse own = host.use();
    const std::vector<SpacePoint> points = samplePoints(1000);
    const std::vector<Point> flat = flattened(points);
    for (const std::uint32_t steps : {2u, 4u, 5u, 65536u}) {
      const auto inPlane =
          host.evaluate(tiling_evaluate_comp_fewest_taps, 0, turned(own, steps), flat);
      const shader::LichenMaterial plane = host.material();
      const auto inThree = host.evaluate(triplanar_evaluate_comp_fewest_taps, 0,
                                         turned(own, steps, LICHEN_MAPPING_TRIPLANAR), points);
      const shader::LichenTriplanarMaterial three = host.planes();
      Difference difference, differenceInThree;
      for (std::size_t k = 0; k < points.size(); ++k) {
        difference.note(inPlane[k], twin.evaluate(0, plane, footprintOf(flat[k])));
        differenceInThree.note(inThree[k], twin.evaluate(0, three, footprintOf(points[k])));
      }
      INFO("D = " << map.dimensions << ", " << map.height << " rows, steps " << steps);
      for (const Difference& one : {difference, differenceInThree}) {
        CHECK(one.largest <= 1.0 / 255.0);
        CHECK(one.beyond <= 0.001 * one.count);
      }
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}

TEST_CASE("a shader without the code of tile rotation does not rotate tiles, and one with it "
          "does") {
  VulkanDevice* const device = sharedDevice();
  for (const SyntheticMap& map : kMaps) {
    const std::vector<std::byte> glb = syntheticGlb(std::span(&map, 1));
    PluginHost host(sharedContext(), glb);
    const MaterialUse own = host.use();
    const std::vector<SpacePoint> points = samplePoints(500);
    const std::vector<Point> flat = flattened(points);
    const auto differing = [&](const auto& a, const auto& b) {
      int count = 0;
      for (std::size_t k = 0; k < a.size(); ++k)
        count += std::abs(a[k][0] - b[k][0]) > 1.0f / 255.0f ? 1 : 0;
      return double(count) / double(a.size());
    };
    const auto whole = committedShader("tiling_evaluate.comp");
    const std::span<const std::uint32_t> without = tiling_evaluate_comp_no_rotation;
    const auto plain = host.evaluate(whole, 0, turned(own, 0), flat);
    CHECK(differing(host.evaluate(without, 0, turned(own, 0), flat), plain) == 0.0);
    CHECK(differing(host.evaluate(without, 0, turned(own, 4), flat), plain) == 0.0);
    CHECK(differing(host.evaluate(whole, 0, turned(own, 1), flat), plain) == 0.0);
    CHECK(differing(host.evaluate(whole, 0, turned(own, 4), flat), plain) > 0.2);
    const auto wholeInThree = committedShader("triplanar_evaluate.comp");
    const auto inThree =
        host.evaluate(wholeInThree, 0, turned(own, 0, LICHEN_MAPPING_TRIPLANAR), points);
    CHECK(differing(host.evaluate(triplanar_evaluate_comp_no_rotation, 0,
                                  turned(own, 4, LICHEN_MAPPING_TRIPLANAR), points),
                    inThree) == 0.0);
    CHECK(
        differing(host.evaluate(wholeInThree, 0, turned(own, 4, LICHEN_MAPPING_TRIPLANAR), points),
                  inThree) > 0.2);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
