// SPDX-License-Identifier: MIT
// Mean colour of views, from magnification to one pixel per 100 tiles, against supersampling.
#include "exemplars.h"
#include "rows.h"
#include "synthesized.h"

#include <lichen/noise_evaluator.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace lichen::bench {
namespace {

constexpr int kExemplarSide = 256;
/// Pixels per side of a filtered view, and samples per side of its reference. With a standard
/// deviation of 0.2, the mean of a million samples has an error of 0.0002, a twentieth of the
/// target.
constexpr int kViewSide = 512;
constexpr int kReferenceSide = 1024;
/// The same for textons, whose points cost more: 0.0006.
constexpr int kTextonViewSide = 64;
constexpr int kTextonReferenceSide = 320;
/// Pixel sizes in tiles, from four pixels per texel to one per 100 tiles, in steps of about four.
constexpr std::array<double, 10> kFootprints{1.0 / 1024, 1.0 / 256, 1.0 / 128, 1.0 / 64, 1.0 / 16,
                                             0.25,       1.0,       4.0,       16.0,     100.0};

using Colour = std::array<double, 3>;

/// Mean of f(row, column) over a square grid. Rows run in parallel and are summed in order.
template <class Sample>
Colour gridMean(int side, Sample sample) {
  std::vector<Colour> rows(std::size_t(side), Colour{});
  tbb::parallel_for(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const std::array<float, 4> value = sample(x, y);
      for (std::size_t c = 0; c < 3; ++c)
        rows[std::size_t(y)][c] += double(value[c]);
    }
  });
  Colour mean{};
  for (const Colour& row : rows)
    for (std::size_t c = 0; c < 3; ++c)
      mean[c] += row[c] / (double(side) * double(side));
  return mean;
}

double largestDifference(const Colour& a, const Colour& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

/// The centre of a random texel in a cell of the grid. A single fetch is exact there.
double texelMiddle(int cell, double cellTiles, std::uint32_t random) {
  const double at = (double(cell) + double(random >> 8u) * 0x1.0p-24) * cellTiles;
  return (std::floor(at * kExemplarSide) + 0.5) / kExemplarSide;
}

/// The largest channel difference between a view's mean and the mean of its texels.
double meanColourError(const NoiseEvaluator& noise, double pixelTiles) {
  // Centred on the origin, so that floats resolve half a texel at 25,600 tiles.
  const Colour filtered = gridMean(kViewSide, [&](int x, int y) {
    TileFootprint at;
    at.position = {float((x + 0.5 - kViewSide / 2) * pixelTiles),
                   float((y + 0.5 - kViewSide / 2) * pixelTiles)};
    at.dx = {float(pixelTiles), 0.0f};
    at.dy = {0.0f, float(pixelTiles)};
    return noise.evaluate(0, at);
  });
  const double cell = pixelTiles * kViewSide / kReferenceSide;
  const Colour reference = gridMean(kReferenceSide, [&](int x, int y) {
    const auto random = pcg3d({std::uint32_t(x), std::uint32_t(y), 1u});
    TileFootprint at;
    at.position = {float(texelMiddle(x - kReferenceSide / 2, cell, random[0])),
                   float(texelMiddle(y - kReferenceSide / 2, cell, random[1]))};
    at.dx = {1.0f / kExemplarSide, 0.0f};
    at.dy = {0.0f, 1.0f / kExemplarSide};
    return noise.evaluate(0, at);
  });
  return largestDifference(filtered, reference);
}

/// The same for textons, which are exact at any point.
double textonColourError(const NoiseEvaluator& noise, double pixelTiles) {
  const auto seen = [&](double x, double y, double side) {
    TileFootprint at;
    at.position = {float(x), float(y)};
    at.dx = {float(side), 0.0f};
    at.dy = {0.0f, float(side)};
    return noise.evaluate(0, at);
  };
  const Colour filtered = gridMean(kTextonViewSide, [&](int x, int y) {
    return seen((x + 0.5 - kTextonViewSide / 2) * pixelTiles,
                (y + 0.5 - kTextonViewSide / 2) * pixelTiles, pixelTiles);
  });
  const double cell = pixelTiles * kTextonViewSide / kTextonReferenceSide;
  const Colour reference = gridMean(kTextonReferenceSide, [&](int x, int y) {
    const auto random = pcg3d({std::uint32_t(x), std::uint32_t(y), 1u});
    return seen((x + double(random[0]) * 0x1p-32 - kTextonReferenceSide / 2) * cell,
                (y + double(random[1]) * 0x1p-32 - kTextonReferenceSide / 2) * cell, 0.0);
  });
  return largestDifference(filtered, reference);
}

/// The errors of views of the exemplars.
struct WorstViews {
  void note(const Exemplar& exemplar, const std::array<double, kFootprints.size()>& errors) {
    const auto largest = std::max_element(errors.begin(), errors.end());
    if (*largest > worst) {
      worst = *largest;
      const double texels = kFootprints[std::size_t(largest - errors.begin())] * kExemplarSide;
      where = exemplar.name + " at " + std::to_string(texels) + " texels a pixel";
    }
    ofEach.push_back(*largest);
  }

  std::vector<double> ofEach;
  double worst = 0.0;
  std::string where;
};

} // namespace

std::vector<Row> filterRows() {
  WorstViews tiling, textons;
  for (const Exemplar& exemplar : exemplars256()) {
    std::array<double, kFootprints.size()> errors{};
    const auto tiles = require(NoiseEvaluator::create(bakedBundle(exemplar.image), {}));
    for (std::size_t k = 0; k < errors.size(); ++k)
      errors[k] = meanColourError(*tiles, kFootprints[k]);
    tiling.note(exemplar, errors);
    const auto impacts = require(NoiseEvaluator::create(textonBundle(exemplar.image), {}));
    for (std::size_t k = 0; k < errors.size(); ++k)
      errors[k] = textonColourError(*impacts, kFootprints[k]);
    textons.note(exemplar, errors);
  }
  return {{"mean colour of any view, per channel of light, median exemplar", median(tiling.ofEach),
           0.004, "", "worst of 10 scales each, 1/4 texel to 100 tiles a pixel"},
          {"the same, worst exemplar", tiling.worst, 0.004, "", tiling.where},
          {"the same of textons, median exemplar", median(textons.ofEach), 0.004, "",
           "of support 64; a standard error of the samples is up to 0.0006"},
          {"the same, worst exemplar", textons.worst, 0.004, "", textons.where}};
}

} // namespace lichen::bench
