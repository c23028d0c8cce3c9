// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure, and runs an assessment.
#include "risk_of.h"

#include "calibration.h"
#include "exemplar/map_ranges.h"
#include "progress_part.h"

#include <fmt/format.h>

#include <cmath>

namespace lichen {

std::string_view nameOf(Risk::Level level) {
  switch (level) {
  case Risk::Level::none:
    return "none";
  case Risk::Level::mild:
    return "mild";
  case Risk::Level::severe:
    break;
  }
  return "severe";
}

std::string remedyOf(const Risk& risk, std::string_view optionPrefix) {
  std::vector<std::string> remedies;
  for (const BakeSetting& setting : risk.settings)
    remedies.push_back(fmt::format("{}{} {}", optionPrefix, setting.name, setting.value));
  if (!risk.advice.empty())
    remedies.push_back(risk.advice);
  return fmt::format("{}", fmt::join(remedies, ", or "));
}

} // namespace lichen

namespace lichen::suitability {

Risk riskOf(std::string_view name, double score, const std::string& measured,
            const std::string& consequence, Remedy remedy) {
  if (score < kMildScore)
    return {name, score, Risk::Level::none, measured, {}, {}};
  return {name,
          score,
          score < kSevereScore ? Risk::Level::mild : Risk::Level::severe,
          measured + ", " + consequence,
          std::move(remedy.settings),
          std::move(remedy.advice)};
}

Result<std::vector<Risk>> assessed(const MapExemplar& map,
                                   const std::function<std::vector<Risk>()>& judge) {
  const auto exhausted = [&] {
    return "not enough memory to assess " + std::to_string(map.width) + " x " +
           std::to_string(map.height) + " pixels";
  };
  return withinMemory(exhausted, [&]() -> Result<std::vector<Risk>> {
    if (Result<void> checked = exemplar::checkRanges(map); !checked)
      return checked.error();
    return unlessInterrupted("the assessment",
                             [&]() -> Result<std::vector<Risk>> { return judge(); });
  });
}

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

} // namespace lichen::suitability
