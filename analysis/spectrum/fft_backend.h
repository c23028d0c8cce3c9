// SPDX-License-Identifier: MIT
// The two implementations of fft.h. The library links one of them; the tests link both.
#pragma once

#include <lichen/fft.h>

#include <span>
#include <vector>

namespace lichen {

[[nodiscard]] HalfSpectrum forwardFftw(std::span<const float> plane, int width, int height);
[[nodiscard]] std::vector<float> inverseFftw(const HalfSpectrum& spectrum, int rows);

[[nodiscard]] HalfSpectrum forwardKissFft(std::span<const float> plane, int width, int height);
[[nodiscard]] std::vector<float> inverseKissFft(const HalfSpectrum& spectrum, int rows);

} // namespace lichen
