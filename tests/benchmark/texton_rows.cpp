// SPDX-License-Identifier: MIT
// Textons: the time of a bake, the distance from the model compared with the papers' algorithm, and
// the visibility of their borders. See docs/decisions/008-textons.md.
#include "../property/papers_texton.h"
#include "exemplars.h"
#include "rows.h"
#include "synthesized.h"

#include <lichen/spectrum.h>
#include <lichen/texton_mix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <materials.h>
#include <texton/border_penalty.h>
#include <texton/coefficients.h>
#include <texton/fit.h>
#include <texton/gaussian_model.h>

namespace lichen::bench {
namespace {

using namespace texton;

MapExemplar crop(const SrgbImage& image, int side) {
  SrgbImage part(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      std::copy_n(image.pixel(x, y), 3, part.pixel(x, y));
  return baseColorMap(part);
}

texton::GaussianModel modelOf(const MapExemplar& map) {
  return texton::gaussianModel(map.values, map.width, map.height, int(map.channels.size()));
}

/// With the model's covariance, like the authors' own textons.
TextonCoefficients corrected(const texton::GaussianModel& model, TextonCoefficients texton,
                             int order) {
  if (!correctCovariance(texton, order, texton::modelCovariance(model)))
    std::fprintf(stderr, "lichen-bench: a texton without its model's covariance\n");
  return texton;
}

FitOptions fitOptions(int support, int order) {
  FitOptions options;
  options.width = options.height = support - order;
  options.order = order;
  return options;
}

TextonCoefficients fitted(const texton::GaussianModel& model, int support, int order) {
  return corrected(model, fitCoefficients(model, fitOptions(support, order)), order);
}

MethodBake bakedTexton(const MapExemplar& map, const TextonOptions& options) {
  return require(bakeTexton("benchmark", {&map, 1}, options));
}

void appendTimes(std::vector<Row>& rows) {
  constexpr int kRuns = 5;
  const std::array<std::pair<int, double>, 2> sizes{{{128, 0.05}, {768, 1.0}}};
  for (const auto& [width, target] : sizes) {
    MapExemplar map = baseColorMap(exemplars::rust(width));
    map.height = std::min(width, 512);
    map.values.resize(std::size_t(map.width) * std::size_t(map.height) * map.channels.size());
    const std::string size = std::to_string(map.width) + " x " + std::to_string(map.height);
    rows.push_back({"texton of " + size + " RGB: model, fit and colours",
                    medianSeconds(kRuns, [&] { return fitted(modelOf(map), 64, 1); }), target, "s",
                    "rust, support 64, median of 5"});
    rows.push_back({"the whole bake, with the table",
                    medianSeconds(kRuns, [&] { return bakedTexton(map, {}); }), target, "s",
                    "rust, median of 5"});
  }
}

/// A mix of two exemplars: the path between them should take little time compared with their bakes.
void appendMixTime(std::vector<Row>& rows) {
  constexpr int kRuns = 5;
  const std::array<MixedExemplar, 2> exemplars{{{"rust", {baseColorMap(exemplars::rust(256))}},
                                                {"moss", {baseColorMap(exemplars::moss(256))}}}};
  const double each = medianSeconds(kRuns, [&] { return bakedTexton(exemplars[0].maps[0], {}); }) +
                      medianSeconds(kRuns, [&] { return bakedTexton(exemplars[1].maps[0], {}); });
  const auto mix = [&] { return require(bakeTextonMix("benchmark", exemplars, {})); };
  rows.push_back({"mix of two textons of 256 x 256 RGB, 21 steps", medianSeconds(kRuns, mix), each,
                  "s", "rust and moss, median of 5; the target is the bakes of both"});
}

/// Compared with the papers' algorithm at the same size and support.
void appendFits(std::vector<Row>& rows, const std::vector<Exemplar>& exemplars, int side,
                int support, double target) {
  Measured ratios, flatnesses, borders, papersBorders;
  for (const Exemplar& exemplar : exemplars) {
    const texton::GaussianModel model = modelOf(crop(exemplar.image, side));
    const TextonCoefficients ours = fitted(model, support, 1);
    const TextonCoefficients papers =
        corrected(model, test::papersTexton(model, fitOptions(support, 1)), 1);
    ratios.note(relativeModelError(model, ours, 1) / relativeModelError(model, papers, 1),
                exemplar.name);
    flatnesses.note(flatness(ours, kLuminanceWeights), exemplar.name);
    borders.note(borderVisibility(ours), exemplar.name);
    papersBorders.note(borderVisibility(papers), exemplar.name);
  }
  const std::string where =
      " at " + std::to_string(support) + " of " + std::to_string(side) + " texels";
  ratios.append(rows, "texton model error over the papers'" + where, target, "", "");
  flatnesses.append(rows, "flatness" + where, 4.0, "", "");
  borders.append(rows, "visibility of the border" + where, median(papersBorders.values), "",
                 "; the target is the median of the papers' textons");
}

/// Piecewise constant and cubic splines; the bilinear ones are above.
void appendOrders(std::vector<Row>& rows, const std::vector<Exemplar>& exemplars) {
  for (const int order : {0, 3}) {
    Measured flatnesses;
    for (const Exemplar& exemplar : exemplars)
      flatnesses.note(
          flatness(fitted(modelOf(crop(exemplar.image, 128)), 32, order), kLuminanceWeights),
          exemplar.name);
    flatnesses.append(rows, "flatness of order " + std::to_string(order) + " at 32 of 128 texels",
                      4.0, "", "");
  }
}

void appendCovarianceErrors(std::vector<Row>& rows, const std::vector<Exemplar>& exemplars) {
  Measured floats, halves;
  TextonOptions options;
  for (const Exemplar& exemplar : exemplars) {
    MapExemplar map = crop(exemplar.image, 128);
    if (&exemplar == &exemplars.front()) // grey, for which the authors' code fails
      for (std::size_t i = 0; i < map.values.size(); i += 3)
        map.values[i + 1] = map.values[i + 2] = map.values[i];
    options.bits = 16;
    floats.note(bakedTexton(map, options).figures.quality.covarianceError, exemplar.name);
    options.bits = 8;
    halves.note(bakedTexton(map, options).figures.quality.covarianceError, exemplar.name);
  }
  floats.append(rows, "texton covariance error, 32-bit texels", 1e-6, "", ", one made grey");
  // Each texel a has a uniform error of at most 2^-11 a, and C = a^T B a has an error of twice the
  // sum of a (B a) times these errors. Its standard deviation relative to C is 2 2^-11 / sqrt(3 n)
  // times the root of the flatness, 2 at most, times |a| |B a| / (a^T B a), by Kantorovich's
  // inequality at most 5/3 for eigenvalues of B between 1/9 and 1. The limit is four standard
  // deviations.
  const double coefficients = double(options.support - 1) * double(options.support - 1);
  halves.append(rows, "the same, half floats",
                4.0 * 2.0 * std::exp2(-11) / std::sqrt(3.0 * coefficients) * 2.0 * 5.0 / 3.0, "",
                "; the target is what their rounding explains");
}

} // namespace

std::vector<Row> textonRows() {
  std::vector<Row> rows;
  appendTimes(rows);
  appendMixTime(rows);
  const std::vector<Exemplar> exemplars = exemplars256();
  appendFits(rows, exemplars, 128, 16, 0.985);
  appendFits(rows, exemplars, 128, 32, 0.985);
  appendFits(rows, exemplars, 128, 64, 0.93);
  for (const int support : {16, 32, 64})
    appendFits(rows, exemplars, 256, support, 1.0);
  appendOrders(rows, exemplars);
  appendCovarianceErrors(rows, exemplars);
  return rows;
}

} // namespace lichen::bench
