// SPDX-License-Identifier: MIT
// What the analysis does when memory runs out: each allocation in turn fails, and the function
// reports it and leaves nothing behind (AddressSanitizer's runs look for leaks).
#include "example_exemplar.h"
#include "failing_allocations.h"

#include <lichen/quality.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>
#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace lichen;

namespace {

/// Runs `operation`, which returns a Result, with failing allocations 1, 2, 4, ... or, if `every`,
/// 1, 2, 3, ... until it succeeds; each failure must be reported as one of resources. One thread
/// only: the count is the thread's. Returns how many failures there were.
template <class Operation>
int failEachAllocation(bool every, Operation operation) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  int failures = 0;
  for (int failing = 1;; failing += every ? 1 : failing) {
    test::allocationsUntilFailure = failing;
    const auto result = operation();
    const bool reached = test::allocationsUntilFailure == 0;
    test::allocationsUntilFailure = 0;
    if (!reached) {
      REQUIRE(result.ok());
      return failures;
    }
    INFO("allocation " << failing);
    REQUIRE_FALSE(result.ok());
    REQUIRE(result.error().kind == ErrorKind::resources);
    REQUIRE(result.error().message.find("memory") != std::string::npos);
    ++failures;
  }
}

MapExemplar oneChannel(MapExemplar map) {
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    map.values[i] = map.values[3 * i];
  map.values.resize(map.values.size() / 3);
  map.channels = {MapChannel::red};
  return map;
}

Bundle bakedBundle(const MapExemplar& map) {
  Result<TilingBake> bake = bakeTiling("example", {&map, 1}, {});
  REQUIRE(bake);
  Bundle bundle;
  bundle.tables = std::move(bake.value().tables);
  bundle.noises = {std::move(bake.value().noise)};
  return bundle;
}

} // namespace

TEST_CASE("a bake that runs out of memory says so, whichever allocation fails") {
  const MapExemplar color = test::threeMaterials(24, 20, 1, 1);
  const MapExemplar grey = oneChannel(color);
  TilingOptions options;
  options.transport = TransportEffort::fast;
  CHECK(failEachAllocation(true, [&] { return bakeTiling("x", {&grey, 1}, options); }) > 20);
  CHECK(failEachAllocation(false, [&] { return bakeTiling("x", {&color, 1}, options); }) > 5);
}

TEST_CASE("an evaluation that runs out of memory says so, whichever allocation fails") {
  const Bundle bundle = bakedBundle(oneChannel(test::threeMaterials(64, 64, 1, 1)));
  CHECK(failEachAllocation(true, [&] { return TilingEvaluator::create(bundle, 0); }) > 2);
  SynthesisOptions options;
  options.width = options.height = 64;
  CHECK(failEachAllocation(true, [&] { return synthesize(bundle, options); }) > 3);
  CHECK(failEachAllocation(
            true, [&] { return synthesizePreview(bundle, 0, MapTarget::baseColor, 1, 1); }) > 3);
}

TEST_CASE("a measure that runs out of memory says so, whichever allocation fails") {
  SrgbImage a(80, 72, 1);
  for (std::size_t i = 0; i < a.values.size(); ++i)
    a.values[i] = float(pcg(std::uint32_t(i)) >> 8u) * 0x1p-24f;
  const SrgbImage b = a;
  LatticeView view;
  view.tilesPerPixelX = view.tilesPerPixelY = 1.0 / 40.0;
  CHECK(failEachAllocation(true, [&] { return colorDistance(a, b); }) > 0);
  CHECK(failEachAllocation(true, [&] { return spectrumDistanceDb(a, b); }) > 0);
  CHECK(failEachAllocation(true, [&] { return autocovarianceError(a, b, 8); }) > 0);
  CHECK(failEachAllocation(true, [&] { return latticeVisibility(a, view); }) > 0);
  CHECK(failEachAllocation(true, [&] { return stationaryLatticeVisibility(a, view, 2); }) > 0);
  CHECK(failEachAllocation(true, [&] { return seamVisibility(a, b); }) > 0);
  CHECK(failEachAllocation(true, [&] { return phaseRandomized(a, 1); }) > 0);
}
