// SPDX-License-Identifier: MIT
// Maps without a table, and maps with one table per axis.
#include "example_exemplar.h"

#include <lichen/image.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <exemplar/color_space.h>
#include <exemplar/value_encoding.h>
#include <gaussian/normality.h>
#include <tiling/gaussian_image.h>
#include <tiling/mip_chain.h>
#include <tiling/prefilter.h>
#include <tiling/separable.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::tiling;

namespace {

/// White Gaussian noise averaged over (2 radius + 1)^2 texels, with the given standard deviation,
/// in three correlated channels; `bend` skews it.
MapExemplar gaussianExemplar(int side, int radius, double deviation, std::uint64_t seed,
                             double bend = 0.0) {
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.width = map.height = side;
  map.values.resize(3 * std::size_t(side) * std::size_t(side));
  const auto white = [&](int x, int y, std::size_t c) {
    const auto i = std::size_t(((y + side) % side) * side + (x + side) % side);
    double sum = -6.0; // twelve uniform numbers minus their mean: Gaussian up to 4 deviations
    for (std::uint64_t k = 0; k < 12; ++k)
      sum += transport::randomUniform(seed + c, 12 * i + k);
    return sum;
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      std::array<double, 3> g{};
      for (std::size_t c = 0; c < 3; ++c) {
        for (int dy = -radius; dy <= radius; ++dy)
          for (int dx = -radius; dx <= radius; ++dx)
            g[c] += white(x + dx, y + dy, c) / (2 * radius + 1);
        g[c] = deviation * (0.8 * g[0] + (c == 0 ? 0.2 : 0.6) * g[c]);
      }
      for (std::size_t c = 0; c < 3; ++c)
        map.values[3 * std::size_t(y * side + x) + c] =
            float(0.5 + g[c] + bend * (g[c] * g[c] - deviation * deviation));
    }
  return map;
}

Bundle bakedWith(const MapExemplar& map, const TilingOptions& options) {
  Result<TilingBake> bake = bakeTiling("kinds", {&map, 1}, options);
  REQUIRE(bake);
  Bundle bundle;
  bundle.tables = std::move(bake.value().tables);
  bundle.noises = {std::move(bake.value().noise)};
  return bundle;
}

exemplar::Moments synthesizedMoments(const Bundle& bundle, int side, double texelsPerTile = 0.0) {
  SynthesisOptions options;
  options.width = options.height = side;
  options.texelsPerTile = texelsPerTile;
  const Result<LinearImage> image = synthesize(bundle, options);
  REQUIRE(image);
  return exemplar::momentsOf(image.value().values, image.value().channels);
}

exemplar::Moments lightMoments(const MapExemplar& map) {
  std::vector<float> values = map.values;
  for (float& value : values)
    value = exemplar::decoded(value, map.encoding);
  return exemplar::momentsOf(values, int(map.channels.size()));
}

} // namespace

TEST_CASE("the bake distinguishes Gaussian exemplars from others", "[large]") {
  for (const std::uint64_t seed : {1u, 2u, 3u})
    for (const int radius : {0, 1, 2}) {
      INFO("radius " << radius << ", distance "
                     << gaussian::distanceToGaussian(gaussianExemplar(128, radius, 0.05, seed)));
      CHECK(gaussian::isGaussian(gaussianExemplar(128, radius, 0.05, seed)));
    }
  // Skewed by 0.6, uniform grain, and three materials.
  CHECK_FALSE(gaussian::isGaussian(gaussianExemplar(128, 1, 0.1, 1, 1.0)));
  MapExemplar uniform = gaussianExemplar(128, 0, 0.1, 1);
  for (std::size_t i = 0; i < uniform.values.size(); ++i)
    uniform.values[i] = float(transport::randomUniform(9, i));
  CHECK_FALSE(gaussian::isGaussian(uniform));
  CHECK_FALSE(gaussian::isGaussian(test::threeMaterials(128, 128, 4)));
}

TEST_CASE("of two exemplars at the same distance from a Gaussian, only the one within sampling "
          "error passes") {
  // Between half a step and one step of 8 bits, surrogates decide. 16,384 independent values prove
  // the skew; patches of 15 x 15 texels hold only some seventy.
  const MapExemplar skewed = gaussianExemplar(128, 0, 0.08, 4, 0.45);
  const MapExemplar smooth = gaussianExemplar(128, 7, 0.07, 4);
  for (const MapExemplar& map : {skewed, smooth}) {
    CHECK(gaussian::distanceToGaussian(map) > 0.5 / 255.0);
    CHECK(gaussian::distanceToGaussian(map) < 1.0 / 255.0);
  }
  CHECK_FALSE(gaussian::isGaussian(skewed));
  CHECK(gaussian::isGaussian(smooth));
}

TEST_CASE("the distance to a Gaussian is the distance of the quantiles") {
  // The uniform distribution on an interval with standard deviation s: its squared distance to the
  // Gaussian of the same moments is 2 s^2 (1 - integral of sqrt(12) (u - 1/2) q(u)) = 2 s^2 (1 -
  // sqrt(3 / pi)).
  MapExemplar map;
  map.channels = {MapChannel::height};
  map.target = MapTarget::height;
  map.encoding = ValueEncoding::linear;
  map.width = 100;
  map.height = 100;
  for (int i = 0; i < 10000; ++i)
    map.values.push_back((float(i) + 0.5f) / 10000.0f);
  const double expected = std::sqrt(2.0 / 12.0 * (1.0 - std::sqrt(3.0 / 3.14159265358979)));
  CHECK(gaussian::distanceToGaussian(map) == Approx(expected).epsilon(1e-3));
}

TEST_CASE("a Gaussian image has mean 1/2 and covariance I/36 as it is stored") {
  const MapExemplar map = gaussianExemplar(64, 1, 0.05, 5);
  for (const gaussian::Precision precision :
       {gaussian::Precision::bits8, gaussian::Precision::bits16})
    for (const bool periodic : {true, false}) {
      const Gaussianized image =
          gaussianImage(map, exemplar::colorSpaceOf(map).moments, periodic, precision);
      std::vector<float> values;
      for (const Point& p : image.image)
        values.insert(values.end(), {p.x, p.y, p.z});
      const exemplar::Moments found = exemplar::momentsOf(values, 3);
      // Rounding to 8 bits: measured 1e-4 of the variance, and 1/255 / sqrt(12 x 4096) for a mean.
      const double tolerance = precision == gaussian::Precision::bits8 ? 2e-4 : 1e-6;
      CHECK((found.mean.array() - 0.5).abs().maxCoeff() < tolerance);
      CHECK((36.0 * found.covariance - Eigen::Matrix3d::Identity()).norm() < 36.0 * tolerance);
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      if (precision == gaussian::Precision::bits8)
        CHECK((*low >= 0.0f && *high <= 1.0f));
    }
}

TEST_CASE("a noise without a table has the exemplar's light, near and far", "[large]") {
  const MapExemplar map = gaussianExemplar(128, 1, 0.12, 6);
  TilingOptions options;
  options.gaussian = GaussianOnly::yes;
  const Bundle bundle = bakedWith(map, options);
  REQUIRE(bundle.tables.size() == 1);
  CHECK_FALSE(bundle.noises[0].maps[0].as<TilingMap>().inverseTable.has_value());
  const exemplar::Moments wanted = lightMoments(map);
  const exemplar::Moments near = synthesizedMoments(bundle, 1024);
  // 1024^2 pixels, correlated over 9: standard errors of 0.3 % of a standard deviation and 0.4 % of
  // a variance. The limits are four of these.
  const double deviation = std::sqrt(wanted.covariance.diagonal().maxCoeff());
  CHECK((near.mean - wanted.mean).cwiseAbs().maxCoeff() < 0.012 * deviation);
  CHECK((near.covariance - wanted.covariance).norm() < 0.02 * wanted.covariance.norm());
  for (const double texelsPerTile : {32.0, 4.0, 0.1}) {
    const exemplar::Moments far = synthesizedMoments(bundle, 128, texelsPerTile);
    // TARGETS: 0.004 per channel; the quadrature alone is within 0.005 at its worst.
    CHECK((far.mean - wanted.mean).cwiseAbs().maxCoeff() < 0.004);
  }
}

TEST_CASE("only exemplars that span all their channels can do without a table") {
  MapExemplar grey = gaussianExemplar(64, 1, 0.05, 7);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] = grey.values[i - i % 3];
  TilingOptions options;
  options.gaussian = GaussianOnly::yes;
  const Result<TilingBake> refused = bakeTiling("grey", {&grey, 1}, options);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::usage);
  CHECK(refused.error().message.find("span less than 3 dimensions") != std::string::npos);
  options.gaussian = GaussianOnly::detect;
  CHECK(bakedWith(grey, options).noises[0].maps[0].as<TilingMap>().inverseTable.has_value());
}

TEST_CASE("a dimension with only the dither of a 16-bit file needs a table") {
  // The covariance exceeds rounding, but the format has too few digits to store it as definite.
  MapExemplar dithered = gaussianExemplar(64, 1, 0.2, 8);
  dithered.encoding = ValueEncoding::linear;
  dithered.quantum = 1.0 / 65535.0;
  for (std::size_t i = 0; i < dithered.values.size(); i += 3)
    for (std::size_t c = 1; c < 3; ++c)
      dithered.values[i + c] =
          dithered.values[i] + float((int((i / 3) >> c & 1u) * 2 - 1) * dithered.quantum);
  REQUIRE(exemplar::colorSpaceOf(dithered).dimensions() == 3);
  TilingOptions options;
  options.gaussian = GaussianOnly::yes;
  const Result<TilingBake> refused = bakeTiling("dithered", {&dithered, 1}, options);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("span less than 3 dimensions") != std::string::npos);
}

TEST_CASE("a separable table's slabs are the integrals of each axis, at the middles of its cells") {
  const MapExemplar map = test::threeMaterials(96, 96, 8);
  const SeparableFit fit = fitSeparable(map, true, gaussian::Precision::bits16, {});
  REQUIRE(fit.dimensions() == 3);
  exemplar::ChannelMatrix half(3, 3);
  half << 0.7, 0.1, 0.0, 0.1, 0.5, 0.0, 0.0, 0.0, 0.3;
  const std::vector<double> levels = tableLevels();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const InverseTable& table = fit.tables[std::size_t(axis)];
    const std::vector<InverseTable> slabs = prefilteredSlabsFor(table, [&] {
      std::vector<exemplar::ChannelMatrix> losses;
      for (const double level : levels)
        losses.push_back(lossAt(level, {half}).block(axis, axis, 1, 1));
      return losses;
    }());
    const auto [low, high] = std::minmax_element(table.values.begin(), table.values.end());
    for (const std::size_t k : {std::size_t(1), std::size_t(2), std::size_t(5)}) {
      const double lost = lossAt(levels[k], {half})(axis, axis);
      for (const std::size_t cell : {std::size_t(3), std::size_t(100), std::size_t(128)}) {
        constexpr int kSteps = 20000; // of e, over eight standard deviations in each direction
        const double middle = gaussian::gaussianQuantile((double(cell) + 0.5) / 256.0);
        double sum = 0.0, weights = 0.0;
        for (int n = 0; n < kSteps; ++n) {
          const double z = 16.0 * (n + 0.5) / kSteps - 8.0;
          const double weight = std::exp(-0.5 * z * z);
          const double place = std::clamp(
              256.0 * gaussian::gaussianCdf(middle + std::sqrt(lost) * z / 6.0) - 0.5, 0.0, 255.0);
          const auto below = std::min(std::size_t(place), std::size_t(254));
          const double t = place - double(below);
          sum += weight *
                 ((1.0 - t) * double(table.values[below]) + t * double(table.values[below + 1]));
          weights += weight;
        }
        // The slabs are sampled at 256 stratified positions.
        CHECK(double(slabs[k].values[cell]) ==
              Approx(sum / weights).margin(double(*high - *low) / 256.0));
      }
    }
  }
}

TEST_CASE("every level of a separable table has the exemplar's mean and its axis' variance") {
  const MapExemplar map = test::threeMaterials(96, 96, 8);
  const SeparableFit fit = fitSeparable(map, true, gaussian::Precision::bits16, {});
  const exemplar::Moments wanted = lightMoments(map);
  CHECK((fit.offset - wanted.mean).norm() < 1e-6);
  exemplar::ChannelMatrix variances = exemplar::ChannelMatrix::Zero(3, 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const exemplar::Moments found = interpolatedMoments(fit.tables[axis]);
    CHECK(std::abs(found.mean[0]) < 1e-4);
    variances(Eigen::Index(axis), Eigen::Index(axis)) = found.covariance(0, 0);
  }
  CHECK((fit.basis * variances * fit.basis.transpose() - wanted.covariance).norm() <
        2e-3 * wanted.covariance.norm());
  const Table image = gaussianTable(combinedImage(fit), 16);
  const std::vector<exemplar::ChannelMatrix> lost = lostVariance(image);
  const std::vector<InverseTable> slabs = separableSlabs(fit, 16, lost);
  // Grain and patches: the axes lose differently. Each slab belongs to one axis and is moved by one
  // number.
  const exemplar::ChannelMatrix middle = lossAt(tableLevels()[3], lost);
  CHECK(middle.diagonal().maxCoeff() - middle.diagonal().minCoeff() > 0.1);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    CHECK(double(slabs.back().values[std::size_t(axis)]) == Approx(0.0).margin(1e-4));
    std::vector<exemplar::ChannelMatrix> losses;
    for (const double level : tableLevels())
      losses.push_back(lossAt(level, lost).block(axis, axis, 1, 1));
    const std::vector<InverseTable> own =
        prefilteredSlabsFor(fit.tables[std::size_t(axis)], losses);
    const double deviation = std::sqrt(variances(axis, axis));
    const auto moved = [&](std::size_t cell) {
      return double(slabs[3].values[3 * cell + std::size_t(axis)]) - double(own[3].values[cell]);
    };
    for (std::size_t cell = 32; cell < 224; ++cell)
      CHECK(moved(cell) == Approx(moved(128)).margin(1e-3 * deviation));
  }
}

TEST_CASE("a noise with a separable table has the exemplar's light, near and far", "[large]") {
  const MapExemplar map = test::threeMaterials(128, 128, 11);
  TilingOptions options;
  options.lut = LookupTable::separable;
  const Bundle bundle = bakedWith(map, options);
  const NoiseMap& baked = bundle.noises[0].maps[0];
  REQUIRE(baked.as<TilingMap>().tableBasis.size() == 9);
  CHECK(bundle.tables[*baked.as<TilingMap>().inverseTable].texels.size() == 256 * kTableLevels * 8);
  const exemplar::Moments wanted = lightMoments(map);
  const exemplar::Moments near = synthesizedMoments(bundle, 1024);
  // As for the joint table in tests/property/tiling_evaluate.cpp. Clamping values outside the gamut
  // also moves a channel by some thousandths, because three colours are far from independent axes.
  CHECK((near.mean - wanted.mean).cwiseAbs().maxCoeff() < 0.012);
  CHECK((near.covariance - wanted.covariance).norm() < 0.1 * wanted.covariance.norm());
  const exemplar::Moments far = synthesizedMoments(bundle, 32, 0.05);
  CHECK((far.mean - wanted.mean).cwiseAbs().maxCoeff() < 0.004);
}

TEST_CASE("a colour with little variance gets a joint table although separable is requested") {
  // Dark red and green vary by one code step. This is negligible beside full blue, whose code step
  // is seventeen times the light.
  constexpr int kSide = 64;
  MapExemplar dark;
  dark.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  dark.width = dark.height = kSide;
  const auto code = [](int place) { return (place < kSide / 2 ? 21.0f : 20.0f) / 255.0f; };
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      dark.values.insert(dark.values.end(), {code(x), code(y), 1.0f});
  REQUIRE(exemplar::colorSpaceOf(dark).dimensions() == 2);
  TilingOptions options;
  options.lut = LookupTable::separable;
  options.gaussian = GaussianOnly::no;
  CHECK(bakedWith(dark, options).noises[0].maps[0].as<TilingMap>().tableBasis.empty());
}

TEST_CASE("one-dimensional maps, slopes and light above 1 always have a joint table", "[large]") {
  MapExemplar grey = test::threeMaterials(48, 48, 2);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] = grey.values[i - i % 3];
  MapExemplar slopes = test::threeMaterials(48, 48, 2);
  slopes.target = MapTarget::normal;
  slopes.channels = {MapChannel::slopeX, MapChannel::slopeY};
  slopes.encoding = ValueEncoding::slope;
  slopes.values.resize(2 * 48 * 48);
  MapExemplar bright = test::threeMaterials(48, 48, 2);
  bright.encoding = ValueEncoding::log2;
  TilingOptions joint, separable;
  separable.lut = LookupTable::separable;
  for (const MapExemplar& map : {grey, slopes, bright}) {
    const Bundle bundle = bakedWith(map, separable);
    CHECK(bundle.noises[0].maps[0].as<TilingMap>().tableBasis.empty());
    CHECK(bundle.tables[1].texels == bakedWith(map, joint).tables[1].texels);
  }
}
