// SPDX-License-Identifier: MIT
// Points, exemplars and materials with which shaders of noise in a plane are compared with their
// twins.
#pragma once

#include "../property/example_exemplar.h"
#include "parity_errors.h"
#include "plugin_host.h"

#include <lichen/bundle_writer.h>
#include <lichen/tile_footprint.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace lichen::test {

inline constexpr int kWidth = 64, kHeight = 48;

/// Colours, or the first of them as a height.
inline MapExemplar ofChannels(std::size_t channels) {
  MapExemplar map = threeMaterials(kWidth, kHeight, 5);
  if (channels == 3)
    return map;
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    map.values[i] = map.values[3 * i];
  map.values.resize(map.values.size() / 3);
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  return map;
}

inline std::vector<std::byte> glbOf(const BundleFile& file) {
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  REQUIRE(glb);
  return std::move(glb).value();
}

/// Points some tiles around the origin. Footprints range from a quarter of a texel to a tile.
inline std::vector<Point> samplePoints(std::size_t count) {
  std::mt19937 generator(11u);
  std::uniform_real_distribution<float> tiles(-3.0f, 3.0f), level(-2.0f, 6.0f),
      stretch(0.0f, 14.0f), angle(0.0f, 2.0f * std::numbers::pi_v<float>);
  std::vector<Point> points(count);
  for (Point& point : points) {
    point.uv = {tiles(generator), tiles(generator)};
    const float length = std::exp2(level(generator)) / float(kWidth);
    const float other = length * std::exp2(-stretch(generator)), turn = angle(generator);
    point.gradientX = {length * std::cos(turn), length * std::sin(turn)};
    point.gradientY = {-other * std::sin(turn), other * std::cos(turn)};
  }
  return points;
}

/// Uses that together change every parameter.
inline std::vector<MaterialUse> manyUses(const MaterialUse& own) {
  std::vector<MaterialUse> all(5, own);
  all[1] = moved(own);
  all[2].placement.tileOrigin[0] = -(std::int64_t(1) << 40) + 3;
  all[2].placement.tileOrigin[1] = (std::int64_t(1) << 40) - 5;
  all[2].parameters.contrast = 1.4;
  all[3].placement.periodTiles[0] = 2.0;
  all[3].placement.periodTiles[1] = 3.0;
  all[3].placement.tileOrigin[0] = -7;
  all[4].placement.periodTiles[0] = all[4].placement.periodTiles[1] = 1.37;
  return all;
}

inline TileFootprint footprintOf(const Point& point, const shader::LichenMaterial& m) {
  const auto toTile = [&](const std::array<float, 2>& v) {
    return std::array{m.uvToTileXX * v[0] + m.uvToTileXY * v[1],
                      m.uvToTileYX * v[0] + m.uvToTileYY * v[1]};
  };
  return {toTile(point.uv), toTile(point.gradientX), toTile(point.gradientY)};
}

/// Compares values and Gaussian values at these points under manyUses(). The pass numbers them 0
/// and 1; `twin` has the functions of LocalRandomPhaseEvaluator.
template <class Twin>
void checkPlaneParity(PluginHost& host, const Twin& twin, std::span<const std::uint32_t> pass,
                      const std::vector<Point>& points) {
  int number = 0;
  for (const MaterialUse& use : manyUses(host.use())) {
    const auto values = host.evaluate(pass, 0, use, points);
    const auto gaussians = host.evaluate(pass, 1, use, points);
    ParityErrors errors;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TileFootprint at = footprintOf(points[k], host.material());
      errors.add(values[k], twin.evaluate(0, host.material(), at));
      errors.add(gaussians[k], twin.gaussian(0, host.material(), at));
    }
    INFO("use " << number++);
    errors.check();
  }
}

} // namespace lichen::test
