// SPDX-License-Identifier: MIT
// All measures of a result against its exemplar, with their targets.
#pragma once

#include <lichen/image.h>
#include <lichen/quality.h>
#include <lichen/result.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// Upper limits for a tiling result: what a prototype of the method reached on photographs.
inline constexpr double kColorDistanceTarget = 0.003;
inline constexpr double kSpectrumDistanceTargetDb = 0.6;
inline constexpr double kAnisotropicSpectrumDistanceTargetDb = 1.2;
/// The bound between noises that keep an exemplar's features and noises that break them.
/// Source: docs/decisions/007-verdicts.md.
inline constexpr double kAutocovarianceErrorTarget = 0.2;
inline constexpr double kSeamVisibilityTarget = 1.1;
/// Tiles that are cut differ there like unrelated points.
inline constexpr double kCutMismatchTarget = 1.0;
inline constexpr std::string_view kColorDistanceName = "color_distance";
inline constexpr std::string_view kSpectrumDistanceName = "spectrum_distance_db";
inline constexpr std::string_view kAutocovarianceErrorName = "autocovariance_error";
inline constexpr std::string_view kSeamVisibilityName = "seam_visibility";
inline constexpr std::string_view kCutMismatchName = "cut_mismatch";
inline constexpr std::string_view kLatticeVisibilityName = "lattice_visibility";
inline constexpr std::string_view kGaussianSpectrumDistanceName = "gaussian_spectrum_distance_db";
/// Upper limits for a noise of random phases, measured against the Gaussian version of its
/// exemplar.
struct GaussianTargets {
  double spectrumDb;
  double anisotropicSpectrumDb; ///< if the exemplar is strongly anisotropic
  bool hasColors;               ///< whether the noise has the histogram of the exemplar
};
/// For a texton: a third above the flatness of normally distributed values.
inline constexpr double kFlatnessTarget = 4.0;
/// For a result that spans kLatticeExemplars per side; a smaller one scores higher by chance.
inline constexpr double kLatticeVisibilityTarget = 0.03;
inline constexpr int kLatticeExemplars = 16;

/// One number that measures how a result differs from its exemplar; smaller is better.
struct Measure {
  std::string_view name;        ///< as in docs/cli.md, for example "color_distance"
  std::string_view unit;        ///< "dB" or empty
  std::string_view meaning;     ///< a sentence without a full stop
  std::optional<double> value;  ///< absent if it cannot be computed
  std::optional<double> target; ///< upper limit; absent if there is none
  std::string remark;           ///< why the value is absent, or how the target was chosen

  [[nodiscard]] bool isMissed() const { return value && target && *value > *target; }
};

/// Computes color_distance, spectrum_distance_db, autocovariance_error and seam_visibility. A
/// measure has no value, and a remark, if the images are too small for it.
/// Errors: badInput for images without pixels, or one in grey and one in colour; resources if
/// memory runs out. Thread-safe, deterministic.
[[nodiscard]] Result<std::vector<Measure>> measureResult(const SrgbImage& exemplar,
                                                         const SrgbImage& result);

/// Computes the same measures for the result of a noise of random phases, and
/// gaussian_spectrum_distance_db, its distance to the exemplar's Gaussian version `gaussian`. Its
/// spectrum has no other target, and colours have one only where they are the exemplar's. Errors:
/// as measureResult().
[[nodiscard]] Result<std::vector<Measure>> measureGaussianResult(const SrgbImage& exemplar,
                                                                 const SrgbImage& gaussian,
                                                                 const SrgbImage& result,
                                                                 const GaussianTargets& targets);

/// Computes lattice_visibility of a result that spans kLatticeExemplars per side. Errors: as
/// latticeVisibility().
[[nodiscard]] Result<Measure> measureLattice(const SrgbImage& result, const LatticeView& view);

/// The direction that gradients prefer.
struct GradientDirection {
  /// The difference of their energies along the direction and across it, divided by the sum. In
  /// [0, 1]: 0 for no preference or a plane without variance, 1 for straight stripes.
  double anisotropy = 0.0;
  double angle = 0.0; ///< radians, in [-pi / 2, pi / 2], from x to y, which points down
};
/// Measures it over a plane of width * height values. Source: structure tensor [BG87], of gradients
/// by the operator of [S00].
[[nodiscard]] GradientDirection gradientDirection(std::span<const float> plane, int width,
                                                  int height);
/// The anisotropy of the luminance. Throws std::bad_alloc.
[[nodiscard]] double gradientAnisotropy(const SrgbImage& image);

} // namespace lichen
