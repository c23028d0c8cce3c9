// SPDX-License-Identifier: MIT
// What a bake tells of its progress, and how it is stopped.
#include "example_exemplar.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace lichen;

TEST_CASE("a bake's progress rises from 0 to 1 and does not change what is made") {
  const MapExemplar map = test::threeMaterials(96, 96, 1);
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

TEST_CASE("a bake whose caller stops it makes nothing and says so, at every step") {
  const MapExemplar map = test::threeMaterials(48, 48, 2);
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
