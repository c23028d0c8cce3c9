// SPDX-License-Identifier: MIT
// Maps without an inverse table.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/image.h>
#include <lichen/shader_parameters.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <exemplar/color_space.h>
#include <exemplar/value_encoding.h>
#include <gaussian/gaussianize.h>
#include <gaussian/normality.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::gaussian;

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
      const Gaussianized image = gaussianImage(map, {periodic}, precision);
      std::vector<float> values;
      for (const Point& p : image.image)
        values.insert(values.end(), {p.x, p.y, p.z});
      const exemplar::Moments found = exemplar::momentsOf(values, 3);
      // Rounding to 8 bits: measured 1e-4 of the variance, and 1/255 / sqrt(12 x 4096) for a mean.
      const double tolerance = precision == gaussian::Precision::bits8 ? 2e-4 : 1e-6;
      CHECK((found.mean.array() - 0.5).abs().maxCoeff() < tolerance);
      CHECK((36.0 * found.covariance - Eigen::Matrix3d::Identity()).norm() < 36.0 * tolerance);
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      constexpr float kShift = kStoredGaussianMean - 0.5f, kRounding = 1e-6f;
      if (precision == gaussian::Precision::bits8)
        CHECK((*low + kShift >= -kRounding && *high + kShift <= 1.0f + kRounding));
    }
}

TEST_CASE("a noise without a table has the exemplar's light, near and far", "[large]") {
  const MapExemplar map = gaussianExemplar(128, 1, 0.12, 6);
  TilingOptions options;
  options.gaussian = GaussianOnly::yes;
  const Bundle bundle = test::bundleOf(bakeTiling("kinds", {&map, 1}, options));
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
    // TARGETS.md: 0.004 per channel. Decoding averages in closed form. What remains is the sampling
    // error of 128^2 pixels, and that all channels share one loss.
    CHECK((far.mean - wanted.mean).cwiseAbs().maxCoeff() < 0.004);
  }
}

TEST_CASE("only exemplars that span all their channels can do without a table") {
  MapExemplar grey = gaussianExemplar(64, 1, 0.05, 7);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] = grey.values[i - i % 3];
  TilingOptions options;
  options.gaussian = GaussianOnly::yes;
  const Result<MethodBake> refused = bakeTiling("grey", {&grey, 1}, options);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::usage);
  CHECK(refused.error().message.find("span less than 3 dimensions") != std::string::npos);
  options.gaussian = GaussianOnly::detect;
  CHECK(test::bundleOf(bakeTiling("kinds", {&grey, 1}, options))
            .noises[0]
            .maps[0]
            .as<TilingMap>()
            .inverseTable.has_value());
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
  const Result<MethodBake> refused = bakeTiling("dithered", {&dithered, 1}, options);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("span less than 3 dimensions") != std::string::npos);
}
