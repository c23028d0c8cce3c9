// SPDX-License-Identifier: MIT
// Every measure of a result against its exemplar, each beside its target.
#pragma once

#include <lichen/image.h>
#include <lichen/quality.h>
#include <lichen/result.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// Upper limits of a result by tiling: what a prototype of the method reached on photographs.
inline constexpr double kColorDistanceTarget = 0.003;
inline constexpr double kSpectrumDistanceTargetDb = 0.6;
inline constexpr double kAnisotropicSpectrumDistanceTargetDb = 1.2;
inline constexpr double kSeamVisibilityTarget = 1.1;
inline constexpr std::string_view kGaussianSpectrumDistanceName = "gaussian_spectrum_distance_db";
/// Of a texton's result against its exemplar's Gaussian texture.
inline constexpr double kGaussianSpectrumDistanceTargetDb = 0.5;
/// Of a texton: a third more than normally distributed values have.
inline constexpr double kFlatnessTarget = 4.0;
/// Of a result that spans kLatticeExemplars a side: a smaller one shows more by chance.
inline constexpr double kLatticeVisibilityTarget = 0.03;
inline constexpr int kLatticeExemplars = 16;

/// One number that tells a result from its exemplar; the smaller, the better.
struct Measure {
  std::string_view name;        ///< as docs/cli.md lists it, such as "color_distance"
  std::string_view unit;        ///< "dB", or empty
  std::string_view meaning;     ///< a sentence without full stop
  std::optional<double> value;  ///< absent where it could not be taken
  std::optional<double> target; ///< upper limit; absent where none is stated
  std::string remark;           ///< why there is no value, or how the target was chosen

  [[nodiscard]] bool isMissed() const { return value && target && *value > *target; }
};

/// color_distance, spectrum_distance_db, autocovariance_error and seam_visibility. A measure that
/// these images are too small for has no value, and a remark that says so.
/// Errors: badInput for images without pixels or one grey and one in colour; resources for memory.
/// Thread-safe, deterministic.
[[nodiscard]] Result<std::vector<Measure>> measureResult(const SrgbImage& exemplar,
                                                         const SrgbImage& result);

/// The same of a result by textons, whose colours and spectrum are not held to a target, since they
/// are those of a Gaussian texture; and gaussian_spectrum_distance_db, to that texture of the
/// exemplar. Errors as above.
[[nodiscard]] Result<std::vector<Measure>> measureGaussianResult(const SrgbImage& exemplar,
                                                                 const SrgbImage& gaussian,
                                                                 const SrgbImage& result);

/// lattice_visibility of a result that spans kLatticeExemplars a side. Errors as its own.
[[nodiscard]] Result<Measure> measureLattice(const SrgbImage& result, const LatticeView& view);

/// How much the gradients of the luminance prefer one direction: the difference of their energies
/// across and along it, over the sum. In [0, 1]: 0 for none, 1 for straight stripes, 0 for an image
/// without variance. Throws std::bad_alloc. Source: coherence of the structure tensor [BG87].
[[nodiscard]] double gradientAnisotropy(const SrgbImage& image);

} // namespace lichen
