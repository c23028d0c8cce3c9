// SPDX-License-Identifier: MIT
// The quality of textons -> sentences.
#include "texton_notes.h"

#include <lichen/texton_comparison.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace lichen::cli {
namespace {

/// Relative model error up to which a texton is close. That of one with the very spectrum of a
/// material, beside one picture of it, is sqrt(2 - sqrt(pi)) = 0.477, since the moduli of a
/// picture's spectrum scatter as those of complex normal numbers; one whose amplitudes are off by a
/// share D of the deviation has sqrt(2 - sqrt(pi) + sqrt(pi) / 2 D^2). This is D = 1/2. Six
/// photographs of 512 x 512 have 0.53 to 0.64 at a support of 64, a wood of slow waves 0.78.
constexpr double kCloseError = 0.67;

/// Excess kurtosis up to which impacts are enough: the greatest flatness that a fit should have
/// over the number of impacts that the papers and we take.
constexpr double kEnoughFlatness = 4.0;
constexpr double kUsualImpacts = 30.0;

bool isSupportWhole(const TextonShape& shape) {
  return shape.coefficientsX + shape.order >= shape.texelsPerTileX &&
         shape.coefficientsY + shape.order >= shape.texelsPerTileY;
}

/// Of the worst of some textons: "the texton is" or "the textons are" is said before.
std::string verdict(double modelError, const TextonShape& shape) {
  if (modelError <= kCloseError)
    return "close to the photograph's Gaussian texture";
  return fmt::format("not close to the photograph's Gaussian texture{}",
                     isSupportWhole(shape) ? "" : ", a larger --support comes closer");
}

} // namespace

std::optional<std::string> supportNote(int supportWanted, const TextonShape& shape) {
  const int wanted = supportWanted - shape.order; // coefficients
  if (wanted <= std::min(shape.coefficientsX, shape.coefficientsY))
    return std::nullopt;
  return fmt::format("--support {}: the exemplar has {} x {} pixels, and the texton no more",
                     supportWanted, shape.texelsPerTileX, shape.texelsPerTileY);
}

std::string qualityNote(const TextonQuality& quality, const TextonShape& shape, double impacts) {
  std::string text = fmt::format(
      "the texton is {}: relative model error {:.3f} (another picture of the same grain has about "
      "0.48){}; flatness {:.2f}",
      verdict(quality.modelError, shape), quality.modelError,
      quality.heldOutError
          ? fmt::format(", and {:.3f} for a half of the exemplar fitted to the other",
                        *quality.heldOutError)
          : "",
      quality.flatness);
  if (quality.flatness * kUsualImpacts > kEnoughFlatness * impacts)
    text += fmt::format(", with {:g} impacts few: --impacts {:.0f} makes the values nearly normal",
                        impacts, std::ceil(quality.flatness / KernelJudgement::kNearlyNormal));
  return text;
}

std::string qualityNote(const TextonMixQuality& quality, const TextonShape& shape) {
  const auto [least, most] =
      std::minmax_element(quality.modelErrors.begin(), quality.modelErrors.end());
  if (quality.modelErrors.size() == 1)
    return fmt::format("the texton is {}: relative model error {:.3f}; {:.3f} of the deviation is "
                       "what one texton lacks",
                       verdict(*most, shape), *least, quality.rankError);
  return fmt::format(
      "the textons are {}: relative model errors {:.3f} to {:.3f}; neighbours differ "
      "by {:.3f} of their deviation at most",
      verdict(*most, shape), *least, *most, quality.largestStep);
}

} // namespace lichen::cli
