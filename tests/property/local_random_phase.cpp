// SPDX-License-Identifier: MIT
// Local random-phase noise: its windows, its spectrum and its statistics against closed forms and
// against the Gaussian version of the exemplar.
#include "bundle_of.h"
#include "example_exemplar.h"
#include "statistics_of_maps.h"

#include <lichen/local_random_phase.h>
#include <lichen/quality.h>
#include <lichen/spectrum.h>
#include <lichen/tiling.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <local_random_phase/cosine_fit.h>
#include <local_random_phase/cosine_vectors.h>
#include <local_random_phase/octave_lattice.h>
#include <numbers>
#include <random>

using namespace lichen;
using namespace lichen::local_random_phase;

namespace {

constexpr int kTexels = 128;

const Bundle& example() {
  static const Bundle bundle = [] {
    const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
    return test::bundleOf(bakeLocalRandomPhase("example", {&map, 1}, {}));
  }();
  return bundle;
}

/// The Gaussian channels of a square of `side` texels.
std::vector<std::vector<float>> gaussianPlanes(const Bundle& bundle, std::uint32_t seed, int side) {
  const auto evaluator = methodEvaluator(bundle, 0);
  MaterialNoise material;
  material.seed = seed;
  const shader::LichenTriplanarMaterial constants = shaderMaterial(bundle, material, {});
  std::vector<std::vector<float>> planes(3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const TileFootprint at{
          {(float(x) + 0.5f) / float(kTexels), (float(y) + 0.5f) / float(kTexels)}, {}, {}};
      const auto value = evaluator->gaussian(0, constants, at).value;
      for (std::size_t c = 0; c < 3; ++c)
        planes[c].push_back(6.0f * (value[c] - 0.5f));
    }
  return planes;
}

/// The matrix by which stored values follow the example's Gaussian ones, to the first order.
Eigen::Matrix3d toStored() {
  const Eigen::Matrix3d covariance(example().noises[0].maps[0].covariance.data());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).operatorSqrt();
}

/// How the luminance follows them: stored values are roots of light.
Eigen::Vector3d luminanceOfGaussian() {
  const Eigen::Vector3d mean(example().noises[0].maps[0].mean.data());
  return toStored() * Eigen::Vector3d(0.2126, 0.7152, 0.0722).cwiseProduct(mean);
}

} // namespace

TEST_CASE("the squares of the windows sum to 1") {
  std::mt19937 generator(1u);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  double largest = 0.0;
  for (int k = 0; k < 100000; ++k) {
    const auto windows = windowsAt(place(generator), place(generator));
    double squares = 0.0;
    for (const double weight : windows.weight)
      squares += weight * weight;
    largest = std::max(largest, std::abs(squares - 1.0));
  }
  CHECK(largest < 1e-6);
}

TEST_CASE("the correlation of the windows equals the correlation of random samples") {
  const WindowSpectrum spectrum;
  CHECK(spectrum.correlation(0.0, 0.0) == Approx(1.0));
  CHECK(spectrum.correlation(0.0, 1.74) == 0.0);
  std::mt19937 generator(2u);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (const std::array<double, 2>& lag : {std::array{0.01, 0.0}, std::array{0.3, 0.2},
                                           std::array{-0.5, 0.6}, std::array{0.1, -1.1}}) {
    const double down = lag[1] * 2.0 / std::numbers::sqrt3, across = lag[0] - 0.5 * down;
    constexpr int kSamples = 200000;
    double sum = 0.0;
    for (int sample = 0; sample < kSamples; ++sample) {
      const double column = place(generator), row = place(generator);
      const double i = std::floor(column + across), j = std::floor(row + down);
      const auto here = windowsAt(column, row),
                 there = windowsAt(column + across - i, row + down - j);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
          if (here.corner[a][0] == there.corner[b][0] + int(i) &&
              here.corner[a][1] == there.corner[b][1] + int(j))
            sum += here.weight[a] * there.weight[b] / kSamples;
    }
    INFO(lag[0] << ", " << lag[1]);
    // The products deviate by at most 1/2: four standard errors.
    CHECK(spectrum.correlation(lag[0], lag[1]) == Approx(sum).margin(0.0045));
  }
}

TEST_CASE("boxes of equal power find the rectangles of a plane that has them") {
  PowerPlane power{64, 127, std::vector<double>(64 * 127, 1.0)};
  const std::array<FrequencyBox, 3> wanted{{{0, 10, -8, 9}, {20, 31, 20, 40}, {40, 50, -50, -30}}};
  const std::array<double, 3> levels{50.0, 9.0, 4.0};
  for (std::size_t k = 0; k < wanted.size(); ++k)
    for (int v = wanted[k].top; v < wanted[k].bottom; ++v)
      for (int u = wanted[k].left; u < wanted[k].right; ++u)
        power.values[std::size_t((v + 63) * 64 + u)] = levels[k];
  const std::vector<FrequencyBox> boxes = boxesOfEqualPower(power, 100);
  CHECK(boxes.size() < 30); // no further split gains anything
  double area = 0.0;
  for (const FrequencyBox& box : boxes) {
    area += double(box.right - box.left) * double(box.bottom - box.top);
    for (int v = box.top; v < box.bottom; ++v)
      for (int u = box.left; u < box.right; ++u)
        CHECK(power.at(u, v) == power.at(box.left == 0 && box.top == 0 ? box.right - 1 : box.left,
                                         box.left == 0 && box.top == 0 ? box.bottom - 1 : box.top));
  }
  CHECK(area == 64.0 * 127.0);
}

TEST_CASE("fitted cosines have the spectrum's variance and its autocovariance") {
  // The periodogram of a texture: power laws, times the squares that chance makes of it.
  constexpr int kHalf = 64;
  PowerPlane power{kHalf, 2 * kHalf - 1, {}};
  std::mt19937 generator(4u);
  std::exponential_distribution<double> chance(1.0);
  double variance = 0.0;
  for (int v = 1 - kHalf; v < kHalf; ++v)
    for (int u = 0; u < kHalf; ++u) {
      power.values.push_back(chance(generator) / std::pow(4.0 + u * u + 2.0 * v * v, 1.4));
      if (u != 0 || v != 0)
        variance += (u == 0 ? 1.0 : 2.0) * power.values.back();
    }
  const std::array<double, 2> edges = edgesOfOctave0(7, 8);
  CHECK(edges[0] == Approx(edges[1]).epsilon(0.011)); // the triangles of 7 and 8 are equilateral
  const std::vector<Cosine> cosines =
      fitCosines(power, boxesOfEqualPower(smoothed(power), 50), edges, false);
  const WindowSpectrum window;
  const auto sinc = [](double x) {
    return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
  };
  double difference = 0.0, whole = 0.0;
  for (int y = 0; y < 32; ++y)
    for (int x = -31; x < 32; ++x) {
      const double s = x / (2.0 * kHalf), t = y / (2.0 * kHalf); // [tiles]
      double wanted = 0.0, found = 0.0;
      for (int v = 1 - kHalf; v < kHalf; ++v)
        for (int u = 0; u < kHalf; ++u)
          if (u != 0 || v != 0)
            wanted += (u == 0 ? 1.0 : 2.0) * power.at(u, v) *
                      std::cos(2.0 * std::numbers::pi * (u * s + v * t));
      for (const Cosine& cosine : cosines) {
        const FrequencyBox& box = cosine.box;
        const double edgesPerTile = std::ldexp(1.0, cosine.octave);
        if (cosine.energy > 0.0)
          found += cosine.energy *
                   window.correlation(s / edges[0] * edgesPerTile, t / edges[1] * edgesPerTile) *
                   sinc(box.width() * s) * sinc(box.height() * t) *
                   std::cos(std::numbers::pi *
                            ((box.low() + box.high()) * s + (box.lowRow() + box.highRow()) * t));
      }
      difference += (found - wanted) * (found - wanted);
      whole += wanted * wanted;
      if (x == 0 && y == 0) {
        CHECK(wanted == Approx(variance));
        CHECK(found == Approx(variance).epsilon(0.01)); // smoothing changes it
      }
    }
  INFO(std::sqrt(difference / whole));
  CHECK(std::sqrt(difference / whole) < 0.12); // 0.23 of the spectrum's rows alone
}

TEST_CASE("local random-phase noise has the covariance of Gaussian values, and one variance "
          "everywhere") {
  constexpr int kSide = 256, kSeeds = 16;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  // The squared values by the place in the cells of an octave, all seeds together.
  const auto& shared = example().noises[0].as<LocalRandomPhaseNoise>();
  // Four classes of as many pixels each, by the greatest window: 1 at a vertex.
  constexpr std::size_t kClasses = 4;
  std::vector<double> greatest;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double y = (double(i / kSide) + 0.5) / kTexels, x = (double(i % kSide) + 0.5) / kTexels;
    const double row = y * shared.rows / 8.0, column = x * shared.columns / 8.0 - 0.5 * row;
    const auto windows = windowsAt(column - std::floor(column), row - std::floor(row));
    greatest.push_back(*std::max_element(windows.weight.begin(), windows.weight.end()));
  }
  std::vector<double> sorted = greatest;
  std::sort(sorted.begin(), sorted.end());
  std::array<double, kClasses> sums{}, counts{};
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const auto planes = gaussianPlanes(example(), seed, kSide);
    for (std::size_t i = 0; i < planes[0].size(); ++i) {
      const Eigen::Vector3d value(planes[0][i], planes[1][i], planes[2][i]);
      covariance += value * value.transpose() / (kSeeds * double(planes[0].size()));
      const auto below = std::lower_bound(sorted.begin(), sorted.end(), greatest[i]);
      const std::size_t place = std::size_t(below - sorted.begin()) * kClasses / sorted.size();
      sums[place] += value.squaredNorm() / 3.0;
      counts[place] += 1.0;
    }
  }
  // Exactly, of the vectors: half the mean of their products over the variants.
  const Table& table =
      example().tables[example().noises[0].maps[0].as<LocalRandomPhaseMap>().cosines];
  const auto texels = cosineTexels(decodeLevel(table, 0), CosineImageLayout(shared));
  Eigen::Matrix3d exact = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (i % table.width >= kCosineColumns)
      for (const CosineTexel& own : texels[i]) {
        const Eigen::Vector3d vector(own[0], own[1], own[2]);
        exact += 36.0 * vector * vector.transpose() / (2.0 * shared.variants);
      }
  // Rounding to 8 significant bits, at most 2^-8 of each factor, which 200 vectors average out.
  CHECK((exact - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 2e-3);
  // The targets: 3 % over 16 seeds, and one variance everywhere to 1.5 %. Measured 0.6 % and 0.7 %.
  CHECK((covariance - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 0.03);
  const double mean = covariance.trace() / 3.0;
  for (std::size_t k = 0; k < kClasses; ++k) {
    INFO("class " << k << " of " << counts[k]);
    CHECK(sums[k] / counts[k] == Approx(mean).epsilon(0.015));
  }
}

TEST_CASE("all variants of a cosine change the luminance equally much") {
  // Otherwise a few cosines dominate at each vertex, and strokes along their waves show.
  const Bundle& bundle = example();
  const auto& shared = bundle.noises[0].as<LocalRandomPhaseNoise>();
  const auto& map = bundle.noises[0].maps[0].as<LocalRandomPhaseMap>();
  const auto texels =
      cosineTexels(decodeLevel(bundle.tables[map.cosines], 0), CosineImageLayout(shared));
  const std::size_t columns = 1 + std::size_t(shared.variants);
  const Eigen::Vector3f luminance = luminanceOfGaussian().cast<float>();
  for (std::size_t row = 0; row < texels.size() / columns; ++row)
    for (std::size_t k = 0; k < kRowCosines; ++k) {
      const auto amplitude = [&](std::size_t column) {
        return std::abs(luminance.dot(
            Eigen::Map<const Eigen::Vector3f>(texels[row * columns + column][k].data())));
      };
      for (std::size_t column = 2; column < columns; ++column)
        CHECK(amplitude(column) == Approx(amplitude(1)).epsilon(0.02).margin(1e-4)); // bfloat16
    }
}

TEST_CASE("constant, grey and tiny exemplars have local random-phase noises too") {
  MapExemplar constant = test::threeMaterials(32, 32, 1);
  std::fill(constant.values.begin(), constant.values.end(), 0.25f);
  const Bundle flat = test::bundleOf(bakeLocalRandomPhase("flat", {&constant, 1}, {}));
  const auto evaluator = methodEvaluator(flat, 0);
  const shader::LichenTriplanarMaterial material = shaderMaterial(flat, MaterialNoise(), {});
  const auto value = evaluator->evaluate(0, material, TileFootprint{{0.3f, 0.7f}, {}, {}});
  for (std::size_t c = 0; c < 3; ++c) // 0.25 of sRGB
    CHECK(value[c] == Approx(0.0508761).margin(2e-3));

  for (const std::array<int, 2>& size :
       {std::array{1, 1}, std::array{1, 5}, std::array{2, 2}, std::array{7, 3}}) {
    const MapExemplar tiny = test::threeMaterials(size[0], size[1], 1);
    const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("tiny", {&tiny, 1}, {}));
    const auto noise = methodEvaluator(bundle, 0);
    const shader::LichenTriplanarMaterial constants = shaderMaterial(bundle, MaterialNoise(), {});
    for (const float component : noise->evaluate(0, constants, TileFootprint{{0.3f, 0.7f}, {}, {}}))
      CHECK(std::isfinite(component));
  }
  LocalRandomPhaseOptions options;
  options.cosines = 0;
  CHECK_FALSE(bakeLocalRandomPhase("none", {&constant, 1}, options));
  options.cosines = kMostCosines + 1;
  CHECK_FALSE(bakeLocalRandomPhase("many", {&constant, 1}, options));
}

TEST_CASE("the noise has the colours of the exemplar, whatever its structure") {
  constexpr int kSide = 64;
  const MapExemplar map = test::threeMaterials(kSide, kSide, 3);
  SrgbImage exemplar(kSide, kSide, 3);
  exemplar.values = map.values;
  for (const double structure : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    LocalRandomPhaseOptions options;
    options.structure = structure;
    const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("example", {&map, 1}, options));
    const Result<double> distance =
        colorDistance(exemplar, toSrgb(test::synthesized(bundle, MapTarget::baseColor, 4)));
    REQUIRE(distance);
    INFO("structure " << structure);
    CHECK(distance.value() < 0.02); // measured 0.008 to 0.013
  }
}
