// SPDX-License-Identifier: MIT
// A quilting noise and its exemplar -> risks and measures.
#include "../method_report.h"
#include "suitability/risk_of.h"

#include <lichen/quilting.h>
#include <lichen/regularity.h>

#include <algorithm>

namespace lichen {
namespace {

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress&) {
  constexpr double kNone = 0.0, kMild = 0.5;
  double score = kNone;
  std::string reason = "only the first map is searched for what repeats";
  if (assessed.place == 0 &&
      std::min(assessed.map().width, assessed.map().height) < kLeastRegularSide) {
    reason = "the exemplar is too small to show whether it repeats";
  } else if (assessed.place == 0) {
    const Result<Regularity> regularity =
        regularityOf(assessed.maps, assessed.bordersFit ? Periodic::yes : Periodic::no);
    if (!regularity)
      return regularity.error();
    const bool isClear = regularity.value().isClear();
    score = isClear ? kNone : kMild;
    reason = isClear ? "the exemplar repeats or has clear outlines"
                     : "the exemplar neither repeats nor has clear outlines";
  }
  return std::vector<Risk>{
      suitability::riskOf("cuts", score, reason, "and its noise looks cut into pieces",
                          {{{"method", std::string(nameOf(Method::tiling))}}, {}})};
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  if (Result<void> taken = take(measureResult(comparison.exemplar, comparison.result), comparison);
      !taken)
    return taken;
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  const Result<std::optional<double>> mismatch = cutMismatch(result.bundle, noise, result.map);
  if (!mismatch)
    return mismatch.error();
  comparison.measures.push_back({kCutMismatchName, "", "how different tiles are where they are cut",
                                 mismatch.value(), kCutMismatchTarget,
                                 mismatch.value() ? "" : "the exemplar has no outlines"});
  return {};
}

} // namespace

extern const MethodReport kQuiltingReport{.assess = assess, .measure = measure};

} // namespace lichen
