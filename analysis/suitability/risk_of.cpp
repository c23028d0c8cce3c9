// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure.
#include "risk_of.h"

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

std::string plainWords(const BakeSetting& setting) {
  return setting.value.empty() ? std::string(setting.name)
                               : fmt::format("{} {}", setting.name, setting.value);
}

std::string remedyOf(const Risk& risk, SettingWords words) {
  std::vector<std::string> remedies;
  for (const BakeSetting& setting : risk.settings)
    remedies.push_back(words(setting));
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

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

} // namespace lichen::suitability
