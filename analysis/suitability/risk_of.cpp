// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure, and runs an assessment.
#include "risk_of.h"

#include "calibration.h"
#include "exemplar/map_ranges.h"
#include "progress_part.h"

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

} // namespace lichen

namespace lichen::suitability {

Risk riskOf(std::string_view name, double score, const std::string& measured,
            const std::string& consequence, std::string remedy) {
  if (score < kMildScore)
    return {name, score, Risk::Level::none, measured, {}};
  return {name, score, score < kSevereScore ? Risk::Level::mild : Risk::Level::severe,
          measured + ", " + consequence, std::move(remedy)};
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
