// SPDX-License-Identifier: MIT
// How much of an image repeats at even steps, as courses of bricks, threads or lines of text do.
#pragma once

#include <lichen/fft.h>

namespace lichen::suitability {

/// The share of the variance in lines of the spectrum: frequencies of more than 20 times the
/// median power of the 9 x 9 around them, from 5 cycles per image up (what is slower has too few
/// repeats to be told from clouds). [0, 1]; 0 for images under 32 pixels a side. Where phases are
/// random, a periodogram exceeds its median r times with probability 2^-r: one frequency in a
/// million is a line by chance.
[[nodiscard]] double latticeShare(const HalfSpectrum& spectrum);

} // namespace lichen::suitability
