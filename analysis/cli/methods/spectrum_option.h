// SPDX-License-Identifier: MIT
// The option --spectrum: rings, bands and lobes in text, or a painted picture -> amplitudes.
#pragma once

#include "../options.h"

#include <lichen/exemplar.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace lichen::cli {

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

/// The parts, or the picture to read.
using SpectrumChoice = std::variant<std::vector<SpectrumPart>, std::filesystem::path>;

/// "ring:8:12,band:0:2:20:40", or the name of a file.
[[nodiscard]] Accepted<std::optional<SpectrumChoice>> spectrumChoice();

/// The amplitudes: the largest of the parts, 1 in rings and bands, as far as `most` cycles per
/// tile, or the codes of the picture, of a coloured one for each channel and else of its luminance.
/// Its middle is the frequency 0. Errors: as
/// readImage(); badInput for a picture without a value above 0, but for its middle.
[[nodiscard]] Result<SpectrumPicture> spectrumPicture(const SpectrumChoice& choice, int most);

/// Sets `spectrum` to the amplitudes of `choice`, if there is one, as far as the largest map has
/// frequencies.
[[nodiscard]] Result<void> setSpectrum(const std::optional<SpectrumChoice>& choice,
                                       std::span<const MapExemplar> maps,
                                       std::optional<SpectrumPicture>& spectrum);

} // namespace lichen::cli
