// SPDX-License-Identifier: MIT
// Derivatives of heights, for bumps, against central differences of the evaluated values, of every
// method that has them; of tiling and quilting they are 0.
#include "bundle_of.h"
#include "example_exemplar.h"
#include "synthetic_texton.h"

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/noise_evaluator.h>
#include <lichen/quilting.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kTexels = 64; // sides of a tile
using Evaluator = std::unique_ptr<const NoiseEvaluator>;

/// A sum of squared differences of slopes, and of squared slopes.
struct Differences {
  double errors = 0.0, squares = 0.0;

  void add(double found, double expected) {
    errors += (found - expected) * (found - expected);
    squares += expected * expected;
  }
  [[nodiscard]] double relative() const { return std::sqrt(errors / squares); }
};

/// The relative error of derivatives beside differences over 2 `step` [tiles], of pixels of this
/// side [texels]. Points and steps are sums of few powers of two, so that no position is rounded
/// before the evaluation.
double errorOf(const Evaluator& noise, float sideTexels, float step) {
  std::mt19937 generator(4u);
  std::uniform_int_distribution<int> place(-1 << 15, 1 << 15);
  Differences differences;
  for (int k = 0; k < 300; ++k) {
    const float side = sideTexels / kTexels;
    const TileFootprint at{{std::ldexp(float(place(generator)), -14), // up to 2 tiles
                            std::ldexp(float(place(generator)), -14)},
                           {side, 0.0f},
                           {0.0f, side}};
    const std::array<float, 3> gradient = noise->evaluateGradient(0, at);
    CHECK(double(gradient[0]) == Approx(double(noise->evaluate(0, at)[0])).margin(1e-6));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      TileFootprint before = at, after = at;
      before.position[axis] -= step;
      after.position[axis] += step;
      differences.add(double(gradient[1 + axis]), (double(noise->evaluate(0, after)[0]) -
                                                   double(noise->evaluate(0, before)[0])) /
                                                      (2.0 * double(step)));
    }
  }
  return differences.relative();
}

MapExemplar exampleHeight() {
  MapExemplar height = threeMaterials(kTexels, kTexels, 3);
  for (std::size_t i = 0; i < height.values.size() / 3; ++i)
    height.values[i] = 0.3f + 0.4f * height.values[3 * i];
  height.values.resize(height.values.size() / 3);
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.encoding = ValueEncoding::linear;
  return height;
}

Bundle cosinesWith(double structure) {
  const MapExemplar height = exampleHeight();
  LocalRandomPhaseOptions options;
  options.bits = 16;
  options.structure = options.guide = structure;
  options.turbulence = 0.05;
  return bundleOf(bakeLocalRandomPhase("cosines", {&height, 1}, options));
}

Bundle kernelsWith(KernelWindow window) {
  const MapExemplar height = exampleHeight();
  MultipleKernelsOptions options;
  options.bits = 16;
  options.window = window;
  options.perturbation.emplace();
  options.perturbation->cosines = 5;
  Bundle bundle = bundleOf(bakeMultipleKernels("kernels", {&height, 1}, options));
  bundle.noises[0].as<MultipleKernelsNoise>().rings = 1; // the last kernel, of any frequency
  return bundle;
}

/// With values about 1/2 that no clamp reaches, in place of the inverse table.
template <class Map>
Bundle withoutTable(Bundle bundle) {
  bundle.noises[0].maps[0].mean = {0.5};
  bundle.noises[0].maps[0].covariance = {0.0025};
  bundle.noises[0].maps[0].as<Map>().inverseTable.reset();
  return bundle;
}

/// With a table whose value is U itself, so that it has no corners within four deviations.
template <class Map>
Bundle withSmoothTable(Bundle bundle) {
  REQUIRE(bundle.noises[0].maps[0].as<Map>().inverseTable);
  Table& table = bundle.tables[*bundle.noises[0].maps[0].as<Map>().inverseTable];
  table.texels.clear();
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    const auto cells = table.width >> level;
    std::vector<float> ramp;
    for (std::uint32_t i = 0; i < cells; ++i)
      ramp.insert(ramp.end(), std::size_t(channelCount(table.format)),
                  (float(i) + 0.5f) / float(cells));
    appendTexels(table.texels, table.format, ramp);
  }
  return bundle;
}

Evaluator evaluatorOf(const Bundle& bundle, const Placement& placement = {}) {
  MaterialNoise material;
  material.rotation = 0.5; // derivatives are along the tile's axes
  material.offset = {0.25, -1.5};
  material.contrast = 1.2;
  return NoiseEvaluator::create(bundle, material, placement).value();
}

/// Positions in cells are rounded to 2^-23 tiles, by which differences are off by 0.1 to 0.2 %.
/// Waves of up to 32 cycles a tile bend by (2 pi 32 2^-14)^2 / 6, 3e-5.
constexpr float kSmallStep = 1.0f / 16384.0f;

} // namespace

TEST_CASE("derivatives of cosines are those of their values, with a table and without one") {
  const Bundle bundle = cosinesWith(0.0);
  for (const float side : {0.0f, 2.0f}) {
    // The polynomial of the cosine has a derivative that is off by 0.06 % in the mean square.
    // Tables have differences over an eighth of the deviation, off by (1/96)^2 / 6 of 36 (z^2 - 1):
    // 0.07 %.
    CHECK(errorOf(evaluatorOf(withoutTable<LocalRandomPhaseMap>(bundle)), side, kSmallStep) < 4e-3);
    CHECK(errorOf(evaluatorOf(withSmoothTable<LocalRandomPhaseMap>(bundle)), side, kSmallStep) <
          4e-3);
  }
}

TEST_CASE("derivatives of a structure are differences over half its texel") {
  Bundle bundle = cosinesWith(1.0);
  const auto& shared = bundle.noises[0].as<LocalRandomPhaseNoise>();
  REQUIRE(shared.structure.columns == kTexels);
  // Takes the cosines away: they are the columns after the first.
  Table& image = bundle.tables[bundle.noises[0].maps[0].as<LocalRandomPhaseMap>().cosines];
  std::vector<float> texels = decodeLevel(image, 0);
  for (std::size_t row = 0; row < std::size_t(shared.cosineCount()) / 2; ++row)
    std::fill_n(texels.begin() + std::ptrdiff_t(4 * (row * image.width + 1)), 4 * shared.variants,
                0.0f);
  image.texels.clear();
  appendTexels(image.texels, image.format, texels);
  for (const float side : {0.0f, 3.0f}) // the same differences: rounding alone
    CHECK(errorOf(evaluatorOf(withoutTable<LocalRandomPhaseMap>(bundle)), side,
                  0.25f / float(shared.structure.columns)) < 1e-4);
}

TEST_CASE(
    "derivatives of kernels are those of their values, with a table, a period and a pattern") {
  for (const KernelWindow window :
       {KernelWindow::gabor, KernelWindow::sinc, KernelWindow::gaussianSinc}) {
    const Bundle bundle = kernelsWith(window);
    Placement placement;
    placement.periodic = window == KernelWindow::sinc;
    placement.periodTilesX = 2.5;
    placement.periodTilesY = 1.25;
    INFO(nameOf(window));
    const Bundle plain = withoutTable<MultipleKernelsMap>(bundle);
    const Bundle table = withSmoothTable<MultipleKernelsMap>(bundle);
    for (const Bundle& each : {plain, table})
      for (const float side : {0.0f, 2.0f})
        // As of cosines; and a sinc ends with a corner, which one in some hundred differences
        // meets.
        CHECK(errorOf(evaluatorOf(each, placement), side, kSmallStep) <
              (window == KernelWindow::sinc ? 1e-2 : 4e-3));
  }
}

TEST_CASE("derivatives of textons that are minified or of order 1 are differences over a texel") {
  for (const auto& [order, level] : {std::pair(1, 0.0f), std::pair(1, 0.5f), std::pair(1, 2.0f),
                                     std::pair(3, 1.0f), std::pair(3, 1.5f), std::pair(0, 1.0f)}) {
    const Bundle bundle = syntheticTextonBundle({.order = order,
                                                 .texelsPerTileY = kTexels,
                                                 .channels = 1,
                                                 .wholeFloats = true,
                                                 .deviation = 0.03})
                              .bundle;
    INFO("order " << order << ", level " << level);
    // A fetch is half a level finer than the pixel's side, or half of it below a side of two
    // texels.
    const float side = std::exp2(level < 0.5f ? 2.0f * level : level + 0.5f);
    // The same differences: rounding alone, of positions by 2^-23 tiles in steps of 2^-7.
    CHECK(errorOf(evaluatorOf(bundle), side, 0.5f * std::exp2(level) / kTexels) < 1e-4);
  }
}

TEST_CASE("derivatives of a mix of textons of order 3, magnified, scaled and rotated, are those of "
          "its values") {
  Bundle bundle =
      syntheticTextonBundle(
          {.order = 3, .steps = 3, .channels = 1, .wholeFloats = true, .deviation = 0.02})
          .bundle;
  NoiseMap& map = bundle.noises[0].maps[0];
  map.mean = {0.2};
  map.as<TextonMap>().laterSteps[0].mean = {0.4};
  map.as<TextonMap>().laterSteps[1].mean = {0.7};
  MaterialNoise material;
  material.scale = 0.4;
  material.rotation = 0.7;
  material.offset = {0.3, 1.6};
  // As steep as the textons: 0.5 in half a tile.
  material.mix = {.source = MixSource::direction, .start = {-0.1, 0.0}, .end = {0.1, 0.05}};
  const Evaluator noise = NoiseEvaluator::create(bundle, material).value();
  const double c = std::cos(material.rotation), s = std::sin(material.rotation);
  const Eigen::Matrix2d toTile = Eigen::Matrix2d{{c, s}, {-s, c}} / material.scale;
  const Eigen::Vector2d start(material.mix.start.data());
  const Eigen::Vector2d way = Eigen::Vector2d(material.mix.end.data()) - start;
  const Eigen::Vector2d perUv = way / way.squaredNorm();
  const Eigen::Vector2f perTile = (toTile.transpose().inverse() * perUv).cast<float>();
  const auto valueAt = [&](const Eigen::Vector2d& uv) {
    return double(noise->evaluateUv(0, {{float(uv[0]), float(uv[1])}, {}, {}})[0]);
  };
  std::mt19937 generator(8u);
  std::uniform_real_distribution<double> place(-0.15, 0.15);
  Differences differences;
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d uv(place(generator), place(generator));
    const double weight = (uv - start).dot(perUv);
    if (std::abs(2.0 * weight - std::round(2.0 * weight)) < 0.02)
      continue; // within a step of a weight at which the mean's slope jumps
    const Eigen::Vector2f tile = (toTile * uv).cast<float>();
    const std::array<float, 3> found = noise->evaluateGradient(
        0, {{tile[0], tile[1]}, {}, {}}, {float(weight), {perTile[0], perTile[1]}});
    CHECK(double(found[0]) == Approx(valueAt(uv)).margin(1e-5));
    const Eigen::Vector2d alongUv =
        toTile.transpose() * Eigen::Vector2d(double(found[1]), double(found[2]));
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      // A sixteenth of a texel. Third derivatives of cubic splines of unrelated coefficients are
      // root mean square 5.5 times their first ones, so curvature adds 5.5 / (6 * 16^2), 0.4 %.
      const double step = material.scale / (16.0 * kTexels);
      const Eigen::Vector2d away = step * Eigen::Vector2d::Unit(axis);
      differences.add(alongUv[axis], (valueAt(uv + away) - valueAt(uv - away)) / (2.0 * step));
    }
  }
  CHECK(differences.relative() < 6e-3);
}

TEST_CASE("tiling and quilting have values without derivatives") {
  const MapExemplar height = exampleHeight();
  const TileFootprint at{{0.3f, -0.7f}, {0.01f, 0.0f}, {0.0f, 0.01f}};
  for (const Bundle& bundle : {bundleOf(bakeTiling("tiling", {&height, 1}, {})),
                               bundleOf(bakeQuilting("quilting", {&height, 1}, {}))}) {
    const Evaluator noise = evaluatorOf(bundle);
    CHECK(noise->evaluateGradient(0, at) == std::array{noise->evaluate(0, at)[0], 0.0f, 0.0f});
  }
}
