// SPDX-License-Identifier: MIT
// The two implementations behind fft.h. The library links the chosen one, the tests both.
#pragma once

#include <lichen/fft.h>

#include <span>
#include <vector>

namespace lichen {

[[nodiscard]] HalfSpectrum forwardFftw(std::span<const float> plane, int width, int height);
[[nodiscard]] std::vector<float> inverseFftw(const HalfSpectrum& spectrum);

[[nodiscard]] HalfSpectrum forwardKissFft(std::span<const float> plane, int width, int height);
[[nodiscard]] std::vector<float> inverseKissFft(const HalfSpectrum& spectrum);

} // namespace lichen
