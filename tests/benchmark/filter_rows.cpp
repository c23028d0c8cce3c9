// SPDX-License-Identifier: MIT
// Mean colour of views from magnified to one pixel per 100 tiles, against supersampling.
#include "exemplars.h"
#include "rows.h"

#include <lichen/tiling_evaluate.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace lichen::bench {
namespace {

constexpr int kExemplarSide = 256;
/// Pixels a side of a filtered view, and samples a side of its reference: at a standard deviation
/// of 0.2 the sum of a million samples is off by 0.0002, a twentieth of the target.
constexpr int kViewSide = 512;
constexpr int kReferenceSide = 1024;
/// Pixels in tiles, from four to a texel to one per 100 tiles, in steps of about four.
constexpr std::array<double, 10> kFootprints{1.0 / 1024, 1.0 / 256, 1.0 / 128, 1.0 / 64, 1.0 / 16,
                                             0.25,       1.0,       4.0,       16.0,     100.0};

using Colour = std::array<double, 3>;

/// Mean of f(row, column) over a square grid, rows in parallel and summed in order.
template <class Sample>
Colour gridMean(int side, Sample sample) {
  std::vector<Colour> rows(std::size_t(side), Colour{});
  tbb::parallel_for(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const TilingEvaluator::Value value = sample(x, y);
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

/// The middle of a texel of a random pixel of the grid's cell: there one fetch is exact.
double texelMiddle(int cell, double cellTiles, std::uint32_t random) {
  const double at = (double(cell) + double(random >> 8u) * 0x1.0p-24) * cellTiles;
  return (std::floor(at * kExemplarSide) + 0.5) / kExemplarSide;
}

/// The largest difference of a channel between a view's mean and the mean of its texels.
double meanColourError(const TilingEvaluator& evaluator, const shader::LichenNoise& noise,
                       double pixelTiles) {
  // Centred on the origin: floats then resolve half a texel at 25,600 tiles.
  const Colour filtered = gridMean(kViewSide, [&](int x, int y) {
    TileFootprint at;
    at.position = {float((x + 0.5 - kViewSide / 2) * pixelTiles),
                   float((y + 0.5 - kViewSide / 2) * pixelTiles)};
    at.dx = {float(pixelTiles), 0.0f};
    at.dy = {0.0f, float(pixelTiles)};
    return evaluator.evaluate(0, noise, at);
  });
  const double cell = pixelTiles * kViewSide / kReferenceSide;
  const Colour reference = gridMean(kReferenceSide, [&](int x, int y) {
    const auto random = pcg3d({std::uint32_t(x), std::uint32_t(y), 1u});
    TileFootprint at;
    at.position = {float(texelMiddle(x - kReferenceSide / 2, cell, random[0])),
                   float(texelMiddle(y - kReferenceSide / 2, cell, random[1]))};
    at.dx = {1.0f / kExemplarSide, 0.0f};
    at.dy = {0.0f, 1.0f / kExemplarSide};
    return evaluator.evaluate(0, noise, at);
  });
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    largest = std::max(largest, std::abs(filtered[c] - reference[c]));
  return largest;
}

} // namespace

std::vector<Row> filterRows() {
  std::vector<double> worstOfEach;
  double worst = 0.0;
  std::string where;
  for (const Exemplar& exemplar : exemplars256()) {
    const Bundle bundle = bakedBundle(exemplar.image);
    const Result<TilingEvaluator> evaluator = TilingEvaluator::create(bundle, 0);
    if (!evaluator) {
      std::fprintf(stderr, "lichen-bench: %s\n", evaluator.error().message.c_str());
      std::exit(int(evaluator.error().kind));
    }
    const shader::LichenNoise noise = shaderNoise(bundle, MaterialNoise{}, {});
    double worstHere = 0.0;
    for (const double pixelTiles : kFootprints) {
      const double error = meanColourError(evaluator.value(), noise, pixelTiles);
      worstHere = std::max(worstHere, error);
      if (error > worst) {
        worst = error;
        where =
            exemplar.name + " at " + std::to_string(pixelTiles * kExemplarSide) + " texels a pixel";
      }
    }
    worstOfEach.push_back(worstHere);
  }
  return {{"mean colour of any view, per channel of light, median exemplar", median(worstOfEach),
           0.004, "", "worst of 10 scales each, 1/4 texel to 100 tiles a pixel"},
          {"the same, worst exemplar", worst, 0.004, "", where}};
}

} // namespace lichen::bench
