// SPDX-License-Identifier: MIT
// The loss of 8 and 16 bits for an exemplar.
#include "example_exemplar.h"

#include <lichen/tiling_precision.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace lichen;

namespace {

Bundle bakedWith(const MapExemplar& map, int bits) {
  TilingOptions options;
  options.bits = bits;
  options.periodic = Periodic::yes;
  Result<TilingBake> bake = bakeTiling("precision", {&map, 1}, options);
  REQUIRE(bake);
  Bundle bundle;
  bundle.tables = std::move(bake.value().tables);
  bundle.noises = {std::move(bake.value().noise)};
  return bundle;
}

PrecisionLoss lossOf(const Bundle& bundle, const MapExemplar& map) {
  const Result<PrecisionLoss> loss = precisionLoss(bundle, 0, 0, map, true);
  REQUIRE(loss);
  REQUIRE(loss.value().roundTrip.has_value());
  return loss.value();
}

} // namespace

TEST_CASE("8 bits lose little more than 16, in every measure", "[large]") {
  const MapExemplar map = test::threeMaterials(128, 128, 12);
  const PrecisionLoss eight = lossOf(bakedWith(map, 8), map);
  const PrecisionLoss sixteen = lossOf(bakedWith(map, 16), map);
  INFO("8 bits: " << eight.mean << ", " << eight.variance << ", " << eight.colorDistance << ", "
                  << *eight.roundTrip << "; 16 bits: " << sixteen.mean << ", " << sixteen.variance
                  << ", " << sixteen.colorDistance << ", " << *sixteen.roundTrip);
  // Three colours with nothing between them are difficult for interpolation. Measured on this
  // exemplar, the larger value of both precisions: 0.0007, 0.0071, 0.0097 and 0.166. The first two
  // are differences of large numbers: their limits are nearly three times that, and those of the
  // other two half as much again.
  constexpr double kMean = 0.002, kVariance = 0.02, kDistance = 0.015, kRoundTrip = 0.25;
  for (const PrecisionLoss& loss : {eight, sixteen}) {
    CHECK(loss.mean < kMean);
    CHECK(std::abs(loss.variance) < kVariance);
    CHECK(loss.colorDistance < kDistance);
    CHECK(*loss.roundTrip < kRoundTrip);
  }
  // Rounding moves a colour by at most half a step. A step of G is 6/255 of its standard deviation,
  // and the rounding error is 1/sqrt(12) of that along each of three axes: 0.012 of a colour's
  // standard deviation if errors only added up. Measured: 0.006. The rest allows for colours that
  // rounding moves to another cell.
  constexpr double kRounded = 0.02;
  CHECK(eight.colorDistance < sixteen.colorDistance + 0.5 / 255.0);
  CHECK(*eight.roundTrip < *sixteen.roundTrip + kRounded);
}

TEST_CASE("precision is measured on the decoded texels") {
  // A constant table: the whole variance is lost, and the distance is that of the exemplar to a
  // single colour.
  const MapExemplar map = test::threeMaterials(64, 64, 3);
  Bundle bundle = bakedWith(map, 16);
  Table& table = bundle.tables[*bundle.noises[0].maps[0].as<TilingMap>().inverseTable];
  const std::vector<float> black(table.texels.size() / 2, 0.0f);
  table.texels.clear();
  appendTexels(table.texels, table.format, black);
  const PrecisionLoss loss = lossOf(bundle, map);
  CHECK(loss.variance == Approx(1.0));
  double squares = 0.0;
  for (const float value : map.values)
    squares += double(value) * double(value);
  // Over directions on the sphere, a component has the mean square 1/3.
  CHECK(loss.colorDistance ==
        Approx(std::sqrt(squares / double(map.values.size() / 3) / 3.0)).epsilon(0.05));
}

TEST_CASE("an exemplar of another shape is an error") {
  const MapExemplar map = test::threeMaterials(32, 32, 3);
  const Bundle bundle = bakedWith(map, 8);
  CHECK_FALSE(precisionLoss(bundle, 0, 0, test::threeMaterials(32, 16, 3), true));
  CHECK_FALSE(precisionLoss(bundle, 0, 1, map, true));
  CHECK_FALSE(precisionLoss(bundle, 1, 0, map, true));
}
