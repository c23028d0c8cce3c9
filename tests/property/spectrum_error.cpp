// SPDX-License-Identifier: MIT
// How the detail of a noise is measured, and that a fit has its exemplar's detail.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/image_io.h>
#include <lichen/quality.h>
#include <lichen/synthesize.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <gaussian/map_fit.h>
#include <gaussian/mip_chain.h>
#include <numbers>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::gaussian;

namespace {

constexpr int kSide = 256;

/// An image of 256 x 256 has 16 non-overlapping windows of 64 x 64. A ring of radius r has about pi
/// r / 1.5 independent exponential powers, each with a standard deviation of 4.3 dB. The mean over
/// rings 4 to 32 has a standard deviation of 0.04 dB for the exemplar and for the blended image,
/// 0.057 together. The margin is four of these: one false alarm in 16,000.
constexpr double kMargin = 0.23;

/// White noise with the Gaussian's mean and standard deviation [BM58].
std::vector<float> whiteNoise(std::uint64_t seed) {
  std::vector<float> values;
  for (std::uint64_t i = 0; i < std::uint64_t(kSide) * kSide; ++i) {
    const double u = transport::randomUniform(seed, 2 * i);
    const double v = transport::randomUniform(seed, 2 * i + 1);
    const double deviate =
        std::sqrt(-2.0 * std::log(1.0 - u)) * std::cos(2.0 * std::numbers::pi * v);
    values.push_back(float(gaussian::kGaussianMean + gaussian::kGaussianDeviation * deviate));
  }
  return values;
}

/// Averages each pixel with its right and lower neighbours: power cos^2(pi fx) cos^2(pi fy).
std::vector<float> averagedWithNeighbours(const std::vector<float>& values) {
  const auto at = [&](int x, int y) {
    return values[std::size_t(y % kSide) * kSide + std::size_t(x % kSide)];
  };
  std::vector<float> result;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      result.push_back(0.25f * (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)));
  return result;
}

MapExemplar linearMap(std::vector<float> values) {
  MapExemplar map;
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  map.width = map.height = kSide;
  map.values = std::move(values);
  return map;
}

/// Its blends are the noise itself: the table returns the Gaussian value unchanged.
Gaussianized gaussianImage(const std::vector<float>& values) {
  Gaussianized gaussian;
  gaussian.width = gaussian.height = kSide;
  for (const float value : values)
    gaussian.image.push_back({value, 0.0f, 0.0f});
  return gaussian;
}

InverseTable identityTable() {
  InverseTable table{1, kTableSide[0], 1, {}};
  for (int cell = 0; cell < table.side; ++cell)
    table.values.push_back(float(gaussian::gaussianQuantile((cell + 0.5) / table.side)));
  return table;
}

/// Mean of 10 log10 of the filter's mean power, over radii from 4 to half a window's cycles.
double filterDecibels(int window) {
  std::vector<double> power(std::size_t(window / 2 + 1), 0.0), count(power.size(), 0.0);
  for (int v = -window / 2 + 1; v <= window / 2; ++v)
    for (int u = -window / 2 + 1; u <= window / 2; ++u) {
      const auto radius = std::size_t(std::lround(std::hypot(double(u), double(v))));
      if (radius >= power.size())
        continue;
      const double amplitude =
          std::cos(std::numbers::pi * u / window) * std::cos(std::numbers::pi * v / window);
      power[radius] += amplitude * amplitude;
      ++count[radius];
    }
  double sum = 0.0;
  for (std::size_t radius = 4; radius < power.size(); ++radius)
    sum += 10.0 * std::log10(power[radius] / count[radius]);
  return sum / double(power.size() - 4);
}

} // namespace

TEST_CASE("the spectrum error is the power ratio of the noise and its exemplar", "[large]") {
  const MapExemplar map = linearMap(whiteNoise(1));
  CHECK(spectrumErrorDb(map, gaussianImage(whiteNoise(2)), identityTable()) ==
        Approx(0.0).margin(kMargin));
  const Gaussianized smooth = gaussianImage(averagedWithNeighbours(whiteNoise(3)));
  CHECK(spectrumErrorDb(map, smooth, identityTable()) ==
        Approx(filterDecibels(64)).margin(kMargin));
}

TEST_CASE("the spectrum error of colours equals the error of their luminance") {
  // All channels vary in the exemplar, only green in the noise: 0.7152 of luminance, a third of the
  // channels.
  MapExemplar map = linearMap({});
  map.target = MapTarget::baseColor;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.encoding = ValueEncoding::srgb;
  for (const float value : whiteNoise(4))
    map.values.insert(map.values.end(), 3, value);
  InverseTable table{1, kTableSide[0], 3, {}};
  const auto root = [](float code) { return std::sqrt(srgbToLinear(code)); };
  for (const float value : identityTable().values)
    table.values.insert(table.values.end(), {root(0.5f), root(value), root(0.5f)});
  CHECK(spectrumErrorDb(map, gaussianImage(whiteNoise(5)), table) ==
        Approx(20.0 * std::log10(0.7152)).margin(kMargin));
}

TEST_CASE("exemplars smaller than a window have no spectrum and get the default share") {
  CHECK(hasSpectrum(test::threeMaterials(64, 80, 7)));
  const MapExemplar small = test::threeMaterials(63, 80, 7);
  CHECK_FALSE(hasSpectrum(small));
  CHECK(fitMap(small, exemplar::colorSpaceOf(small), {}).share == exemplar::kUsualShare);
}

TEST_CASE("the share of a large map is fitted on its middle", "[large]") {
  // Two of its channels: a table of two axes is faster, and one axis always gets the usual share.
  MapExemplar whole = test::threeMaterials(520, 64, 7, 3);
  for (std::size_t i = 0; i < whole.values.size() / 3; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      whole.values[2 * i + c] = whole.values[3 * i + c];
  whole.values.resize(whole.values.size() / 3 * 2);
  whole.target = MapTarget::occlusionRoughnessMetallic;
  whole.channels = {MapChannel::occlusion, MapChannel::roughness};
  whole.encoding = ValueEncoding::linear;
  const MapExemplar middle = test::cropped(whole, 4, 0, 512, 64);
  MapFitOptions options;
  const float share = fitMap(whole, exemplar::colorSpaceOf(whole), options).share;
  options.borders.fit = false;
  CHECK(share == fitMap(middle, exemplar::colorSpaceOf(whole), options).share);
  // The content matters: the same values in random order have no patches, and the share is smaller.
  MapExemplar shuffled = test::cropped(middle, 0, 0, 64, 64);
  for (std::size_t i = shuffled.values.size() / 2; i-- > 1;) {
    const auto other = std::size_t(transport::randomUniform(11, i) * double(i + 1));
    for (std::size_t c = 0; c < 2; ++c)
      std::swap(shuffled.values[2 * i + c], shuffled.values[2 * other + c]);
  }
  CHECK(share - fitMap(shuffled, exemplar::colorSpaceOf(whole), options).share > 0.2f);
}

TEST_CASE("a fitted share preserves detail that the default share loses", "[large]") {
  // Grain within patches of one colour each; transport alone spreads the grain over the Gaussian.
  const MapExemplar map = test::threeMaterials(96, 96, 7, 3);
  const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
  const std::vector<Point> points = exemplar::transportPoints(map, space);
  std::vector<float> light;
  for (const float value : map.values)
    light.push_back(srgbToLinear(value));
  const transport::TransportOptions transport{};
  const Gaussianized usual =
      gaussianize(map, points, space.dimensions(), {}, gaussian::Precision::bits8, transport);
  const InverseTable usualTable = fitInverseTable(usual, points, light, 3, transport);
  const double usualError = spectrumErrorDb(map, usual, usualTable);
  INFO("with the usual share " << usualError << " dB");
  CHECK(std::abs(usualError) > 0.5);
  const MapFit fit = fitMap(map, space, {});
  CHECK(std::abs(spectrumErrorDb(map, fit.gaussian, fit.table)) < 0.25);

  // The whole bake, by the measure of results and its target.
  const Bundle bundle =
      test::bundleOf(bakeTiling("patches", {&map, 1}, {.periodic = Periodic::yes, .progress = {}}));
  SynthesisOptions size;
  size.width = size.height = 768;
  const SrgbImage result = toSrgb(synthesize(bundle, size).value());
  SrgbImage exemplar(map.width, map.height, 3);
  exemplar.values = map.values;
  CHECK(spectrumDistanceDb(exemplar, result).value() < 0.6);
}

TEST_CASE("the maps of a set use one share of the surroundings, which is small", "[large]") {
  const MapExemplar first = test::threeMaterials(96, 96, 7, 3);
  CHECK(fitMap(first, exemplar::colorSpaceOf(first), {}).share > kLargestShareInSet);
  MapExemplar second = test::threeMaterials(96, 96, 8, 1);
  second.target = MapTarget::occlusionRoughnessMetallic;
  second.encoding = ValueEncoding::linear;
  const std::array maps{first, second};
  const Result<MethodBake> bake =
      bakeTiling("set", maps, {.periodic = Periodic::yes, .progress = {}});
  REQUIRE(bake);
  MapFitOptions given;
  given.share = kLargestShareInSet;
  std::vector<SettledMap> settled;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    given.settled = settled;
    const MapFit expected = fitMap(maps[m], exemplar::colorSpaceOf(maps[m]), given);
    settled.emplace_back(maps[m], exemplar::colorSpaceOf(maps[m]), expected.gaussian,
                         expected.table);
    const MethodBake& set = bake.value();
    CHECK(set.tables[set.noise.maps[m].as<TilingMap>().gaussian].texels ==
          gaussianTable(expected.gaussian, 8).texels);
  }
}
