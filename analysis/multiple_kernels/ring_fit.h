// SPDX-License-Identifier: MIT
// A power spectrum without a direction -> few rings.
#pragma once

#include "frequency_blocks.h"
#include "kernel_spectrum.h"

#include <vector>

namespace lichen::multiple_kernels {

/// `count` rings of equal energy, whose lengths, widths and energies are then fitted to the power
/// of all directions together. Empty if the plane has too little power, or too few frequencies.
[[nodiscard]] std::vector<Kernel> fittedRings(const FrequencyBlocks& blocks,
                                              const spectra::PowerPlane& power,
                                              const WindowSpectrum& spectrum, std::size_t count);

} // namespace lichen::multiple_kernels
