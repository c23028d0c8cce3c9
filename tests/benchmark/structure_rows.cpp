// SPDX-License-Identifier: MIT
// An exemplar that repeats, of those that a bake leaves to tiling, as local random-phase noise with
// a structure and as tiling: what remains of its order.
#include "exemplars.h"
#include "rows.h"
#include "synthesized.h"

#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unsuitable.h>

namespace lichen::bench {
namespace {

constexpr int kExemplarSide = 256, kSide = 1024;
constexpr std::uint32_t kSeeds = 3;

constexpr std::size_t kDirections = 36;
using Directions = std::array<double, kDirections>;

/// How much of the luminance's gradient has each direction; the sum is 1.
Directions directionsOf(const SrgbImage& image) {
  const std::vector<float> plane = luminancePlane(image);
  const auto width = std::size_t(image.width);
  Directions histogram{};
  double sum = 0.0;
  for (std::size_t y = 0; y + 1 < std::size_t(image.height); ++y)
    for (std::size_t x = 0; x + 1 < width; ++x) {
      const float* at = &plane[y * width + x];
      const double right = 0.5 * (double(at[1]) - at[0] + at[width + 1] - at[width]);
      const double down = 0.5 * (double(at[width]) - at[0] + at[width + 1] - at[1]);
      const double turns = std::atan2(down, right) / (2.0 * std::numbers::pi) + 1.0;
      const double magnitude = std::hypot(right, down);
      histogram[std::size_t(turns * kDirections + 0.5) % kDirections] += magnitude;
      sum += magnitude;
    }
  for (double& share : histogram)
    share /= std::max(sum, 1e-30);
  return histogram;
}

/// The distance of the two histograms: phase_error of [LSD23].
double phaseError(const SrgbImage& exemplar, const SrgbImage& result) {
  const Directions wanted = directionsOf(exemplar), found = directionsOf(result);
  double squares = 0.0;
  for (std::size_t k = 0; k < kDirections; ++k)
    squares += std::pow(found[k] - wanted[k], 2.0);
  return std::sqrt(squares);
}

} // namespace

std::vector<Row> structureRows() {
  constexpr double kMostPhase = 0.7, kMostCovariance = 0.8, kMostSeam = 1.1, kMostColor = 0.003;
  std::vector<Row> rows;
  const SrgbImage exemplar = exemplars::planks(kExemplarSide);
  const Bundle noise = localRandomPhaseBundle(exemplar), tiling = bakedBundle(exemplar);
  double phase = 0.0, covariance = 0.0, seam = 0.0, color = 0.0;
  double phaseOfTiling = 0.0, covarianceOfTiling = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const SrgbImage own = synthesized(noise, kSide, seed), tiled = synthesized(tiling, kSide, seed);
    phase += phaseError(exemplar, own) / kSeeds;
    phaseOfTiling += phaseError(exemplar, tiled) / kSeeds;
    covariance += require(autocovarianceError(exemplar, own)) / kSeeds;
    covarianceOfTiling += require(autocovarianceError(exemplar, tiled)) / kSeeds;
    seam += require(seamVisibility(exemplar, own)) / kSeeds;
    color += require(colorDistance(exemplar, own)) / kSeeds;
  }
  const auto& shared = noise.noises[0].as<LocalRandomPhaseNoise>();
  const std::string subject = "structure of planks";
  const std::string note =
      std::to_string(shared.structure.offsets) + " offsets, 256 x 256 -> 1024 x 1024, 3 seeds";
  rows.push_back({subject + ", phase error over tiling's",
                  phase / phaseOfTiling,
                  kMostPhase,
                  "",
                  note,
                  false,
                  {{"own", phase}, {"tiling's", phaseOfTiling}}});
  rows.push_back({subject + ", autocovariance_error over tiling's",
                  covariance / covarianceOfTiling,
                  kMostCovariance,
                  "",
                  note,
                  false,
                  {{"own", covariance}, {"tiling's", covarianceOfTiling}}});
  rows.push_back({subject + ", seam_visibility", seam, kMostSeam, "", note, false, {}});
  rows.push_back({subject + ", color_distance", color, kMostColor, "", note, false, {}});
  return rows;
}

} // namespace lichen::bench
