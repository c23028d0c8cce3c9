// SPDX-License-Identifier: MIT
// The inverse table, fitted to pairs of a Gaussian point and a value; its tails as evaluated.
#include "baked_exemplar.h"
#include "bundle_of.h"

#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <sampling/texels.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

TEST_CASE("lookups in the table have the exemplar's mean and covariance", "[large]") {
  const Baked b = baked(threeMaterials(160, 160, 3));
  const std::vector<float> values = tableValues(b.map);
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, values, 3, transport::TransportOptions{});
  const exemplar::Moments found = interpolatedMoments(table);
  const exemplar::Moments wanted = exemplar::momentsOf(values, 3);
  // Clamping to the exemplar's range leaves at most a thousandth.
  CHECK((found.mean - wanted.mean).cwiseAbs().maxCoeff() < 1e-4);
  CHECK((found.covariance - wanted.covariance).norm() < 1e-3 * wanted.covariance.norm());

  // Compares the closed form of the moments with lookups at stratified points.
  std::vector<float> looked;
  for (const Point& p : gaussian::stratifiedGaussian(2000, 3, gaussian::Precision::bits16))
    for (int c = 0; c < 3; ++c)
      looked.push_back(float(slowLookup(table, {p.x, p.y, p.z}, c)));
  const exemplar::Moments sampled = exemplar::momentsOf(looked, 3);
  // The standard error of a mean of 2000 is 2.2 % of a standard deviation; stratification reduces
  // it.
  const double deviation = std::sqrt(wanted.covariance.diagonal().maxCoeff());
  CHECK((sampled.mean - found.mean).cwiseAbs().maxCoeff() < 0.02 * deviation);
}

TEST_CASE("a one-dimensional cell averages the values whose ranks it covers") {
  // Three values in 256 cells. Cell 85 covers ranks 85 / 256 to 86 / 256, a third of it below 1 /
  // 3. Restoring the moments stretches the table by no more than the two mixed cells lost: 1 %.
  MapExemplar map;
  map.channels = {MapChannel::red};
  map.encoding = ValueEncoding::linear;
  map.width = 3;
  map.height = 1;
  map.values = {0.0f, 0.5f, 1.0f};
  const Baked b = baked(map);
  const InverseTable table = fitInverseTable(b.gaussian, b.points, map.values, 1, {});
  REQUIRE(table.values.size() == 256);
  CHECK(double(table.values[84]) == Approx(0.0).margin(0.01));
  CHECK(double(table.values[85]) == Approx(0.5 * 2.0 / 3.0).margin(0.01));
  CHECK(double(table.values[86]) == Approx(0.5).margin(0.01));
  CHECK(double(table.values[170]) == Approx(0.5 + 0.5 / 3.0).margin(0.01));
  CHECK(double(table.values[171]) == Approx(1.0).margin(0.01));
}

TEST_CASE("the table stays inside the hull of the exemplar's colours", "[large]") {
  // Lookups interpolate cells, so they stay inside the cells' convex hull: it is enough that no
  // cell extends beyond the exemplar in any direction.
  for (const std::uint64_t seed : {5u, 6u}) {
    const Baked b = baked(threeMaterials(128, 128, seed));
    const std::vector<float> values = tableValues(b.map);
    const InverseTable table =
        fitInverseTable(b.gaussian, b.points, values, 3, transport::TransportOptions{});
    for (std::uint64_t k = 0; k < 200; ++k) {
      const Point direction = transport::randomDirection(31, k);
      const auto extent = [&](const std::vector<float>& colours) {
        std::pair<float, float> range{1e9f, -1e9f};
        for (std::size_t i = 0; i < colours.size(); i += 3) {
          const float along = dot(direction, {colours[i], colours[i + 1], colours[i + 2]});
          range = {std::min(range.first, along), std::max(range.second, along)};
        }
        return range;
      };
      const auto [low, high] = extent(values);
      // Restoring the covariance that interpolation loses stretches the table by up to 2 %.
      const float allowed = 0.02f * (high - low);
      const auto [tableLow, tableHigh] = extent(table.values);
      REQUIRE(tableLow >= low - allowed);
      REQUIRE(tableHigh <= high + allowed);
    }
  }
}

TEST_CASE("neighbouring cells in the tails of slopes differ no more than their means") {
  // Two independent slopes with Laplace's distribution, standard deviation 1, in random order. The
  // outermost 1/64 of one slope has an exponential distribution of standard deviation sqrt(1/2)
  // beyond the quantile. T of one slope does not depend on the other, so all cells along that edge
  // are alike except for chance.
  MapExemplar map;
  map.target = MapTarget::normal;
  map.channels = {MapChannel::slopeX, MapChannel::slopeY};
  map.encoding = ValueEncoding::slope;
  map.width = map.height = 256; // 16 pixels per cell
  constexpr int kPixels = 256 * 256;
  const double scale = std::sqrt(0.5);
  std::vector<float> laplace(kPixels);
  for (int i = 0; i < kPixels; ++i) {
    const double u = (i + 0.5) / kPixels - 0.5;
    laplace[std::size_t(i)] = float(-scale * std::copysign(std::log(1.0 - 2.0 * std::abs(u)), u));
  }
  std::array<std::vector<float>, 2> slopes{laplace, laplace};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = kPixels; i-- > 1;)
      std::swap(slopes[k][i], slopes[k][transport::randomBits(7 + k, i) % (i + 1)]);
  for (std::size_t i = 0; i < kPixels; ++i)
    map.values.insert(map.values.end(), {slopes[0][i], slopes[1][i]});
  const Baked b = baked(map);
  // Mean and standard deviation of the first slope over the last column, without four cells at each
  // corner.
  const auto edge = [&](CellValue value) {
    const InverseTable table = fitInverseTable(b.gaussian, b.points, map.values, 2, {}, value);
    std::vector<float> column;
    for (std::size_t y = 4; y < 60; ++y)
      column.push_back(table.values[2 * (64 * y + 63)]);
    return exemplar::momentsOf(column, 1);
  };
  const exemplar::Moments means = edge(CellValue::mean);
  // Means of 16 pixels have a quarter of the standard deviation: 0.18, with a 10 % error over 56
  // cells.
  CHECK(std::sqrt(means.covariance(0, 0)) < 1.5 * 0.25 * scale);
  // Quantile plus mean excess. Restoring the variance stretches by the 3 % that cells average away.
  CHECK(means.mean[0] == Approx(scale * (std::log(32.0) + 1.0)).epsilon(0.05));
  CHECK(std::sqrt(edge(CellValue::onePixel).covariance(0, 0)) > 0.8 * scale);
}

TEST_CASE("the outermost thousandths of a map of one channel come out of its table") {
  // Values of an exponential distribution, whose upper tail is long, in random order. At a
  // thousandth of the distribution a cell of 256 holds the mean of four times as much: a value
  // beyond the quantile of 1/256 becomes their mean.
  constexpr int kSide = 256, kPixels = kSide * kSide;
  MapExemplar map;
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  map.width = map.height = kSide;
  const auto quantile = [](double u) { return 0.1 - 0.1 * std::log(1.0 - u); };
  for (int i = 0; i < kPixels; ++i)
    map.values.push_back(float(quantile((i + 0.5) / kPixels)));
  for (std::size_t i = kPixels; i-- > 1;)
    std::swap(map.values[i], map.values[transport::randomBits(7, i) % (i + 1)]);
  TilingOptions options;
  options.bits = 16;
  const Bundle bundle = bundleOf(bakeTiling("tail", {&map, 1}, options));
  const auto evaluator = methodEvaluator(bundle, 0);
  std::vector<float> values;
  for (const Texel& texel :
       texelsOf(bundle.tables[bundle.noises[0].maps[0].as<TilingMap>().gaussian], 0))
    values.push_back(evaluator->decoded(0, {texel[0] - kStoredGaussianMean + 0.5f, 0.5f, 0.5f})[0]);
  std::sort(values.begin(), values.end());
  // An outermost cell holds the mean of its values, and the lookup is constant from its centre on.
  const double highest = quantile(255.0 / 256.0) + 0.1; // the mean beyond a quantile
  const double lowest = quantile(0.5 / 256.0);
  CHECK(double(values[std::size_t(0.999 * kPixels)]) == Approx(highest).epsilon(0.01));
  CHECK(double(values[std::size_t(0.001 * kPixels)]) == Approx(lowest).epsilon(0.01));
  // Within the cells, quantiles are the exemplar's, to half of the next cell's difference.
  // The outermost cell averages 1/256 of the variance away, and restoring it stretches the table
  // about the mean, 0.2, by half of that; interpolation adds as much again.
  for (const double u : {0.01, 0.1, 0.5, 0.9, 0.99})
    CHECK(double(values[std::size_t(u * kPixels)]) ==
          Approx(quantile(u))
              .margin(0.5 * (quantile(u + 1.0 / 256.0) - quantile(u)) +
                      std::abs(quantile(u) - 0.2) / 256.0));
}
