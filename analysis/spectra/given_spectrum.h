// SPDX-License-Identifier: MIT
// A spectrum that the user gives in place of the exemplar's.
#pragma once

#include "map_spectrum.h"

#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <vector>

namespace lichen::spectra {

/// Replaces the transforms of all maps by transforms of random fields with the powers of `picture`
/// in each channel, and the variances that they had. The channels have phases of their own; of a
/// coloured picture the stored channels of colour maps do, and the channels are sums of them with
/// the covariance that they had. MapSpectrum::fromIndependent says so. Errors:
/// badInput for a picture without power at the frequencies of a map. Throws std::bad_alloc.
[[nodiscard]] Result<void> replaceSpectra(const SpectrumPicture& picture,
                                          std::vector<MapSpectrum>& maps);

} // namespace lichen::spectra
