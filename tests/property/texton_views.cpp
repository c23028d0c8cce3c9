// SPDX-License-Identifier: MIT
// Texton noise as it is seen: from near and far, at any contrast, and on a floor that recedes,
// against supersampling; its spectrum against its own Gaussian model.
#include "sampling/level_kept.h"
#include "sampling/repeating_image.h"
#include "synthetic_texton.h"
#include "texton/impacts.h"

#include <lichen/quality.h>
#include <lichen/texton.h>
#include <lichen/texton_evaluate.h>

#include <catch2/catch.hpp>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <materials.h>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

using Colour = std::array<double, 3>;

Bundle bakedBundle(const SrgbImage& image, int order = 1) {
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.width = image.width;
  map.height = image.height;
  map.values.assign(image.values.begin(), image.values.end());
  TextonOptions options;
  options.support = 32;
  options.order = order;
  Result<TextonBake> bake = bakeTexton("exemplar", {&map, 1}, options);
  REQUIRE(bake);
  Bundle bundle;
  bundle.noises.push_back(std::move(bake.value().noise));
  bundle.tables = std::move(bake.value().tables);
  return bundle;
}

/// A noise with one material, and its twin.
struct View {
  explicit View(Bundle of, double contrast = 1.0)
      : bundle(std::move(of)), twin(TextonEvaluator::create(bundle, 0).value()) {
    MaterialNoise material;
    material.contrast = contrast;
    noise = shaderNoise(bundle, material, {});
    texton = shaderTexton(bundle, material, {});
  }

  /// Light at a place seen through a pixel with these sides. [tiles]
  [[nodiscard]] Colour at(double x, double y, double width, double height) const {
    TileFootprint place;
    place.position = {float(x), float(y)};
    place.dx = {float(width), 0.0f};
    place.dy = {0.0f, float(height)};
    const auto value = twin.evaluate(0, noise, texton, place);
    return {double(value[0]), double(value[1]), double(value[2])};
  }

  Bundle bundle;
  TextonEvaluator twin;
  shader::LichenNoise noise;
  shader::LichenTexton texton;
};

/// Mean of sample(x, y) over a square grid, rows in parallel and summed in order.
template <class Sample>
Colour gridMean(int side, const Sample& sample) {
  std::vector<Colour> rows(std::size_t(side), Colour{});
  tbb::parallel_for(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const Colour value = sample(x, y);
      for (std::size_t c = 0; c < 3; ++c)
        rows[std::size_t(y)][c] += value[c];
    }
  });
  Colour mean{};
  for (const Colour& row : rows)
    for (std::size_t c = 0; c < 3; ++c)
      mean[c] += row[c] / (double(side) * double(side));
  return mean;
}

/// The largest difference of a channel between the mean of a view's pixels and that of points in
/// them.
double meanColourError(const View& view, double pixelTiles) {
  constexpr int kPixels = 64;
  constexpr int kSamples = 320; // a side: at a deviation of 0.2 their mean is off by 0.0006
  const Colour filtered = gridMean(kPixels, [&](int x, int y) {
    return view.at((x + 0.5 - kPixels / 2) * pixelTiles, (y + 0.5 - kPixels / 2) * pixelTiles,
                   pixelTiles, pixelTiles);
  });
  const double cell = pixelTiles * kPixels / kSamples;
  const Colour sampled = gridMean(kSamples, [&](int x, int y) {
    const auto random = pcg3d({std::uint32_t(x), std::uint32_t(y), 1u});
    const double u = (double(random[0]) + 0.5) * 0x1p-32, v = (double(random[1]) + 0.5) * 0x1p-32;
    return view.at((x + u - kSamples / 2) * cell, (y + v - kSamples / 2) * cell, 0.0, 0.0);
  });
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    largest = std::max(largest, std::abs(filtered[c] - sampled[c]));
  return largest;
}

} // namespace

TEST_CASE("the mean colour of any view, from magnified to one pixel per 100 tiles, is that of its "
          "points",
          "[large]") {
  constexpr int kSide = 128;
  struct Exemplar {
    SrgbImage (*generate)(int);
    int order;
  };
  constexpr double kTarget = 0.004; // TARGETS.md
  // Rust's red is of fine flakes and its blue of wide stains: each channel has its own losses.
  for (const auto& [generate, order] :
       {Exemplar{exemplars::granite, 3}, Exemplar{exemplars::moss, 0},
        Exemplar{exemplars::rust, 1}}) {
    const View view(bakedBundle(generate(kSide), order));
    for (const double pixelTiles :
         {0.25 / kSide, 1.0 / kSide, 2.8 / kSide, 8.0 / kSide, 0.25, 1.0, 10.0, 100.0}) {
      INFO("order " << order << ", " << pixelTiles << " tiles a pixel");
      CHECK(meanColourError(view, pixelTiles) < kTarget);
    }
  }
}

TEST_CASE("contrast above one keeps the mean colour of far views, though more is hidden than the "
          "whole variance") {
  const View view(bakedBundle(exemplars::moss(128)), 2.0);
  for (const double pixelTiles : {8.0 / 128, 1.0, 100.0}) {
    INFO(pixelTiles << " tiles a pixel");
    CHECK(meanColourError(view, pixelTiles) < 0.004);
  }
}

namespace {

/// Statistics of a channel over many pixels of one size, filtered and supersampled.
struct Seen {
  double filteredMean = 0.0, sampledMean = 0.0;
  double filteredVariance = 0.0, sampledVariance = 0.0;
};

/// Of pixels far from each other, `width` x `height` texels of a tile of `side`, in green light.
Seen seenThrough(const View& view, double width, double height, int side) {
  constexpr int kPixels = 40; // a side
  constexpr int kSamples = 5; // of a pixel's points, along each axis, twice
  struct Pixel {
    double filtered = 0.0;
    std::array<double, 2> sampled{};
  };
  std::vector<Pixel> pixels(kPixels * kPixels);
  tbb::parallel_for(0, kPixels * kPixels, [&](int k) {
    const double u = 1.37 * (k % kPixels), v = 1.61 * (k / kPixels); // tiles
    const double w = width / side, h = height / side;
    Pixel& pixel = pixels[std::size_t(k)];
    pixel.filtered = view.at(u, v, w, h)[1];
    for (std::uint32_t set = 0; set < 2; ++set)
      for (int j = 0; j < kSamples * kSamples; ++j) {
        const auto random = pcg3d({std::uint32_t(k), std::uint32_t(j), set});
        const double x = (j % kSamples + double(random[0]) * 0x1p-32) / kSamples - 0.5;
        const double y = (j / kSamples + double(random[1]) * 0x1p-32) / kSamples - 0.5;
        pixel.sampled[set] += view.at(u + x * w, v + y * h, 0.0, 0.0)[1] / (kSamples * kSamples);
      }
  });
  Seen seen;
  const double count = kPixels * kPixels;
  for (const Pixel& pixel : pixels) {
    seen.filteredMean += pixel.filtered / count;
    seen.sampledMean += 0.5 * (pixel.sampled[0] + pixel.sampled[1]) / count;
  }
  for (const Pixel& pixel : pixels) {
    seen.filteredVariance += std::pow(pixel.filtered - seen.filteredMean, 2) / count;
    // Two sets of points, whose own chance is not in their covariance.
    seen.sampledVariance +=
        (pixel.sampled[0] - seen.sampledMean) * (pixel.sampled[1] - seen.sampledMean) / count;
  }
  return seen;
}

} // namespace

TEST_CASE(
    "a floor that recedes has the mean and about the variance of its supersampled pixels, seen "
    "from above and at a grazing angle",
    "[large]") {
  constexpr int kSide = 128;
  const View view(bakedBundle(exemplars::moss(kSide)));
  for (const double distance : {0.7, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0})
    for (const double slant : {1.0, 4.0}) {
      const Seen seen = seenThrough(view, distance, distance * slant, kSide);
      INFO("pixels of " << distance << " x " << distance * slant << " texels");
      const double ratio = seen.filteredVariance / seen.sampledVariance;
      CHECK(seen.filteredMean == Approx(seen.sampledMean).margin(0.004));
      // From 0.77, beyond the last mip, to 1.13 measured; mips are averages over squares, and at a
      // slant of 4 it is 0.48 to 0.95. The variance of 1600 pixels is known to 4 %.
      CHECK(ratio < 1.3);
      CHECK(ratio > (slant > 1.0 ? 0.4 : 0.65));
    }
}

TEST_CASE("midway between two mips textons keep the variance that the two mips tell") {
  // White coefficients under a bell, and ever smoother ones.
  for (const int smoothings : {0, 1, 3, 10, 30}) {
    const SyntheticTexton source{.coefficientsX = 40,
                                 .coefficientsY = 40,
                                 .mipLevels = 4,
                                 .channels = 1,
                                 .wholeFloats = true,
                                 .smoothings = smoothings};
    const Bundle bundle = syntheticTextonBundle(source).bundle;
    const shader::LichenMap map = shaderMap(bundle, bundle.noises[0], 0);
    const RepeatingImage image(bundle.tables[0]);
    const auto energy = [&](float level) {
      constexpr int kSamples = 480; // a side, 10 a texel
      double sum = 0.0;
      for (int k = 0; k < kSamples * kSamples; ++k)
        sum += std::pow(double(image.at(float(k % kSamples + 0.5) / kSamples,
                                        float(k / kSamples + 0.5) / kSamples, level)[0]),
                        2);
      return sum;
    };
    const double whole = energy(0.0f);
    for (const float level : {0.5f, 1.5f, 2.25f}) {
      const double kept = energy(level) / whole;
      INFO("smoothings " << smoothings << ", level " << level << ", kept " << kept);
      // Up to 3.6 %, and the rounding of small amplitudes to bytes.
      CHECK(double(textonKept(map, level)[0]) == Approx(kept).epsilon(0.045));
    }
  }
}

TEST_CASE("each channel of a view keeps what its own losses leave, beyond the last mip too") {
  constexpr int kSide = 128;
  const View view(bakedBundle(exemplars::rust(kSide)));
  const NoiseMap& map = view.bundle.noises[0].maps[0];
  for (const std::size_t level : {1u, 2u, 5u}) {
    // Textons are fetched half a level below the footprint's (docs/decisions/018).
    const float pixel = std::exp2(float(level) + 0.5f) / float(kSide);
    constexpr int kPlaces = 64; // a side, further apart than textons reach
    std::array<double, 3> variance{};
    for (int k = 0; k < kPlaces * kPlaces; ++k) {
      TileFootprint at;
      at.position = {1.37f * float(k % kPlaces), 1.61f * float(k / kPlaces)};
      at.dx = {pixel, 0.0f};
      at.dy = {0.0f, pixel};
      const auto value = view.twin.gaussian(0, view.noise, view.texton, at);
      for (std::size_t c = 0; c < 3; ++c)
        variance[c] += 36.0 * std::pow(double(value[c]) - 0.5, 2) / (kPlaces * kPlaces);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      INFO("level " << level << ", channel " << c);
      const double kept = 1.0 - lossRow(map.mipLoss, c, 3)[level];
      // Five standard errors of 4,096 values of a kurtosis up to 4, sqrt(3 / 4096) each, and the
      // steps of the amplitudes' bytes.
      CHECK(variance[c] == Approx(kept).epsilon(0.14).margin(std::sqrt(kept) / 255.0));
    }
  }
}

TEST_CASE("a cell has its number however far it is, modulo 2^32 or in its period") {
  shader::LichenNoise noise{};
  shader::LichenTexton texton{};
  texton.texelsPerTileX = texton.texelsPerTileY = 16384.0f;
  texton.coefficientsX = texton.coefficientsY = 1;
  texton.frameX = texton.frameY = 2;
  texton.mipCount = 1;
  noise.columnsPerTile = noise.rowsPerTile = 49152.0f; // 3 cells a texel
  for (const std::int32_t period : {0, 7, 49152 * 5, 1 << 29})
    for (const std::int64_t tiles : {0ll, 1ll, -1ll, 43691ll, -65537ll, 1ll << 27, -(1ll << 27)}) {
      noise.periodColumns = noise.periodRows = period;
      noise.cellI = noise.cellJ = period == 0 ? 0x7fffffff : 3;
      TileFootprint at;
      at.position = {float(tiles), float(-tiles)};
      const texton::Impacts here = texton::impactsWithin(0.0f, at, noise, texton);
      at.position = {0.0f, 0.0f};
      const texton::Impacts origin = texton::impactsWithin(0.0f, at, noise, texton);
      for (std::size_t k = 0; k < 2; ++k) {
        const std::int64_t moved =
            std::int64_t(origin.firstCell[k]) + (k == 0 ? tiles : -tiles) * 49152;
        const std::int64_t modulus = period == 0 ? std::int64_t(1) << 32 : period;
        INFO("period " << period << ", tiles " << tiles);
        CHECK(std::int64_t(here.firstCell[k]) == (moved % modulus + modulus) % modulus);
      }
    }
}

TEST_CASE("the spectrum of texton noise with 30 impacts is that of its Gaussian model", "[large]") {
  constexpr int kSide = 256;
  for (const auto generate : {exemplars::moss, exemplars::granite}) {
    const SrgbImage exemplar = generate(kSide);
    const View view(bakedBundle(exemplar));
    const NoiseMap& map = view.bundle.noises[0].maps[0];
    SrgbImage result(kSide, kSide, 3);
    tbb::parallel_for(0, kSide, [&](int y) {
      for (int x = 0; x < kSide; ++x) {
        TileFootprint at;
        at.position = {float(x + 0.5) / kSide, float(y + 0.5) / kSide};
        const auto value = view.twin.gaussian(0, view.noise, view.texton, at);
        for (std::size_t c = 0; c < 3; ++c)
          result.pixel(x, y)[c] = float(map.mean[c] + map.scale[c] * (double(value[c]) - 0.5));
      }
    });
    // A generated exemplar is its own periodic component: its model is itself with random phases.
    const Result<SrgbImage> model = phaseRandomized(exemplar, 3);
    REQUIRE(model);
    const Result<double> distance = spectrumDistanceDb(model.value(), result);
    REQUIRE(distance);
    CHECK(distance.value() < 0.5); // TARGETS.md
  }
}
