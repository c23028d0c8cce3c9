// SPDX-License-Identifier: MIT
// The measures against closed forms, against slow versions of themselves, and against faults added
// on purpose.
#include <lichen/fft.h>
#include <lichen/lattice.h>
#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <patch_distance.h>
#include <vector>

using namespace lichen;
using bench::patchDistance;

namespace {

/// Uniform in [0, 1).
float hashed(int x, int y, std::uint32_t seed) {
  return float(pcg3d({std::uint32_t(x), std::uint32_t(y), seed})[0] >> 8u) * 0x1p-24f;
}

SrgbImage makeImage(int width, int height, int channels,
                    const std::function<float(int, int, int)>& value) {
  SrgbImage image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.pixel(x, y)[c] = value(x, y, c);
  return image;
}

/// Grey white noise of mean 1/2, uniform with the given half width.
SrgbImage whiteNoise(int width, int height, std::uint32_t seed, float halfWidth = 0.25f) {
  return makeImage(width, height, 1, [=](int x, int y, int) {
    return 0.5f + halfWidth * (2.0f * hashed(x, y, seed) - 1.0f);
  });
}

/// Grey noise of power proportional to 1 / frequency^exponent, standard deviation 0.1.
SrgbImage powerLawNoise(int side, double exponent, std::uint32_t seed) {
  const SrgbImage white = whiteNoise(side, side, seed);
  HalfSpectrum spectrum = forwardFft(white.values, side, side);
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < spectrum.columns(); ++u) {
      const double radius = std::hypot(double(u), double(v <= side / 2 ? v : v - side));
      spectrum.at(u, v) *= radius > 0.0 ? float(std::pow(radius, -0.5 * exponent)) : 0.0f;
    }
  }
  SrgbImage image = white;
  image.values = inverseFft(spectrum);
  double energy = 0.0;
  for (const float value : image.values)
    energy += double(value) * double(value);
  const float scale = 0.1f / float(std::sqrt(energy / double(image.pixelCount())));
  for (float& value : image.values)
    value = 0.5f + scale * value;
  return image;
}

constexpr int kTiles = 4; // per side, in the lattice tests
constexpr int kSide = 160;

LatticeView latticeView(Grain grain = Grain::none) {
  LatticeView view;
  view.lattice = periodicLattice(kTiles, kTiles, grain);
  view.tilesPerPixelX = view.tilesPerPixelY = double(kTiles) / kSide;
  view.originTilesX = 1000.25;
  view.originTilesY = -37.5;
  return view;
}

/// Distance to the nearest vertex, by trying all vertices around, where triangles are equilateral.
double slowVertexDistance(const LatticeView& view, int x, int y) {
  const double px = view.originTilesX + (x + 0.5) * view.tilesPerPixelX;
  const double py = view.originTilesY + (y + 0.5) * view.tilesPerPixelY;
  const int row = int(std::lround(py * view.lattice.rowsPerTile));
  double nearest = 1e9;
  for (int j = row - 3; j <= row + 3; ++j) {
    const int column = int(std::lround(px * view.lattice.columnsPerTile - 0.5 * j));
    for (int i = column - 3; i <= column + 3; ++i)
      nearest = std::min(nearest, std::hypot((px * view.lattice.columnsPerTile - i - 0.5 * j) / 3.5,
                                             (py * view.lattice.rowsPerTile - j) / 4.0));
  }
  return nearest;
}

/// The definition: pixels sorted by distance and split into 8 equal parts.
double slowLatticeVisibility(const SrgbImage& image, const LatticeView& view) {
  std::vector<std::pair<double, double>> pixels;
  double mean = 0.0;
  for (const float value : image.values)
    mean += double(value) / double(image.values.size());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      pixels.emplace_back(slowVertexDistance(view, x, y),
                          std::pow(double(*image.pixel(x, y)) - mean, 2.0));
  std::sort(pixels.begin(), pixels.end());
  std::array<double, 8> variance{};
  const std::size_t part = pixels.size() / 8;
  for (std::size_t i = 0; i < 8 * part; ++i)
    variance[i / part] += pixels[i].second / double(part);
  const auto [low, high] = std::minmax_element(variance.begin(), variance.end());
  return (*high - *low) * 8.0 / std::accumulate(variance.begin(), variance.end(), 0.0);
}

/// White noise whose contrast falls with the distance to the vertices, as in linear blending.
SrgbImage latticeModulated(const LatticeView& view, std::uint32_t seed) {
  SrgbImage image = whiteNoise(kSide, kSide, seed);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto gain = float(1.0 - 2.0 * slowVertexDistance(view, x, y));
      *image.pixel(x, y) = 0.5f + gain * (*image.pixel(x, y) - 0.5f);
    }
  }
  return image;
}

} // namespace

TEST_CASE("colour distance is 0 for the same colours in another order and number") {
  const SrgbImage image =
      makeImage(20, 10, 3, [](int x, int y, int c) { return hashed(x, y, std::uint32_t(c)); });
  const SrgbImage repeated = makeImage(
      40, 30, 3, [](int x, int y, int c) { return hashed(19 - x % 20, y % 10, std::uint32_t(c)); });
  CHECK(colorDistance(image, image).value() == 0.0);
  CHECK(colorDistance(image, repeated).value() == 0.0);
}

TEST_CASE("colour distance of a shifted set is the shift over the root of three") {
  const std::array<float, 3> shift{0.1f, 0.05f, -0.02f};
  const SrgbImage image = makeImage(
      64, 64, 3, [](int x, int y, int c) { return 0.2f + 0.5f * hashed(x, y, std::uint32_t(c)); });
  const SrgbImage shifted = makeImage(
      64, 64, 3, [&](int x, int y, int c) { return image.pixel(x, y)[c] + shift[std::size_t(c)]; });
  const double length = std::hypot(0.1, 0.05, 0.02);
  // 0.2 %: the uniformity of 256 directions on the half sphere.
  CHECK(colorDistance(image, shifted).value() == Approx(length / std::sqrt(3.0)).epsilon(0.002));
}

TEST_CASE("the colour distance of two uniform grey distributions equals the distance of their "
          "quantiles") {
  // W2 of U[0, 1] and U[0, 1/2]: the integral of (u - u / 2)^2 is 1/12. The sets differ in size.
  const auto ramp = [](int width, float top) {
    return makeImage(width, 1, 1,
                     [=](int x, int, int) { return top * (float(x) + 0.5f) / float(width); });
  };
  CHECK(colorDistance(ramp(4000, 1.0f), ramp(3001, 0.5f)).value() ==
        Approx(std::sqrt(1.0 / 12.0)).margin(3e-4)); // 1 / 3001, the coarser ramp's step
}

TEST_CASE("colour distance ignores alpha") {
  const SrgbImage opaque = makeImage(
      8, 8, 4, [](int x, int y, int c) { return c == 3 ? 1.0f : hashed(x, y, std::uint32_t(c)); });
  const SrgbImage color =
      makeImage(8, 8, 3, [](int x, int y, int c) { return hashed(x, y, std::uint32_t(c)); });
  CHECK(colorDistance(opaque, color).value() == 0.0);
}

TEST_CASE("white and 1/f^2 noise differ by the distance of their power laws") {
  constexpr int kImageSide = 512;
  const SrgbImage white = powerLawNoise(kImageSide, 0.0, 2);
  const SrgbImage pink = powerLawNoise(kImageSide, 2.0, 3);
  // Powers at k cycles per crop of 128: constant, and total / k^2 with the same total variance.
  double total = 0.0;
  for (int v = 1 - kImageSide / 2; v <= kImageSide / 2; ++v)
    for (int u = 1 - kImageSide / 2; u <= kImageSide / 2; ++u)
      total += u == 0 && v == 0 ? 0.0 : 1.0 / double(u * u + v * v);
  double sum = 0.0;
  for (int ring = 4; ring <= 64; ++ring) {
    const double cycles = ring * kImageSide / 128.0;
    const double ratio = double(kImageSide * kImageSide) / total / (cycles * cycles);
    sum += std::pow(10.0 * std::log10(ratio), 2.0);
  }
  // 0.3 dB: scatter of the low rings, and smearing by the window and the rings' width.
  CHECK(spectrumDistanceDb(white, pink).value() == Approx(std::sqrt(sum / 61.0)).margin(0.3));
}

TEST_CASE("the autocovariance error of a box-filtered white noise equals a triangle's") {
  constexpr int kImageSide = 512;
  const SrgbImage white = whiteNoise(kImageSide, kImageSide, 8);
  const SrgbImage boxed = makeImage(kImageSide, kImageSide, 1, [&](int x, int y, int) {
    float sum = 0.0f;
    for (int dy = 0; dy < 3; ++dy)
      for (int dx = 0; dx < 3; ++dx)
        sum += *white.pixel((x + dx) % kImageSide, (y + dy) % kImageSide);
    return sum / 9.0f;
  });
  // White noise has 1 at lag 0. The triangle 1, 2/3, 1/3 has squares that sum to 19/9 along a line.
  const double expected = std::sqrt(std::pow(19.0 / 9.0, 2.0) - 1.0);
  CHECK(autocovarianceError(white, boxed, 8).value() == Approx(expected).epsilon(0.03));
  CHECK(autocovarianceError(white, white, 8).value() == 0.0);
}

TEST_CASE("images without variance differ only in their colour") {
  const SrgbImage grey = makeImage(64, 64, 1, [](int, int, int) { return 0.5f; });
  const SrgbImage dark = makeImage(64, 64, 1, [](int, int, int) { return 0.25f; });
  CHECK(colorDistance(grey, dark).value() == Approx(0.25).margin(3e-5));
  CHECK(spectrumDistanceDb(grey, dark).value() == 0.0);
  CHECK(autocovarianceError(grey, dark, 8).value() == 0.0);
  CHECK(autocovarianceError(grey, whiteNoise(64, 64, 9), 8).value() == 1.0);
  CHECK(seamVisibility(grey, dark).value() == 1.0);
  CHECK(latticeVisibility(grey, latticeView()).value() == 0.0);
}

TEST_CASE("lattice visibility agrees with sorting the pixels by their distance") {
  for (const Grain grain : {Grain::none, Grain::x, Grain::y}) {
    const LatticeView view = latticeView(grain);
    const SrgbImage image = latticeModulated(view, 10);
    INFO("grain " << int(grain));
    // 0.01: classes end at one of 4096 steps of distance, not at a pixel.
    CHECK(latticeVisibility(image, view).value() ==
          Approx(slowLatticeVisibility(image, view)).margin(0.01));
  }
}

TEST_CASE("an injected straight seam is found, and none where there is none") {
  const SrgbImage exemplar = powerLawNoise(256, 2.0, 15);
  const SrgbImage clean = powerLawNoise(256, 2.0, 16);
  SrgbImage seamed = clean;
  for (int y = 0; y < 256; ++y)
    for (int x = 128; x < 256; ++x)
      *seamed.pixel(x, y) += 0.1f;
  CHECK(seamVisibility(exemplar, clean).value() == Approx(1.0).margin(0.1));
  CHECK(seamVisibility(exemplar, seamed).value() > 2.0);
  SrgbImage turned = seamed;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      *turned.pixel(x, y) = *seamed.pixel(y, x);
  CHECK(seamVisibility(exemplar, turned).value() == seamVisibility(exemplar, seamed).value());
}

TEST_CASE("a straight step has exactly the height that the seam measure reports") {
  // Two half planes with a difference of 0.2, against 0.1.
  const auto step = [](float height) {
    return makeImage(64, 64, 1, [=](int x, int, int) { return x < 32 ? 0.0f : height; });
  };
  CHECK(seamVisibility(step(0.1f), step(0.2f)).value() == Approx(2.0).epsilon(1e-4));
}

TEST_CASE("the error for images that a measure cannot use states their sizes") {
  const SrgbImage empty;
  const SrgbImage small = whiteNoise(20, 20, 19);
  const SrgbImage large = whiteNoise(100, 100, 20);
  const SrgbImage color = makeImage(100, 100, 3, [](int, int, int) { return 0.5f; });
  const auto refused = [](const Result<double>& result, ErrorKind kind, const std::string& part) {
    REQUIRE(!result.ok());
    CHECK(result.error().kind == kind);
    CHECK(result.error().message.find(part) != std::string::npos);
  };
  refused(colorDistance(empty, large), ErrorKind::badInput, "the exemplar is 0 x 0");
  refused(colorDistance(large, color), ErrorKind::badInput, "expected both grey");
  refused(spectrumDistanceDb(large, small), ErrorKind::badInput, "the result is 20 x 20");
  refused(seamVisibility(small, large), ErrorKind::badInput, "at least 49");
  refused(autocovarianceError(large, large, 26), ErrorKind::usage, "2 to 25");
  refused(latticeVisibility(large, LatticeView{}), ErrorKind::usage, "lattice view");
}

TEST_CASE("the patch distance is 0 for the same patches, and the shift for shifted ones") {
  const SrgbImage image = powerLawNoise(64, 2.0, 1);
  CHECK(patchDistance(image, image) == 0.0);
  SrgbImage shifted = image;
  for (float& value : shifted.values)
    value += 0.05f;
  // A patch moves by 0.05 along each of its axes. The mean square of the projection of that on a
  // random direction is the square of 0.05; 256 directions estimate its root with a deviation of
  // sqrt(2 / 256) / 2 = 4.4 %. Four of them:
  CHECK(patchDistance(image, shifted) == Approx(0.05).epsilon(0.18));
}
