// SPDX-License-Identifier: MIT
// The list of measures with their targets, and the anisotropy that selects one of them.
#include <lichen/lattice.h>
#include <lichen/measures.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace lichen;

namespace {

constexpr int kSide = 64;

SrgbImage grey(int side, const std::function<double(int, int)>& value) {
  SrgbImage image(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      *image.pixel(x, y) = float(value(x, y));
  return image;
}

double hashed(int x, int y) {
  return pcg3d({std::uint32_t(x), std::uint32_t(y), 1u})[0] / std::exp2(32.0);
}

const Measure& named(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& measure : measures)
    if (measure.name == name)
      return measure;
  FAIL(name);
  return measures.front();
}

} // namespace

TEST_CASE("stripes have an anisotropy of 1, whatever their direction") {
  for (const double degrees : {0.0, 30.0, 45.0, 90.0, 117.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double u = 0.3 * std::cos(angle), v = 0.3 * std::sin(angle); // radians per pixel
    const SrgbImage stripes =
        grey(kSide, [=](int x, int y) { return 0.5 + 0.4 * std::sin(u * x + v * y); });
    INFO(degrees);
    // Both gradients of a plane wave are multiples of one function of position, so the tensor has
    // rank one except for float rounding.
    CHECK(gradientAnisotropy(stripes) == Approx(1.0).margin(1e-6));
  }
}

TEST_CASE("the direction of waves of four pixels is right to half a degree") {
  for (int degrees = 0; degrees <= 90; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double u = 1.5 * std::cos(angle), v = 1.5 * std::sin(angle); // radians per pixel
    std::vector<float> plane;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        plane.push_back(float(std::sin(u * x + v * y)));
    const double found = gradientDirection(plane, kSide, kSide).angle;
    CHECK(std::abs(found) * 180.0 / std::numbers::pi == Approx(degrees).margin(0.5));
  }
}

TEST_CASE("two equal crossed gratings have no anisotropy, unequal ones the closed form's") {
  const auto crossed = [](double amplitude) {
    const double step = 2.0 * std::numbers::pi / 16.0; // whole periods over 64 gradients
    return grey(kSide + 2, [=](int x, int y) {
      return 0.5 + 0.2 * std::sin(step * x) + 0.2 * amplitude * std::sin(step * y);
    });
  };
  CHECK(gradientAnisotropy(crossed(1.0)) == Approx(0.0).margin(1e-6));
  // Energies are proportional to the squared amplitudes: (1 - a^2) / (1 + a^2).
  CHECK(gradientAnisotropy(crossed(0.5)) == Approx(0.75 / 1.25).margin(1e-6));
  CHECK(gradientAnisotropy(grey(kSide, [](int, int) { return 0.3; })) == 0.0);
}

TEST_CASE("white noise has hardly any anisotropy") {
  // With 64^2 gradients, each term of the tensor has a standard error of about sqrt(2 / 64^2) =
  // 0.02. The limit is three times that: a false alarm below one in a hundred.
  CHECK(gradientAnisotropy(grey(kSide, hashed)) < 0.06);
}

TEST_CASE("an image meets every measure against itself, with the stated target") {
  const SrgbImage noise = grey(kSide, hashed);
  const auto measures = measureResult(noise, noise).value();
  CHECK(measures.size() == 4);
  for (const Measure& measure : measures) {
    CHECK(measure.value.has_value());
    CHECK(!measure.isMissed());
  }
  CHECK(named(measures, "color_distance").target == 0.003);
  CHECK(named(measures, "spectrum_distance_db").target == 0.6);
  CHECK(named(measures, "seam_visibility").target == 1.1);
  CHECK(named(measures, "autocovariance_error").target == 0.2);
}

TEST_CASE("a measure is missed when it is over its target, not when it has no value or no target") {
  Measure measure;
  CHECK(!measure.isMissed());
  measure.value = 2.0;
  CHECK(!measure.isMissed());
  measure.target = 2.0;
  CHECK(!measure.isMissed());
  measure.target = 1.9;
  CHECK(measure.isMissed());
  measure.value.reset();
  CHECK(!measure.isMissed());
}

TEST_CASE("an image that is too small gives a remark, images that do not fit are an error") {
  const SrgbImage small = grey(8, hashed);
  const auto measures = measureResult(small, small).value();
  CHECK(named(measures, "color_distance").value == 0.0);
  CHECK(!named(measures, "seam_visibility").value);
  CHECK_THAT(named(measures, "seam_visibility").remark, Catch::Contains("at least 49"));
  CHECK(named(measures, "autocovariance_error").value == 0.0); // in a smaller support
  CHECK(measureResult(small, SrgbImage(8, 8, 3)).error().kind == ErrorKind::badInput);
  CHECK(measureResult(SrgbImage(), small).error().kind == ErrorKind::badInput);
}
