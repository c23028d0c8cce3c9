// SPDX-License-Identifier: MIT
// The progress that a bake reports, and how to stop a bake.
#include "example_exemplar.h"

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>
#include <lichen/texton.h>
#include <lichen/texton_mix.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace lichen;

namespace {

MapExemplar greyOf(MapExemplar map) {
  for (std::size_t i = 0; i < map.values.size(); ++i)
    map.values[i] = map.values[i - i % 3];
  return map;
}

/// `bake` takes a Progress and returns the Result of a bake of the noise "reported", which is
/// stopped at each of the last `stops` reports.
void check(const auto& bake, std::size_t fewest, std::size_t stops,
           const std::string& stopped = "reported: interrupted") {
  std::vector<double> reported;
  const auto watched = bake([&](double fraction) {
    reported.push_back(fraction);
    return true;
  });
  REQUIRE(watched.ok());
  const auto alone = bake({});
  for (std::size_t k = 0; k < watched.value().tables.size(); ++k)
    CHECK(watched.value().tables[k].texels == alone.value().tables[k].texels);
  CHECK(reported.size() >= fewest);
  CHECK(std::is_sorted(reported.begin(), reported.end()));
  CHECK(reported.front() >= 0.0);
  CHECK(reported.back() == 1.0);
  for (std::size_t last = reported.size() - std::min(stops, reported.size()) + 1;
       last <= reported.size(); ++last) {
    std::size_t calls = 0;
    const auto ended = bake([&](double) { return ++calls < last; });
    REQUIRE_FALSE(ended.ok());
    CHECK(ended.error().kind == ErrorKind::environment);
    CHECK(ended.error().message == stopped);
    CHECK(calls == last);
  }
}

constexpr std::size_t kAllStops = 1000;

} // namespace

TEST_CASE("tiling bakes of every kind report progress, and end at every step if the caller stops "
          "them") {
  const auto checkTiling = [](TilingOptions options, const std::vector<MapExemplar>& maps,
                              std::size_t fewest, std::size_t stops) {
    check(
        [&](const Progress& progress) {
          options.progress = progress;
          return bakeTiling("reported", maps, options);
        },
        fewest, stops);
  };
  const MapExemplar map = test::threeMaterials(48, 48, 4);
  TilingOptions gaussian;
  gaussian.gaussian = GaussianOnly::yes;
  // At least one step before and after each whitening.
  checkTiling(gaussian, {map}, 4, kAllStops);
  gaussian.periodic = Periodic::no;
  checkTiling(gaussian, {map}, 4, kAllStops);
  checkTiling({}, {greyOf(map)}, 3, kAllStops);
  checkTiling({}, {test::threeMaterials(24, 24, 2)}, 5, kAllStops);
  // Each stop of a set bakes its first map again. The last steps are the second map's.
  MapExemplar height = greyOf(test::threeMaterials(32, 32, 5));
  height.target = MapTarget::emissive;
  checkTiling({}, {test::threeMaterials(32, 32, 4), height}, 5, 4);
}

TEST_CASE("bakes by the other methods report progress, and end if the caller stops them") {
  const MapExemplar map = test::threeMaterials(32, 32, 4);
  const auto by = [&](auto bake, auto options) {
    return [&map, bake, options](const Progress& progress) {
      auto own = options;
      own.progress = progress;
      return bake("reported", {&map, 1}, own);
    };
  };
  TextonOptions texton;
  texton.support = 8;
  check(by(bakeTexton, texton), 50, 8, "the bake: interrupted");
  check(by(bakeLocalRandomPhase, LocalRandomPhaseOptions{}), 5, 8);
  check(by(bakeMultipleKernels, MultipleKernelsOptions{}), 5, 8);
  check(by(bakeQuilting, QuiltingOptions{}), 2, 8);
  const std::vector<MixedExemplar> mixed{{"a.png", {map}},
                                         {"b.png", {test::threeMaterials(32, 32, 2)}}};
  check(
      [&](const Progress& progress) {
        TextonMixOptions options{.texton = texton, .steps = 3, .weights = {}};
        options.texton.progress = progress;
        return bakeTextonMix("reported", mixed, options);
      },
      50, 8, "the mix: interrupted");
}
