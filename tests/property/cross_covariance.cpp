// SPDX-License-Identifier: MIT
// Which maps of a set are corrected towards the others, and what the correction preserves.
#include "example_exemplar.h"

#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <gaussian/cross_covariance.h>
#include <gaussian/map_fit.h>
#include <numeric>
#include <transport/random.h>
#include <transport/rank_matching.h>

using namespace lichen;
using namespace lichen::gaussian;

namespace {

constexpr int kSide = 64;

/// A colour map of three materials, and a roughness map of few values that follows its red.
std::vector<MapExemplar> roughSet() {
  constexpr double kStep = 0.05;
  const MapExemplar color = test::threeMaterials(kSide, kSide, 5);
  MapExemplar rough;
  rough.target = MapTarget::occlusionRoughnessMetallic;
  rough.channels = {MapChannel::roughness};
  rough.encoding = ValueEncoding::linear;
  rough.width = rough.height = kSide;
  rough.quantum = kStep;
  for (std::size_t i = 0; i < color.values.size() / 3; ++i) {
    const double grain = transport::randomUniform(9, i) - 0.5;
    const double value = 0.5 + 0.2 * double(color.values[3 * i]) + 0.2 * grain;
    rough.values.push_back(float(kStep * std::round(value / kStep)));
  }
  return {color, rough};
}

/// The colour map, and a slope map that is its green and blue plus noise.
std::vector<MapExemplar> slopeSet() {
  const MapExemplar color = test::threeMaterials(kSide, kSide, 5);
  MapExemplar slopes = color;
  slopes.target = MapTarget::normal;
  slopes.channels = {MapChannel::slopeX, MapChannel::slopeY};
  slopes.encoding = ValueEncoding::slope;
  slopes.values.clear();
  for (std::size_t i = 0; i < color.values.size() / 3; ++i)
    for (std::size_t c = 1; c < 3; ++c)
      slopes.values.push_back(color.values[3 * i + c] - 0.5f +
                              0.3f * (float(transport::randomUniform(c, i)) - 0.5f));
  return {color, slopes};
}

MethodBake baked(std::span<const MapExemplar> maps, const TilingOptions& options) {
  Result<MethodBake> bake = bakeTiling("set", maps, options);
  REQUIRE(bake);
  return std::move(bake).value();
}

/// Returns the texels of the last map's Gaussian image. The map is baked after the first, or alone.
std::vector<std::byte> lastImage(std::span<const MapExemplar> maps, const TilingOptions& options) {
  const MethodBake bake = baked(maps, options);
  return bake.tables[bake.noise.maps.back().as<TilingMap>().gaussian].texels;
}

} // namespace

TEST_CASE("only maps with a joint table are corrected, and only towards such maps") {
  const std::vector<MapExemplar> maps = roughSet();
  const std::span<const MapExemplar> alone(&maps[1], 1);
  TilingOptions options;
  CHECK(lastImage(maps, options) != lastImage(alone, options));
  options.gaussian = GaussianOnly::yes;
  CHECK(lastImage(maps, options) == lastImage(alone, options));
}

TEST_CASE("missing covariances are negligible by their root mean square, whatever the number of "
          "entries") {
  for (const auto [rows, columns] : {std::array{1, 1}, std::array{3, 2}, std::array{6, 3}}) {
    const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(rows, columns);
    CHECK(isNegligible(2.9e-4 * ones)); // the standard error of blends is 3e-4
    CHECK_FALSE(isNegligible(3.1e-4 * ones));
  }
}

TEST_CASE("slopes follow the colours by small permutations of the same Gaussian points") {
  const std::vector<MapExemplar> maps = slopeSet();
  const exemplar::ColorSpace colors = exemplar::colorSpaceOf(maps[0]),
                             slopes = exemplar::colorSpaceOf(maps[1]);
  REQUIRE(slopes.dimensions() == 2);
  MapFitOptions options;
  options.share = 0.0f;
  const MapFit color = fitMap(maps[0], colors, options);
  const std::vector<SettledMap> settled{{maps[0], colors, color.gaussian, color.table}};
  const std::vector<Point> alone = fitMap(maps[1], slopes, options).gaussian.matched;
  options.settled = settled;
  const std::vector<Point> joined = fitMap(maps[1], slopes, options).gaussian.matched;
  double squares = 0.0;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const Point d{joined[i].x - alone[i].x, joined[i].y - alone[i].y, 0.0f};
    squares += double(dot(d, d)) / double(2 * alone.size());
  }
  CHECK(squares > 0.0);
  // A tenth of a deviation, and what the second matching adds: about the distance of neighbours,
  // sqrt(2 pi) / kSide deviations.
  CHECK(std::sqrt(squares) < (0.1 + 2.51 / kSide) * gaussian::kGaussianDeviation);
  const auto sorted = [](std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
      return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    return points;
  };
  const std::vector<Point> before = sorted(alone), after = sorted(joined);
  CHECK(std::equal(before.begin(), before.end(), after.begin(), after.end(),
                   [](const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }));
}

TEST_CASE("pixels are sorted by value, and pixels of equal value by score") {
  const std::size_t count = 1000;
  std::vector<float> values(count), scores(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = float(std::floor(8.0 * transport::randomUniform(1, i)) - 4.0);
    scores[i] = float(std::round(40.0 * transport::randomUniform(2, i)) - 20.0);
    if (i % 7 == 0 && values[i] == 0.0f)
      values[i] = -0.0f; // equal to 0
  }
  std::vector<std::uint32_t> expected(count);
  std::iota(expected.begin(), expected.end(), 0u);
  std::stable_sort(expected.begin(), expected.end(), [&](std::size_t a, std::size_t b) {
    return values[a] != values[b] ? values[a] < values[b] : scores[a] < scores[b];
  });
  CHECK(transport::TieOrder(values).by(scores) == expected);
}
