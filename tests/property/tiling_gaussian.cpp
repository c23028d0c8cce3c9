// SPDX-License-Identifier: MIT
// The stratified Gaussian set and the Gaussianized image.
#include "baked_exemplar.h"

#include <lichen/tiling_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

namespace {

std::vector<std::array<float, 3>> sorted(const std::vector<Point>& points) {
  std::vector<std::array<float, 3>> result;
  for (const Point& p : points)
    result.push_back({p.x, p.y, p.z});
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST_CASE("the quantile inverts the distribution function") {
  for (const double u : {1e-9, 1e-4, 0.01, 0.2, 0.5, 0.77, 0.999, 1.0 - 1e-7})
    CHECK(gaussian::gaussianCdf(gaussian::gaussianQuantile(u)) == Approx(u).epsilon(1e-5));
}

TEST_CASE("stratified Gaussian sets have mean 1/2 and covariance I / 36 exactly") {
  for (const int dimensions : {1, 2, 3})
    for (const std::size_t count : {std::size_t(64), std::size_t(1000), std::size_t(4096)}) {
      std::vector<float> values;
      for (const Point& p :
           gaussian::stratifiedGaussian(count, dimensions, gaussian::Precision::bits16))
        values.insert(values.end(), &p.x, &p.x + dimensions);
      const exemplar::Moments moments = exemplar::momentsOf(values, dimensions);
      // Float rounding of the stored coordinates.
      CHECK((moments.mean.array() - 0.5).abs().maxCoeff() < 1e-7);
      const exemplar::ChannelMatrix unit =
          exemplar::ChannelMatrix::Identity(dimensions, dimensions) / 36.0;
      CHECK((moments.covariance - unit).cwiseAbs().maxCoeff() < 1e-8);
    }
}

TEST_CASE("each coordinate of a stratified set has one value in the middle of each stratum") {
  // Powers of the coordinates' bases, which fill their digits. Whitening moves the remainder of the
  // strata's centres: a correlation of about 0.01 times a value of at most 4 standard deviations,
  // 0.007.
  for (const auto& [count, axis] : {std::pair{std::size_t(4096), 0}, {4096, 1}, {6561, 2}}) {
    std::vector<float> values;
    for (const Point& p : gaussian::stratifiedGaussian(count, 3, gaussian::Precision::bits16))
      values.push_back(axis == 0 ? p.x : axis == 1 ? p.y : p.z);
    std::sort(values.begin(), values.end());
    for (std::size_t k = 0; k < count; ++k)
      REQUIRE(double(values[k]) ==
              Approx(gaussian::gaussianQuantile((double(k) + 0.5) / double(count))).margin(0.007));
  }
}

TEST_CASE("an 8-bit Gaussian set keeps its variance although it is clamped at three deviations",
          "[large]") {
  std::vector<float> values;
  for (const Point& p : gaussian::stratifiedGaussian(65536, 3, gaussian::Precision::bits8)) {
    values.insert(values.end(), {p.x, p.y, p.z});
    constexpr float kShift = kStoredGaussianMean - 0.5f;
    for (const float coordinate : {p.x, p.y, p.z}) {
      const float code = 255.0f * (coordinate + kShift);
      REQUIRE(code == Approx(std::round(code)).margin(1e-3));
      REQUIRE((std::round(code) >= 0.0f && std::round(code) <= 255.0f));
    }
  }
  const exemplar::Moments moments = exemplar::momentsOf(values, 3);
  // Rounding to 1/255 adds (1/255)^2 / 12 to the variance, a relative 4.6e-5; clamping would lose
  // 5.6e-3.
  const exemplar::ChannelMatrix unit = exemplar::ChannelMatrix::Identity(3, 3) / 36.0;
  CHECK((moments.covariance - unit).cwiseAbs().maxCoeff() * 36.0 < 3e-4);
}

TEST_CASE("the Gaussianized image is a permutation of the stratified set") {
  for (const gaussian::Precision precision :
       {gaussian::Precision::bits8, gaussian::Precision::bits16})
    for (const bool periodic : {true, false}) {
      const Baked b = baked(threeMaterials(48, 40, 7), periodic, precision);
      const auto stratified = sorted(gaussian::stratifiedGaussian(48 * 40, 3, precision));
      CHECK(sorted(b.gaussian.image) == stratified);
      CHECK(sorted(b.gaussian.matched) == stratified);
    }
}

TEST_CASE("flat regions stay smooth when Gaussianized") {
  // Half of the pixels share one colour: their order is free and follows the surroundings.
  MapExemplar map = threeMaterials(96, 96, 12, 6);
  for (std::size_t i = 0; i < map.values.size(); i += 3)
    if (map.values[i] > 0.6f)
      map.values[i] = map.values[i + 1] = map.values[i + 2] = 0.7f;
  const Baked b = baked(map);
  const auto isFlat = [&map](std::size_t i) { return map.values[3 * i] == 0.7f; };
  std::vector<float> flat;
  double steps = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < b.points.size(); ++i) {
    if (!isFlat(i))
      continue;
    const Point& p = b.gaussian.matched[i];
    flat.insert(flat.end(), {p.x, p.y, p.z});
    if ((i + 1) % 96 == 0 || !isFlat(i + 1))
      continue;
    const Point& q = b.gaussian.matched[i + 1];
    const Point d{p.x - q.x, p.y - q.y, p.z - q.z};
    steps += double(dot(d, d));
    ++count;
  }
  // In an arbitrary order, neighbours would be independent draws of the colour's points, with a
  // mean square difference of twice their variance. Measured: 0.17 of that.
  const double arbitrary = 2.0 * exemplar::momentsOf(flat, 3).covariance.trace();
  INFO("steps of " << steps / double(count) / arbitrary << " of an arbitrary order's");
  CHECK(steps / double(count) < 0.5 * arbitrary);
}

TEST_CASE(
    "equal values are sorted by their surroundings, within half a quantization step of the file") {
  MapExemplar map;
  map.channels = {MapChannel::red};
  map.width = 64;
  map.height = 1;
  for (int x = 0; x < map.width; ++x) // dark, flat, bright
    map.values.push_back(x < 16 ? 0.2f : x < 48 ? 0.5f : 0.8f);
  const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
  const std::vector<Point> points = exemplar::transportPoints(map, space);
  CHECK(points[46].x > points[40].x);
  CHECK(points[40].x > points[24].x);
  CHECK(points[24].x > points[17].x);
  for (std::size_t x = 0; x < points.size(); ++x)
    CHECK(double(points[x].x) + space.moments.mean[0] ==
          Approx(double(map.values[x])).margin(0.5 * map.quantum + 1e-6));
}
