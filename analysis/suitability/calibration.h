// SPDX-License-Identifier: MIT
// From what is measured of an exemplar to a score, and the thresholds.
#pragma once

namespace lichen::suitability {

inline constexpr double kMildScore = 1.0 / 3.0;
inline constexpr double kSevereScore = 2.0 / 3.0;

/// The measures at which a risk begins to be mild and severe.
struct Calibration {
  double mild = 0.0;
  double severe = 0.0;
};

// Measured on exemplars that work and that fail: docs/decisions/013-suitability.md.
inline constexpr Calibration kCloudiness{0.1, 0.2};
inline constexpr Calibration kLatticeShare{0.05, 0.15};
inline constexpr Calibration kPhaseCoherence{0.15, 0.3};
inline constexpr Calibration kColorSpacing{10.0, 20.0};
inline constexpr Calibration kSlowVariation{0.03, 0.05};
inline constexpr Calibration kClippedShare{0.02, 0.15};

/// Above it, slow variation is an object with an outline, which --flatten auto leaves: the
/// geometric middle of 3.3, the most of light and clouds, and 5.4, the least of objects, in 013.
inline constexpr double kEdgeConcentration = 4.2;

/// The shortest period that --flatten auto takes, of the exemplar's longer side: what is faster is
/// the material.
inline constexpr double kShortestAutoPeriod = 1.0 / 8.0;

/// 0 at 0, linear to the thresholds' scores, then towards 1 for ever.
[[nodiscard]] inline double scoreOf(double measure, const Calibration& at) {
  if (measure < at.mild)
    return kMildScore * measure / at.mild;
  if (measure < at.severe)
    return kMildScore + (kSevereScore - kMildScore) * (measure - at.mild) / (at.severe - at.mild);
  return 1.0 - (1.0 - kSevereScore) * at.severe / measure;
}

} // namespace lichen::suitability
