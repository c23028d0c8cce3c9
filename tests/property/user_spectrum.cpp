// SPDX-License-Identifier: MIT
// Noises with a spectrum that the user gives: their power lies where it says, and their colours are
// the exemplar's.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/fft.h>
#include <lichen/local_random_phase.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <evaluation/method_evaluator.h>
#include <functional>
#include <numbers>

using namespace lichen;

namespace {

constexpr int kTexels = 128;

SpectrumPicture pictureOf(bool (*holds)(int u, int v)) {
  SpectrumPicture picture{81, 81, {}};
  for (int v = -40; v <= 40; ++v)
    for (int u = -40; u <= 40; ++u)
      picture.amplitudes.push_back(holds(u, v) ? 1.0f : 0.0f);
  return picture;
}

Bundle baked(const MapExemplar& map, const SpectrumPicture& picture, int cosines) {
  LocalRandomPhaseOptions options;
  options.spectrum = picture;
  options.cosines = cosines;
  return test::bundleOf(bakeLocalRandomPhase("example", {&map, 1}, options));
}

/// The share of the first channel's power in 8 x 8 tiles at frequencies [cycles / tile] that
/// `isNear` takes.
double powerShare(const Bundle& bundle, const std::function<bool(double u, double v)>& isNear) {
  constexpr int kTiles = 8, kSide = 512;
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, MaterialNoise(), {});
  std::vector<float> plane;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float column = (float(x) + 0.5f) * kTiles / kSide;
      const float row = (float(y) + 0.5f) * kTiles / kSide;
      // A Hann window, as the plane does not repeat.
      const double window = std::pow(std::sin(3.14159265358979 * (x + 0.5) / kSide) *
                                         std::sin(3.14159265358979 * (y + 0.5) / kSide),
                                     2.0);
      const TileFootprint at{{column, row}, {}, {}};
      plane.push_back(
          float(window * (double(evaluator->gaussian(0, material, at).value[0]) - 0.5)));
    }
  const HalfSpectrum spectrum = forwardFft(plane, kSide, kSide);
  double near = 0.0, all = 0.0;
  for (int row = 0; row < kSide; ++row)
    for (int u = 0; u < spectrum.columns(); ++u) {
      const double power = std::norm(spectrum.at(u, row));
      all += power;
      if (isNear(double(u) / kTiles, double(spectrum.signedRow(row)) / kTiles))
        near += power;
    }
  return near / all;
}

} // namespace

TEST_CASE("a noise with a ring as its spectrum has its power there, even with twelve cosines") {
  const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
  const SpectrumPicture ring = pictureOf([](int u, int v) {
    const double magnitude = std::hypot(u, v);
    return magnitude >= 18.0 && magnitude <= 22.0;
  });
  const auto isNear = [](double u, double v) { return std::abs(std::hypot(u, v) - 20.0) < 6.0; };
  CHECK(powerShare(baked(map, ring, 50), isNear) > 0.95);
  // The corners of twelve rectangles around a ring lie beside it.
  CHECK(powerShare(baked(map, ring, 12), isNear) > 0.93);
}

TEST_CASE("a noise with a band as its spectrum has its power there, and the exemplar's colours") {
  const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
  const SpectrumPicture band =
      pictureOf([](int u, int v) { return u >= 25 && u <= 35 && v >= -2 && v <= 2; });
  const Bundle bundle = baked(map, band, 20);
  CHECK(powerShare(bundle, [](double u, double v) {
          return u > 22.0 && u < 38.0 && std::abs(v) < 6.0;
        }) > 0.95);
  // The mean light of 16 tiles.
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, MaterialNoise(), {});
  std::array<double, 3> found{}, wanted{};
  constexpr int kSide = 512;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto value = evaluator->evaluate(
          0, material,
          TileFootprint{{(float(x) + 0.5f) * 4 / kSide, (float(y) + 0.5f) * 4 / kSide}, {}, {}});
      for (std::size_t c = 0; c < 3; ++c)
        found[c] += double(value[c]) / (kSide * kSide);
    }
  for (std::size_t i = 0; i < map.values.size(); ++i) { // sRGB codes to light
    const double code = map.values[i];
    const double light = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
    wanted[i % 3] += light / (kTexels * kTexels);
  }
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(found[c] == Approx(wanted[c]).margin(0.01));
}

TEST_CASE(
    "maps of a set with a given spectrum hardly correlate, and it must have power they can hold") {
  std::vector<MapExemplar> maps(2, test::threeMaterials(kTexels, kTexels, 3));
  maps[1].target = MapTarget::emissive;
  LocalRandomPhaseOptions options;
  options.spectrum = pictureOf([](int u, int v) { return std::hypot(u, v) < 30.0; });
  const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("example", maps, options));
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, MaterialNoise(), {});
  double product = 0.0, squares = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const TileFootprint at{{float(k) * 0.0137f, float(k) * 0.0871f}, {}, {}};
    const double first = double(evaluator->gaussian(0, material, at).value[0]) - 0.5;
    product += first * (double(evaluator->gaussian(1, material, at).value[0]) - 0.5);
    squares += first * first;
  }
  // Measured 0.22, as one phase for each map cannot follow all frequencies of a rectangle; 1 if
  // both had the same phases.
  CHECK(std::abs(product / squares) < 0.35);

  options.spectrum = SpectrumPicture{3, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0}};
  const Result<MethodBake> empty = bakeLocalRandomPhase("example", maps, options);
  REQUIRE_FALSE(empty);
  CHECK(empty.error().kind == ErrorKind::badInput);
}

TEST_CASE("a spectrum of the user's own excludes a structure") {
  const MapExemplar map = test::threeMaterials(32, 32, 3);
  LocalRandomPhaseOptions options;
  options.spectrum = pictureOf([](int, int) { return true; });
  options.structure = 0.5;
  const Result<MethodBake> bake = bakeLocalRandomPhase("x", {&map, 1}, options);
  REQUIRE_FALSE(bake);
  CHECK(bake.error().kind == ErrorKind::usage);
}

TEST_CASE("a coloured picture gives each channel its own spectrum") {
  // Red is slow and blue is fast; green has both.
  SpectrumPicture picture{81, 81, {}, 3};
  const auto isIn = [](double u, double v, double from, double to) {
    return std::hypot(u, v) >= from && std::hypot(u, v) <= to;
  };
  for (int v = -40; v <= 40; ++v)
    for (int u = -40; u <= 40; ++u) {
      const float slow = isIn(u, v, 6, 9) ? 1.0f : 0.0f, fast = isIn(u, v, 25, 30) ? 0.3f : 0.0f;
      picture.amplitudes.insert(picture.amplitudes.end(), {slow, 0.7f * (slow + fast), fast});
    }
  const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
  const Bundle bundle = baked(map, picture, 30);
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, MaterialNoise(), {});
  constexpr int kSide = 256, kTiles = 2;
  std::array<double, 3> slow{}, all{};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> plane;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const TileFootprint at{{float(x) * kTiles / kSide, float(y) * kTiles / kSide}, {}, {}};
        plane.push_back(std::sqrt(evaluator->evaluate(0, material, at)[c])); // as it is stored
      }
    const HalfSpectrum spectrum = forwardFft(plane, kSide, kSide);
    for (int row = 0; row < kSide; ++row)
      for (int u = 0; u < spectrum.columns(); ++u) {
        const double power = std::norm(std::complex<double>(spectrum.at(u, row)));
        const double cycles = std::hypot(u, spectrum.signedRow(row)) / kTiles;
        if (cycles >= 3.0)
          all[c] += power;
        if (cycles >= 3.0 && cycles < 16.0)
          slow[c] += power;
      }
  }
  // Channels that correlate in the exemplar must do so in the noise: hues are drawn together.
  CHECK(slow[0] / all[0] > slow[1] / all[1]);
  CHECK(slow[1] / all[1] > slow[2] / all[2]);
  CHECK(slow[0] / all[0] > slow[2] / all[2] + 0.2);
}
