// SPDX-License-Identifier: MIT
// Forwards to the backend that LICHEN_FFT selects.
#include "fft_backend.h"

namespace lichen {
namespace {

#ifdef LICHEN_FFT_KISS
constexpr auto* kForward = forwardKissFft;
constexpr auto* kInverse = inverseKissFft;
#else
constexpr auto* kForward = forwardFftw;
constexpr auto* kInverse = inverseFftw;
#endif

} // namespace

int fastTransformSize(int size) {
  for (;; ++size) {
    int rest = size;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0)
        rest /= factor;
    if (rest == 1)
      return size;
  }
}

HalfSpectrum forwardFft(std::span<const float> plane, int width, int height) {
  return kForward(plane, width, height);
}

std::vector<float> inverseFft(const HalfSpectrum& spectrum, int rows) {
  return kInverse(spectrum, rows);
}

} // namespace lichen
