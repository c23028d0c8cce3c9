// SPDX-License-Identifier: MIT
// How well one trial of each method finds the one that looks nearest.
#include "exemplars.h"
#include "rows.h"
#include "synthesized.h"
#include "varied_exemplars.h"

#include <lichen/method_candidate.h>
#include <lichen/method_sheet.h>
#include <lichen/plain_fetches.h>

#include <algorithm>
#include <array>

namespace lichen::bench {
namespace {

constexpr double kExemplars = 2.0;  // of a picture, per side
constexpr std::uint32_t kSeeds = 4; // of the independent measurement

struct Score {
  int agreed = 0, count = 0;
  double overTiling = 0.0; ///< the largest
  std::string worst, disagreements;
  std::array<int, 5> chosen{};
};

double distanceOf(MethodTrial& trial, const MapExemplar& map, std::uint32_t seed) {
  trial.bundle.materials.front()->seed = seed;
  return require(lookOf(trial, map, kExemplars)).distance;
}

void judge(const VariedExemplar& exemplar, Score& score) {
  const MapExemplar map = baseColorMap(exemplar.image);
  // With the commands' defaults.
  std::array<MethodTrial, 5> trials{
      MethodTrial{bakedBundle(exemplar.image), 0.0, kTilingFetches},
      MethodTrial{textonBundle(exemplar.image), 0.0, textonFetches(30.0)},
      MethodTrial{localRandomPhaseBundle(exemplar.image), 0.0, cosineFetches(50, true)},
      MethodTrial{multipleKernelsBundle(exemplar.image), 0.0, kernelFetches(30.0, 0)},
      MethodTrial{quiltingBundle(exemplar.image), 0.0, kQuiltingFetches}};
  std::vector<MethodCandidate> once, independent;
  for (MethodTrial& trial : trials) {
    const Method method = trial.bundle.noises.front().method();
    once.push_back({method, trial.plainFetches, distanceOf(trial, map, 1)});
    double sum = 0.0;
    for (std::uint32_t seed = 2; seed < 2 + kSeeds; ++seed)
      sum += distanceOf(trial, map, seed);
    independent.push_back({method, trial.plainFetches, sum / kSeeds});
  }
  const std::size_t choice = nearestForItsCost(once);
  // A tenth, and what separates two pictures of one noise.
  constexpr double kTenth = 1.1, kChance = 0.001;
  double nearest = independent.front().distance;
  for (const MethodCandidate& candidate : independent)
    nearest = std::min(nearest, candidate.distance);
  const double own = independent[choice].distance;
  const bool agrees = choice == nearestForItsCost(independent) || own <= kTenth * nearest + kChance;
  score.agreed += int(agrees);
  ++score.count;
  ++score.chosen[choice];
  if (const double over = own / independent.front().distance; over > score.overTiling) {
    score.overTiling = over;
    score.worst = exemplar.name;
  }
  if (!agrees)
    score.disagreements += exemplar.name + "; ";
}

Row disagreement(const std::string& what, const Score& score) {
  Row row{what, 1.0 - double(score.agreed) / score.count, 0.1, "",
          "chose tiling, texton, local random phase, kernels, quilting: "};
  for (const int count : score.chosen)
    row.note += std::to_string(count) + " ";
  row.note += "; " + score.disagreements;
  return row;
}

} // namespace

std::vector<Row> methodRows() {
  constexpr int kSide = 128;
  Score tuned, heldBack;
  for (const VariedExemplar& exemplar : variedExemplars(kSide))
    judge(exemplar, exemplar.isHeldBack ? heldBack : tuned);
  return {disagreement("--method auto, share of 30 exemplars where another looks nearer", heldBack),
          disagreement("the same, exemplars used for tuning", tuned),
          {"its distance over that of tiling, worst", heldBack.overTiling, 1.1, "", heldBack.worst},
          {"the same, exemplars used for tuning", tuned.overTiling, 1.1, "", tuned.worst}};
}

} // namespace lichen::bench
