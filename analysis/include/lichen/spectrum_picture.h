// SPDX-License-Identifier: MIT
// A spectrum that the user gives in place of the exemplar's.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace lichen {

/// Amplitudes at whole numbers of cycles per tile, row by row: column x and row y have the
/// frequency (x - width / 2, y - height / 2), rounded down. Finite and not negative. Amplitudes of
/// a frequency and its negative are averaged in the square; frequency 0 and those that the
/// exemplar's pixels cannot hold do not count.
struct SpectrumPicture {
  int width = 0, height = 0;
  std::vector<float> amplitudes; ///< channels * width * height
  /// 1, or 3 of one pixel after the other: of the red, green and blue of colour maps. Other maps
  /// take the root of the mean square.
  int channels = 1;
};

/// Frequencies whose magnitude lies in a range [cycles / tile].
struct SpectrumRing {
  double from = 0.0, to = 0.0;
};
/// Frequencies in a rectangle, and their mirrors [cycles / tile].
struct SpectrumBand {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
};
/// A bell around a frequency and its mirror, whose amplitude falls to exp(-1/2) at the radius
/// [cycles / tile].
struct SpectrumLobe {
  double u = 0.0, v = 0.0, radius = 1.0;
};
using SpectrumPart = std::variant<SpectrumRing, SpectrumBand, SpectrumLobe>;

/// At each frequency the largest amplitude of the parts, 1 in rings and bands, as far as `most`
/// cycles per tile. Throws std::bad_alloc.
[[nodiscard]] SpectrumPicture spectrumOf(std::span<const SpectrumPart> parts, int most);

/// The codes of a painted picture, of a coloured one for each channel and else of its luminance.
/// Its middle is the frequency 0. `name` starts the message. Errors: badInput for a picture without
/// a value above 0, but for its middle. Throws std::bad_alloc.
[[nodiscard]] Result<SpectrumPicture> spectrumOf(const SrgbImage& picture, const std::string& name);

} // namespace lichen
