// SPDX-License-Identifier: MIT
// The progress that a bake reports, and how to stop a bake.
#include "example_exemplar.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace lichen;

TEST_CASE("a bake's progress rises from 0 to 1 and does not change the result") {
  const MapExemplar map = test::threeMaterials(48, 48, 1);
  std::vector<double> fractions;
  TilingOptions watched;
  watched.progress = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  const Result<TilingBake> bake = bakeTiling("watched", {&map, 1}, watched);
  const Result<TilingBake> alone = bakeTiling("watched", {&map, 1}, {});
  REQUIRE(bake.ok());
  REQUIRE(alone.ok());
  CHECK(bake.value().tables[0].texels == alone.value().tables[0].texels);
  CHECK(bake.value().tables[1].texels == alone.value().tables[1].texels);
  REQUIRE(fractions.size() > 4);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.front() >= 0.0);
  CHECK(fractions.back() == 1.0);
}

TEST_CASE("a bake that the caller stops returns an error, at every step") {
  const MapExemplar map = test::threeMaterials(24, 24, 2);
  int steps = 0;
  TilingOptions options;
  options.progress = [&](double) { return ++steps > 0; };
  REQUIRE(bakeTiling("counted", {&map, 1}, options).ok());
  const int all = steps;
  for (int last = 1; last <= all; ++last) {
    steps = 0;
    options.progress = [&](double) { return ++steps < last; };
    const Result<TilingBake> bake = bakeTiling("stopped", {&map, 1}, options);
    INFO("stopped at call " << last << " of " << all);
    REQUIRE(!bake.ok());
    CHECK(bake.error().message == "stopped: interrupted");
    CHECK(steps == last);
  }
}

namespace {

MapExemplar greyOf(MapExemplar map) {
  for (std::size_t i = 0; i < map.values.size(); ++i)
    map.values[i] = map.values[i - i % 3];
  return map;
}

} // namespace

TEST_CASE("bakes of every kind report progress often, and end when the caller stops them") {
  MapExemplar map = test::threeMaterials(48, 48, 4);
  const auto check = [&](const TilingOptions& wanted, const MapExemplar& exemplar,
                         std::size_t fewest) {
    TilingOptions options = wanted;
    std::vector<double> reported;
    options.progress = [&](double fraction) {
      reported.push_back(fraction);
      return true;
    };
    REQUIRE(bakeTiling("reported", {&exemplar, 1}, options).ok());
    CHECK(reported.size() >= fewest);
    CHECK(std::is_sorted(reported.begin(), reported.end()));
    CHECK(reported.back() == 1.0);
    for (std::size_t last = 1; last <= reported.size(); ++last) {
      std::size_t calls = 0;
      options.progress = [&](double) { return ++calls < last; };
      const Result<TilingBake> stopped = bakeTiling("reported", {&exemplar, 1}, options);
      REQUIRE_FALSE(stopped.ok());
      CHECK(stopped.error().message == "reported: interrupted");
      CHECK(calls == last);
    }
  };
  TilingOptions gaussian;
  gaussian.gaussian = GaussianOnly::yes;
  // At least one step before and after each whitening.
  check(gaussian, map, 4);
  gaussian.periodic = Periodic::no;
  check(gaussian, map, 4);
  check({}, greyOf(map), 3);
}
