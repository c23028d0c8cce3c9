// SPDX-License-Identifier: MIT
// A baked noise -> its risks, measures and verdict.
#include "bake_verdict.h"

#include "bake_risks.h"
#include "progress_line.h"

#include <nlohmann/json.hpp>

namespace lichen::cli {

Result<BakeVerdict> judgeNoise(const Bundle& bundle, const MaterialNoise& material,
                               std::span<const MapExemplar> maps, Periodic borders,
                               bool bordersWereKept, const SharedOptions& options) {
  constexpr double kAssessment = 0.6; // of the progress, by processor time
  ProgressLine line("judge", options);
  const Progress progress = line.asProgress();
  Result<std::vector<std::vector<Risk>>> assessed =
      assessNoise(bundle.noises[material.noise], maps, borders, partOf(progress, 0.0, kAssessment));
  if (!assessed)
    return assessed.error();
  Result<std::vector<Measure>> measures =
      measureNoise(bundle, material, maps.front(), partOf(progress, kAssessment, 1.0));
  if (!measures)
    return measures.error();
  BakeVerdict judged{std::move(assessed).value(), std::move(measures).value(), {}};
  std::vector<JudgedMap> all;
  for (std::size_t m = 0; m < maps.size(); ++m)
    all.push_back(
        {maps[m].target, judged.assessed[m],
         m == 0 ? std::span<const Measure>(judged.measures) : std::span<const Measure>()});
  judged.verdict = verdictOn(all, bordersWereKept);
  return judged;
}

std::string verdictLine(const Verdict& verdict, bool severalMaps) {
  return "verdict: " + sentenceOf(verdict, severalMaps, optionOf);
}

nlohmann::ordered_json jsonOf(const Verdict& verdict) {
  return {{"level", nameOf(verdict.level)},
          {"map", nameOf(verdict.map)},
          {"risk", verdict.worst.name},
          {"score", verdict.worst.score},
          {"sentence", sentenceOf(verdict, true, optionOf)}};
}

} // namespace lichen::cli
