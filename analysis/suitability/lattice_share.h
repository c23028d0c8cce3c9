// SPDX-License-Identifier: MIT
// How much of an image repeats at even steps, such as courses of bricks, threads or lines of text.
#pragma once

#include <lichen/fft.h>

namespace lichen::suitability {

/// The share of the variance in spectral lines, in [0, 1]. A line is a frequency with more than 20
/// times the median power of the 9 x 9 frequencies around it, and than three of the eight before
/// and of the eight after it in its own direction: streaks have all frequencies of one direction.
/// Only frequencies from 5 cycles per image up count: slower ones have too few repeats to tell them
/// from clouds. With random phases, a periodogram exceeds its median r times with probability 2^-r,
/// so one frequency in a million is a line by chance. 0 for images under 32 pixels a side.
[[nodiscard]] double latticeShare(const HalfSpectrum& spectrum);

} // namespace lichen::suitability
