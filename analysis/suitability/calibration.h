// SPDX-License-Identifier: MIT
// Risk thresholds, and the score of a measure.
#pragma once

namespace lichen::suitability {

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

/// Above this, slow variation is an object with an outline, not light. The geometric mean of 3.3,
/// the largest value of light and clouds, and 5.4, the smallest value of objects, in
/// docs/decisions/006-light-and-grain.md.
inline constexpr double kEdgeConcentration = 4.2;

/// The deviation from which patches of the exemplar's size are visible, in sRGB codes from 0 to 1,
/// and their share of all deviation that shows from afar, which hides fainter ones. Measured by
/// looking, docs/decisions/006-light-and-grain.md.
inline constexpr double kVisiblePatches = 0.004;
inline constexpr double kVisiblePatchShare = 0.2;

/// How much further than the third strongest place something that occurs once stands out. The
/// geometric mean of 2.4 and 3.0 in docs/decisions/005-exemplar.md.
inline constexpr double kOutlier = 2.7;

/// The least difference of an outlier from its surroundings, in sRGB codes from 0 to 1, root mean
/// square over the channels: 2.5 codes of 8 bits.
inline constexpr double kVisibleOutlier = 0.01;

/// The shortest period of uneven light, as a share of the exemplar's longer side: faster variation
/// is the material itself.
inline constexpr double kShortestLight = 1.0 / 8.0;

/// 0 at 0, linear up to each threshold's score, then approaches 1.
[[nodiscard]] inline double scoreOf(double measure, const Calibration& at) {
  if (measure < at.mild)
    return kMildScore * measure / at.mild;
  if (measure < at.severe)
    return kMildScore + (kSevereScore - kMildScore) * (measure - at.mild) / (at.severe - at.mild);
  return 1.0 - (1.0 - kSevereScore) * at.severe / measure;
}

} // namespace lichen::suitability
