// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure, and runs an assessment.
#pragma once

#include "exemplar/value_encoding.h"
#include "progress_part.h"

#include <lichen/suitability.h>

#include <string>
#include <string_view>
#include <vector>

namespace lichen::suitability {

/// What helps against a risk.
struct Remedy {
  std::vector<BakeSetting> settings{};
  std::string advice{};
};

/// The text always contains `measured`; it contains `consequence`, and the risk has the remedy,
/// only if the score is a risk.
[[nodiscard]] Risk riskOf(std::string_view name, double score, const std::string& measured,
                          const std::string& consequence, Remedy remedy);

/// Returns the risks that `judge` finds, after checking that the map's values are in range. `judge`
/// may throw Interrupted and std::bad_alloc, which become errors.
template <class Judge>
[[nodiscard]] Result<std::vector<Risk>> assessed(const MapExemplar& map, const Judge& judge) {
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

/// "12 %" for 0.12.
[[nodiscard]] std::string percent(double share);

inline constexpr double kMildScore = 1.0 / 3.0;
inline constexpr double kSevereScore = 2.0 / 3.0;

/// The values of a measure at which a risk becomes mild and severe.
struct Calibration {
  double mild = 0.0;
  double severe = 0.0;
};

// Measured on exemplars that work and on exemplars that fail: docs/decisions/007-verdicts.md.
inline constexpr Calibration kCloudiness{0.1, 0.2};
inline constexpr Calibration kLatticeShare{0.05, 0.15};
inline constexpr Calibration kPhaseCoherence{0.15, 0.3};
inline constexpr Calibration kColorSpacing{10.0, 20.0};
inline constexpr Calibration kSlowVariation{0.03, 0.05};
inline constexpr Calibration kClippedShare{0.02, 0.15};
inline constexpr Calibration kUnevenScale{0.8, 1.6};

/// 0 at 0, linear up to each threshold's score, then approaches 1.
[[nodiscard]] inline double scoreOf(double measure, const Calibration& at) {
  if (measure < at.mild)
    return kMildScore * measure / at.mild;
  if (measure < at.severe)
    return kMildScore + (kSevereScore - kMildScore) * (measure - at.mild) / (at.severe - at.mild);
  return 1.0 - (1.0 - kSevereScore) * at.severe / measure;
}

} // namespace lichen::suitability
