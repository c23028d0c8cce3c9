// SPDX-License-Identifier: MIT
// What quilting keeps of the structure of generated photographs, beside tiling of the same
// exemplars, and how often a bake chooses it wrongly.
#include "exemplars.h"
#include "false_joints.h"
#include "patch_distance.h"
#include "repetition.h"
#include "rows.h"
#include "structured_subjects.h"
#include "synthesized.h"

#include <lichen/quality.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <held_back_decisions.h>
#include <optional>

namespace lichen::bench {
namespace {

constexpr std::array<int, 2> kPhotographSides{512, 256};
constexpr int kExemplarsASide = 4;
constexpr std::uint32_t kSeeds = 2;

/// A measure of quilting and what it is compared with, both means over the seeds.
struct Pair {
  double own = 0.0, other = 0.0;
};

/// The measures of one subject. They compare with tiling of the same exemplar, or with a plain
/// repeat of it.
struct Scores {
  Pair covariance, shortCovariance, patches;
  Pair lattice;
  std::optional<Pair> repetition; ///< nothing if no period of the exemplar is known
  double color = 0.0;
  std::optional<FalseJoints> joints;
};

/// The exemplar again and again, from this pixel of it on.
SrgbImage plainRepeat(const SrgbImage& exemplar, int startX, int startY) {
  SrgbImage image(kExemplarsASide * exemplar.width, kExemplarsASide * exemplar.height,
                  exemplar.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(exemplar.pixel((x + startX) % exemplar.width, (y + startY) % exemplar.height),
                  exemplar.channels, image.pixel(x, y));
  return image;
}

/// lattice_visibility of a plain repeat: the mean over several starts, since the lattice meets
/// other cells of each.
double plainLatticeVisibility(const SrgbImage& exemplar, const LatticeView& view) {
  constexpr int kStarts = 4;
  double sum = 0.0;
  for (int k = 0; k < kStarts; ++k) {
    const int startX = k % 2 * exemplar.width / 7, startY = k / 2 * exemplar.height / 8;
    sum += require(latticeVisibility(plainRepeat(exemplar, startX, startY), view));
  }
  return sum / kStarts;
}

SrgbImage resultOf(const Bundle& bundle, const SrgbImage& exemplar, std::uint32_t seed) {
  SynthesisOptions options;
  options.material.seed = seed;
  options.width = kExemplarsASide * exemplar.width;
  options.height = kExemplarsASide * exemplar.height;
  return toSrgb(require(synthesize(bundle, options)));
}

void addToMean(double& mean, double value) { mean += value / kSeeds; }

/// Adds the measures that have a counterpart in tiling.
void addComparison(Scores& scores, const SrgbImage& exemplar, const SrgbImage& own,
                   const SrgbImage& tiled) {
  // The longest support that autocovarianceError() takes: cells are often longer than its default.
  const int support = std::min(exemplar.width, exemplar.height) / 4;
  addToMean(scores.covariance.own, require(autocovarianceError(exemplar, own, support)));
  addToMean(scores.covariance.other, require(autocovarianceError(exemplar, tiled, support)));
  addToMean(scores.shortCovariance.own, require(autocovarianceError(exemplar, own)));
  addToMean(scores.shortCovariance.other, require(autocovarianceError(exemplar, tiled)));
  addToMean(scores.patches.own, patchDistance(exemplar, own));
  addToMean(scores.patches.other, patchDistance(exemplar, tiled));
}

Scores scoresOf(const StructuredSubject& subject) {
  const SrgbImage& exemplar = subject.exemplar;
  const Bundle quilting = quiltingBundle(exemplar), tiling = bakedBundle(exemplar);
  const LatticeView view{infiniteLattice(quilting.noises[0].as<QuiltingNoise>().grain),
                         1.0 / exemplar.width, 1.0 / exemplar.height};
  Scores scores;
  constexpr double kNearlyAPeriod = 0.9;
  if (subject.shortestPeriod > 0.0)
    scores.repetition =
        Pair{0.0, repetitionOfPlainRepeat(exemplar, kNearlyAPeriod * subject.shortestPeriod)};
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const SrgbImage own = resultOf(quilting, exemplar, seed);
    addComparison(scores, exemplar, own, resultOf(tiling, exemplar, seed));
    addToMean(scores.color, require(colorDistance(exemplar, own)));
    if (scores.repetition)
      addToMean(scores.repetition->own, repetition(own, std::min(exemplar.width, exemplar.height)));
    addToMean(scores.lattice.own, require(latticeVisibility(own, view)));
    if (subject.cells.empty())
      continue;
    const FalseJoints joints =
        falseJoints(quilting, subject.cells, exemplar.width, kExemplarsASide, seed);
    if (!scores.joints)
      scores.joints.emplace();
    addToMean(scores.joints->share, joints.share);
    addToMean(scores.joints->inner, joints.inner);
    addToMean(scores.joints->shownCells, joints.shownCells);
  }
  scores.lattice.other = plainLatticeVisibility(exemplar, view);
  return scores;
}

/// One measure over all subjects.
class Measure {
public:
  void add(double value, const std::string& subject, std::vector<Detail> details = {}) {
    entries_.push_back({value, subject, std::move(details)});
  }

  /// Two rows: the median, and the worst with its details and the names of the next ones.
  void append(std::vector<Row>& rows, const std::string& name, double target,
              const std::string& unit = "") const {
    if (entries_.empty())
      return;
    constexpr std::size_t kNames = 4;
    std::vector<Entry> sorted = entries_;
    std::ranges::stable_sort(sorted, std::greater<>(), &Entry::value);
    std::vector<double> values;
    std::string names;
    std::size_t missed = 0;
    for (const Entry& entry : sorted) {
      missed += entry.value > target ? 1 : 0;
      if (values.size() < kNames) {
        char text[96];
        std::snprintf(text, sizeof text, "%s%s %.3g", values.empty() ? "" : ", ",
                      entry.subject.c_str(), entry.value);
        names += text;
      }
      values.push_back(entry.value);
    }
    std::string counts = std::to_string(values.size()) + " exemplars";
    if (target != kNoTarget)
      counts += ", " + std::to_string(missed) + " miss the target";
    rows.push_back({name + ", median", median(values), target, unit, counts, false, {}});
    rows.push_back({"the same, worst", sorted.front().value, target, unit, names, false,
                    sorted.front().details});
  }

private:
  struct Entry {
    double value;
    std::string subject;
    std::vector<Detail> details;
  };
  std::vector<Entry> entries_;
};

double ratioOf(const Pair& pair) { return pair.own / pair.other; }
std::vector<Detail> detailsOf(const Pair& pair, const std::string& other) {
  return {{"own", pair.own}, {other, pair.other}};
}

/// The rows of all structured subjects, of photographs of so many pixels a side.
void appendStructureRows(std::vector<Row>& rows, int side) {
  const std::vector<StructuredSubject> subjects = structuredSubjects(side);
  const std::string of = std::to_string(side) + ": ";
  std::vector<Scores> all(subjects.size());
  // One subject at a time: they take seconds, and unlike times.
  tbb::parallel_for(
      std::size_t(0), all.size(), [&](std::size_t k) { all[k] = scoresOf(subjects[k]); },
      tbb::simple_partitioner());
  constexpr double kFarPatches = 0.1, kPercent = 100.0;
  Measure covariance, floorCovariance, shortCovariance, nearPatches, farPatches;
  Measure joints, color, repetition, lattice;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string& name = subjects[k].name;
    const Scores& scores = all[k];
    const bool isFloor = subjects[k].material == "floor";
    (isFloor ? floorCovariance : covariance)
        .add(ratioOf(scores.covariance), name, detailsOf(scores.covariance, "tiling's"));
    shortCovariance.add(ratioOf(scores.shortCovariance), name,
                        detailsOf(scores.shortCovariance, "tiling's"));
    (scores.patches.other > kFarPatches ? farPatches : nearPatches)
        .add(ratioOf(scores.patches), name, detailsOf(scores.patches, "tiling's"));
    color.add(scores.color, name);
    if (scores.repetition)
      repetition.add(scores.repetition->own - scores.repetition->other, name,
                     detailsOf(*scores.repetition, "exemplar's"));
    lattice.add(ratioOf(scores.lattice), name, detailsOf(scores.lattice, "plain repeat's"));
    if (scores.joints)
      joints.add(kPercent * scores.joints->share, name,
                 {{"% of inner pixels", kPercent * scores.joints->inner},
                  {"% of the result in cells shown", kPercent * scores.joints->shownCells}});
  }
  covariance.append(rows, of + "autocovariance_error over tiling's, a quarter of a side", 0.4);
  floorCovariance.append(rows, of + "the same of floor boards", 0.8);
  shortCovariance.append(rows, of + "the same of all, default support of 32 pixels", kNoTarget);
  farPatches.append(rows, of + "patch_distance over tiling's, where that exceeds 0.1", 0.6);
  nearPatches.append(rows, of + "patch_distance over tiling's, where that is at most 0.1", 1.1);
  joints.append(rows, of + "false joints", 0.5, "%");
  color.append(rows, of + "color_distance", 0.004);
  repetition.append(rows, of + "repetition less the exemplar's", 0.05);
  lattice.append(rows, of + "lattice_visibility over a plain repeat's", 1.1);
}

/// The bound of an error rate of the choice that a bake makes without --method.
Row choiceRow(const std::string& what, const test::ErrorRate& rate) {
  constexpr double kMostErrors = 10.0; // percent
  std::string note;
  for (const std::string& name : rate.wrong)
    note += (note.empty() ? "" : "; ") + name;
  return {what + ", 95 % upper bound",
          100.0 * rate.upperBound(),
          kMostErrors,
          "%",
          note,
          false,
          {{"wrong", double(rate.wrong.size())}, {"pictures", double(rate.pictures)}}};
}

} // namespace

std::vector<Row> quiltingRows() {
  std::vector<Row> rows;
  for (const int side : kPhotographSides)
    appendStructureRows(rows, side);
  rows.push_back(choiceRow("held-back pictures with a structure, not baked by quilting",
                           rateOf(test::structureIsQuilted())));
  rows.push_back(choiceRow("held-back pictures without a structure, baked by quilting",
                           rateOf(test::noStructureIsNotQuilted())));
  return rows;
}

} // namespace lichen::bench
