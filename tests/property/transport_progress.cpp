// SPDX-License-Identifier: MIT
// The progress that a bake reports, and how to stop a bake.
#include "example_exemplar.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace lichen;

namespace {

MapExemplar greyOf(MapExemplar map) {
  for (std::size_t i = 0; i < map.values.size(); ++i)
    map.values[i] = map.values[i - i % 3];
  return map;
}

} // namespace

TEST_CASE("bakes of every kind report progress, and end at every step if the caller stops them") {
  const auto check = [&](const TilingOptions& wanted, const std::vector<MapExemplar>& maps,
                         std::size_t fewest, std::size_t stops) {
    TilingOptions options = wanted;
    std::vector<double> reported;
    options.progress = [&](double fraction) {
      reported.push_back(fraction);
      return true;
    };
    const Result<MethodBake> watched = bakeTiling("reported", maps, options);
    REQUIRE(watched.ok());
    const Result<MethodBake> alone = bakeTiling("reported", maps, wanted);
    for (std::size_t k = 0; k < watched.value().tables.size(); ++k)
      CHECK(watched.value().tables[k].texels == alone.value().tables[k].texels);
    CHECK(reported.size() >= fewest);
    CHECK(std::is_sorted(reported.begin(), reported.end()));
    CHECK(reported.front() >= 0.0);
    CHECK(reported.back() == 1.0);
    for (std::size_t last = reported.size() - std::min(stops, reported.size()) + 1;
         last <= reported.size(); ++last) {
      std::size_t calls = 0;
      options.progress = [&](double) { return ++calls < last; };
      const Result<MethodBake> stopped = bakeTiling("reported", maps, options);
      REQUIRE_FALSE(stopped.ok());
      CHECK(stopped.error().message == "reported: interrupted");
      CHECK(calls == last);
    }
  };
  constexpr std::size_t kAllStops = 1000;
  const MapExemplar map = test::threeMaterials(48, 48, 4);
  TilingOptions gaussian;
  gaussian.gaussian = GaussianOnly::yes;
  // At least one step before and after each whitening.
  check(gaussian, {map}, 4, kAllStops);
  gaussian.periodic = Periodic::no;
  check(gaussian, {map}, 4, kAllStops);
  check({}, {greyOf(map)}, 3, kAllStops);
  check({}, {test::threeMaterials(24, 24, 2)}, 5, kAllStops);
  // Each stop of a set bakes its first map again. The last steps are the second map's.
  MapExemplar height = greyOf(test::threeMaterials(32, 32, 5));
  height.target = MapTarget::emissive;
  check({}, {test::threeMaterials(32, 32, 4), height}, 5, 4);
}
