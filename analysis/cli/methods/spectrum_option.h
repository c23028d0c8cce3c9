// SPDX-License-Identifier: MIT
// The option --spectrum: rings, bands and lobes in text, or the name of a painted picture.
#pragma once

#include "../options.h"

#include <lichen/exemplar.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <filesystem>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace lichen::cli {

/// The parts, or the picture to read.
using SpectrumChoice = std::variant<std::vector<SpectrumPart>, std::filesystem::path>;

/// "ring:8:12,band:0:2:20:40", or the name of a file.
[[nodiscard]] Accepted<std::optional<SpectrumChoice>> spectrumChoice();

/// As spectrumOf() of the parts, as far as `most` cycles per tile, or of the picture. Errors: as
/// that and readImage().
[[nodiscard]] Result<SpectrumPicture> spectrumPicture(const SpectrumChoice& choice, int most);

/// Sets `spectrum` to the amplitudes of `choice`, if there is one, as far as the largest map has
/// frequencies. Does nothing without maps.
[[nodiscard]] Result<void> setSpectrum(const std::optional<SpectrumChoice>& choice,
                                       std::span<const MapExemplar> maps,
                                       std::optional<SpectrumPicture>& spectrum);

} // namespace lichen::cli
