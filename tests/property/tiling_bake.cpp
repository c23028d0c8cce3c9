// SPDX-License-Identifier: MIT
// A whole bake: tables of the right dimensions, identical for any number of threads, or an error.
#include "example_exemplar.h"

#include <lichen/image.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gaussian/prefilter.h>
#include <limits>

using namespace lichen;
using namespace lichen::gaussian;

namespace {

/// A colour's table with all its mip levels, by TARGETS.md.
constexpr std::size_t kMostTableBytes = 160 * 1024;

std::array<std::uint32_t, 3> sidesOf(const Table& table) {
  return {table.width, table.height, table.depth};
}

} // namespace

TEST_CASE("inputs that span fewer dimensions are baked in those") {
  const auto bake = [](const MapExemplar& map) {
    Result<MethodBake> result = bakeTiling("x", {&map, 1}, TilingOptions{});
    REQUIRE(result);
    return std::move(result).value();
  };
  MapExemplar map = test::threeMaterials(64, 64, 8);
  SECTION("grey stored as RGB has one Gaussian channel and a table of 256 colours") {
    for (std::size_t i = 0; i < map.values.size(); ++i)
      map.values[i] = map.values[i - i % 3];
    const MethodBake b = bake(map);
    CHECK(b.noise.maps[0].as<TilingMap>().dimensions == 1);
    CHECK(b.tables[0].format == TexelFormat::rg8Unorm);
    CHECK(sidesOf(b.tables[1]) == std::array{256u, 1u, 1u});
    const std::vector<float> texels = decodeLevel(b.tables[1], 0);
    for (std::size_t i = 0; i < texels.size(); i += 4) { // stays grey
      REQUIRE(texels[i] == texels[i + 1]);
      REQUIRE(texels[i] == texels[i + 2]);
    }
    for (std::size_t i = 4; i < std::size_t(256 * 4); i += 4) // brighter, to one code
      REQUIRE(texels[i] >= texels[i - 4] - 2.0f / 255.0f);
    CHECK(texels[std::size_t(255 * 4)] > texels[0] + 0.1f);
  }
  SECTION("two colours lie on a line") {
    for (std::size_t i = 0; i < map.values.size(); i += 3) {
      const bool first = map.values[i] > 0.5f;
      map.values[i] = first ? 0.8f : 0.1f;
      map.values[i + 1] = first ? 0.4f : 0.3f;
      map.values[i + 2] = first ? 0.2f : 0.9f;
    }
    CHECK(bake(map).noise.maps[0].as<TilingMap>().dimensions == 1);
  }
  SECTION("colours on a slanted line, rounded to 8 bits, still lie on a line") {
    for (std::size_t i = 0; i < map.values.size(); i += 3)
      for (std::size_t c = 1; c < 3; ++c)
        map.values[i + c] = std::round(255.0f * (c == 1 ? 0.7f : 0.4f) * map.values[i]) / 255.0f;
    CHECK(bake(map).noise.maps[0].as<TilingMap>().dimensions == 1);
  }
  SECTION("colours in a plane have two Gaussian channels") {
    for (std::size_t i = 0; i < map.values.size(); i += 3)
      map.values[i + 2] = 0.5f * map.values[i] + 0.25f * map.values[i + 1];
    const MethodBake b = bake(map);
    CHECK(b.noise.maps[0].as<TilingMap>().dimensions == 2);
    CHECK(b.tables[0].format == TexelFormat::rgba8Unorm);
    CHECK(sidesOf(b.tables[1]) == std::array{64u, 64u, 1u});
    CHECK(b.tables[1].texels.size() <= kMostTableBytes);
  }
  SECTION("colours in space have three Gaussian channels") {
    const MethodBake b = bake(map);
    CHECK(b.noise.maps[0].as<TilingMap>().dimensions == 3);
    CHECK(b.tables[0].format == TexelFormat::rgba8Unorm);
    CHECK(sidesOf(b.tables[1]) == std::array{32u, 32u, 32u});
    CHECK(b.tables[1].mipLevels == std::uint32_t(kTableLevels));
    CHECK(b.tables[1].texels.size() <= kMostTableBytes);
  }
  SECTION("one colour gives one colour") {
    std::fill(map.values.begin(), map.values.end(), 0.5f);
    const MethodBake b = bake(map);
    const std::vector<float> texels = decodeLevel(b.tables[1], 0);
    for (std::size_t i = 0; i < texels.size(); i += 4)
      REQUIRE(texels[i] == Approx(std::sqrt(srgbToLinear(0.5f))).margin(0.5 / 255.0));
  }
  SECTION("a single pixel and a single row are valid") {
    CHECK(bake(test::cropped(map, 3, 3, 1, 1)).noise.maps.size() == 1);
    CHECK(bake(test::cropped(map, 0, 3, 64, 1)).noise.maps.size() == 1);
  }
}

TEST_CASE("the bake of a set does not depend on the number of threads", "[large]") {
  // Maps of three, two, two and one dimensions; the last has another size. In two dimensions points
  // move to follow the maps before; on a line, ties are exchanged.
  const MapExemplar color = test::threeMaterials(64, 64, 22);
  MapExemplar normal = color;
  normal.target = MapTarget::normal;
  normal.channels = {MapChannel::slopeX, MapChannel::slopeY};
  normal.encoding = ValueEncoding::slope;
  normal.values.clear();
  for (std::size_t i = 0; i < color.values.size(); ++i)
    if (i % 3 != 0)
      normal.values.push_back(color.values[i] * color.values[i - i % 3]);
  MapExemplar orm = normal;
  orm.target = MapTarget::occlusionRoughnessMetallic;
  orm.channels = {MapChannel::occlusion, MapChannel::roughness};
  orm.encoding = ValueEncoding::linear;
  std::reverse(orm.values.begin(), orm.values.end());
  const MapExemplar small = test::cropped(color, 0, 0, 40, 48);
  MapExemplar height = small;
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.encoding = ValueEncoding::linear;
  height.quantum = 0.05; // ties
  height.values.clear();
  for (std::size_t i = 0; i < small.values.size(); i += 3)
    height.values.push_back(
        float(height.quantum * std::round(double(small.values[i]) / height.quantum)));
  const std::array maps{color, normal, orm, height};
  const auto bakeWith = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    TilingOptions options;
    options.periodic = Periodic::yes;
    Result<MethodBake> result = bakeTiling("set", maps, options);
    REQUIRE(result);
    return std::move(result).value();
  };
  const MethodBake one = bakeWith(1), many = bakeWith(4);
  REQUIRE(one.tables.size() == 2 * maps.size());
  REQUIRE(one.tables.size() == many.tables.size());
  for (std::size_t t = 0; t < one.tables.size(); ++t) {
    INFO(one.tables[t].name);
    CHECK(one.tables[t].texels == many.tables[t].texels);
  }
}

TEST_CASE("one map that does not tile makes the bake blend the whole set") {
  const auto red = [](MapExemplar map) { // a table of one axis is the fastest
    for (std::size_t i = 0; i < map.values.size() / 3; ++i)
      map.values[i] = map.values[3 * i];
    map.values.resize(map.values.size() / 3);
    map.channels = {MapChannel::red};
    return map;
  };
  const MapExemplar whole = red(test::threeMaterials(64, 64, 1));
  const MapExemplar crop = red(test::cropped(test::threeMaterials(128, 128, 2), 9, 5, 64, 64));
  TilingOptions options;
  const auto wasPeriodic = [&](const std::vector<MapExemplar>& maps) {
    const Result<MethodBake> bake = bakeTiling("x", maps, options);
    REQUIRE(bake);
    return bake.value().figures.bordersWereKept;
  };
  CHECK(wasPeriodic({whole}));
  CHECK_FALSE(wasPeriodic({whole, crop}));
  CHECK_FALSE(wasPeriodic({crop, whole}));
  options.periodic = Periodic::yes;
  CHECK(wasPeriodic({crop}));
}

TEST_CASE("options and maps out of range are errors") {
  const MapExemplar map = test::threeMaterials(8, 8, 1, 1);
  TilingOptions options;
  options.bits = 9;
  const Result<MethodBake> result = bakeTiling("x", {&map, 1}, options);
  REQUIRE_FALSE(result);
  CHECK(result.error().kind == ErrorKind::usage);
  CHECK_FALSE(bakeTiling("x", {}, TilingOptions{}));
  const auto refused = [](const MapExemplar& given, const TilingOptions& with) {
    const Result<MethodBake> bake = bakeTiling("x", {&given, 1}, with);
    return !bake && bake.error().kind == ErrorKind::usage;
  };
  MapExemplar broken = map;
  broken.values.pop_back();
  CHECK(refused(broken, TilingOptions{}));
  broken = map;
  broken.values[7] = std::nanf("");
  CHECK(refused(broken, TilingOptions{}));
  broken = map;
  broken.channels.clear();
  CHECK(refused(broken, TilingOptions{}));
  broken.channels.assign(4, MapChannel::red);
  broken.values.resize(std::size_t(8 * 8 * 4), 0.5f);
  CHECK(refused(broken, TilingOptions{}));
  for (const auto& [width, height] :
       {std::pair{0, 8}, {8, 0}, {-8, 8}, {16385, 1}, {1, 16385}, {1 << 30, 1 << 30}}) {
    broken = map;
    broken.width = width;
    broken.height = height;
    if (std::max(width, height) == 16385)
      broken.values.resize(std::size_t(16385 * 3), 0.5f);
    INFO(width << " x " << height);
    CHECK(refused(broken, TilingOptions{}));
  }
  broken = map;
  broken.quantum = 0.0;
  CHECK(refused(broken, TilingOptions{}));
}

TEST_CASE("the error for values beyond the tables has value and range, and values up to it can be "
          "baked") {
  MapExemplar map = test::threeMaterials(8, 8, 1, 1);
  const auto bakeWith = [&map](ValueEncoding encoding, float value) {
    map.encoding = encoding;
    map.values[7] = value;
    return bakeTiling("x", {&map, 1}, TilingOptions{});
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kLargest = std::numeric_limits<float>::max();
  using enum ValueEncoding;
  for (const ValueEncoding encoding : {srgb, linear, slope, log2})
    for (const float value : {kInfinity, -kInfinity, kLargest, -kLargest, std::nanf("")}) {
      const Result<MethodBake> bake = bakeWith(encoding, value);
      REQUIRE_FALSE(bake);
      CHECK(bake.error().kind == ErrorKind::usage);
    }
  CHECK(bakeWith(log2, 17.0f).error().message ==
        "a map with the value 17, which stands for 131071; expected both from -65504 to 65504");
  CHECK_FALSE(bakeWith(srgb, 200.0f)); // light of 229,000
  CHECK_FALSE(bakeWith(linear, 65536.0f));
  for (const auto& [encoding, value] : {std::pair{srgb, linearToSrgb(kHalfMax)},
                                        {linear, kHalfMax},
                                        {slope, -kHalfMax},
                                        {log2, std::log2(1.0f + kHalfMax)}}) {
    const Result<MethodBake> bake = bakeWith(encoding, value);
    REQUIRE(bake);
    for (const Table& table : bake.value().tables) {
      const std::vector<float> texels = decodeLevel(table, 0);
      CHECK(std::all_of(texels.begin(), texels.end(), [](float v) { return std::isfinite(v); }));
    }
    const std::vector<double>& covariance = bake.value().noise.maps[0].covariance;
    CHECK(std::all_of(covariance.begin(), covariance.end(),
                      [](double v) { return std::isfinite(v); }));
  }
}
