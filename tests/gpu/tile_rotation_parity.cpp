// SPDX-License-Identifier: MIT
// Shaders of hosts that compile the rotation of tiles out, on texture coordinates and triplanar.
// tiling_parity.cpp compares rotated tiles with the oracle.
#include "plugin_host.h"
#include "shared_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>
#include <tiling_evaluate.comp.no_rotation.h>
#include <triplanar_evaluate.comp.no_rotation.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr float kTexels = 64.0f;

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

MaterialUse turned(MaterialUse use, std::uint32_t steps,
                   LichenMapping mapping = LICHEN_MAPPING_UV) {
  use.parameters.tileRotation = steps;
  use.parameters.mapping = mapping;
  return use;
}

/// Colours, and slopes of an exemplar that is not square.
constexpr std::array kMaps{SyntheticMap{3, 64, 64}, SyntheticMap{2, 64, 32, false, 3},
                           SyntheticMap{2, 64, 64, false, 3}};

} // namespace

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
    CHECK(differing(host.evaluate(without, 0, turned(own, 2), flat), plain) == 0.0);
    CHECK(differing(host.evaluate(whole, 0, turned(own, 1), flat), plain) == 0.0);
    CHECK(differing(host.evaluate(whole, 0, turned(own, 2), flat), plain) > 0.2);
    const auto wholeInThree = committedShader("triplanar_evaluate.comp");
    const auto inThree =
        host.evaluate(wholeInThree, 0, turned(own, 0, LICHEN_MAPPING_TRIPLANAR), points);
    CHECK(differing(host.evaluate(triplanar_evaluate_comp_no_rotation, 0,
                                  turned(own, 2, LICHEN_MAPPING_TRIPLANAR), points),
                    inThree) == 0.0);
    CHECK(
        differing(host.evaluate(wholeInThree, 0, turned(own, 2, LICHEN_MAPPING_TRIPLANAR), points),
                  inThree) > 0.2);
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
