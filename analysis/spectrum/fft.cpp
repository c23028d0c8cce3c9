// SPDX-License-Identifier: MIT
// The backend that LICHEN_FFT chose.
#include "fft_backend.h"

namespace lichen {

HalfSpectrum forwardFft(std::span<const float> plane, int width, int height) {
#ifdef LICHEN_FFT_KISS
  return forwardKissFft(plane, width, height);
#else
  return forwardFftw(plane, width, height);
#endif
}

std::vector<float> inverseFft(const HalfSpectrum& spectrum) {
#ifdef LICHEN_FFT_KISS
  return inverseKissFft(spectrum);
#else
  return inverseFftw(spectrum);
#endif
}

} // namespace lichen
