// SPDX-License-Identifier: MIT
// Risks and measures -> a verdict. Limits: docs/decisions/007-verdicts.md.
#include "suitability/risk_of.h"

#include <lichen/noise_verdict.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lichen {
namespace {

using namespace suitability;

/// The values of a measure at which viewers see the fault, and at which it is plain. A target is
/// what the method reaches, which is mostly less than anyone sees.
struct Fault {
  std::string_view measure;
  Calibration visible;
  std::string_view words;       ///< with a place for the value
  std::string_view consequence; ///< what people see
};

constexpr std::array<Fault, 4> kFaults{{
    {kColorDistanceName,
     {0.006, 0.02},
     "its colours are {:.3f} of the range from the photograph's",
     "which shows as another tint"},
    {kAutocovarianceErrorName,
     {kAutocovarianceErrorTarget, 0.35},
     "its features differ in size or direction from the photograph's by {:.2f}",
     "because they are larger than the tiles, or in an order"},
    {kSeamVisibilityName,
     {1.25, 1.6},
     "its straight edges are {:.1f} times the photograph's",
     "which show as seams"},
    {kCutMismatchName,
     {kCutMismatchTarget, 2.0},
     "where two tiles meet, they differ {:.1f} times as much as two unrelated points",
     "so that bricks or stones lose pieces"},
}};

Risk riskOfMeasure(const Measure& measure, bool bordersWereKept) {
  const auto* const fault = std::ranges::find(kFaults, measure.name, &Fault::measure);
  if (fault == kFaults.end() || !measure.value || !measure.target)
    return riskOf(measure.name, 0.0, "", "", {});
  Remedy remedy{{}, "a photograph that shows more of the material"};
  if (measure.name == kSeamVisibilityName)
    remedy = bordersWereKept ? Remedy{{{"periodic", "no"}}, {}} : Remedy{{}, "an image that tiles"};
  if (measure.name == kCutMismatchName)
    remedy.advice = "a photograph of more regular bricks or stones, from straight in front, or the "
                    "corners of a part with whole periods";
  return riskOf(measure.name, scoreOf(*measure.value, fault->visible),
                fmt::format(fmt::runtime(fault->words), *measure.value),
                std::string(fault->consequence), remedy);
}

} // namespace

Verdict verdictOn(std::span<const JudgedMap> maps, bool bordersWereKept) {
  Verdict verdict;
  for (const JudgedMap& map : maps)
    for (const Risk& risk : map.risks)
      if (risk.score > verdict.worst.score)
        verdict = {Verdict::Level(risk.level), map.target, risk};
  // A risk says why, so at the same level it comes before a measure.
  for (const JudgedMap& map : maps)
    for (const Measure& measure : map.measures)
      if (Risk fault = riskOfMeasure(measure, bordersWereKept); fault.level > verdict.worst.level)
        verdict = {Verdict::Level(fault.level), map.target, std::move(fault)};
  return verdict;
}

std::string_view nameOf(Verdict::Level level) {
  constexpr std::array<std::string_view, 3> kNames{"good", "acceptable", "unsuitable"};
  return kNames[std::size_t(level)];
}

std::string sentenceOf(const Verdict& verdict, bool severalMaps, SettingWords words) {
  if (verdict.level == Verdict::Level::good)
    return std::string(nameOf(verdict.level));
  const Risk& worst = verdict.worst;
  const std::string remedy = worst.settings.empty() ? worst.advice : words(worst.settings.front());
  return fmt::format("{}: {}{}{}{}", nameOf(verdict.level),
                     severalMaps ? std::string(nameOf(verdict.map)) + ": " : "", worst.sentence,
                     remedy.empty() ? "" : "; what helps: ", remedy);
}

} // namespace lichen
