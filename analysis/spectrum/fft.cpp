// SPDX-License-Identifier: MIT
// The backend that LICHEN_FFT chose.
#include "fft_backend.h"

namespace lichen {

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

PatchFft::PatchFft(int width, int height, int patchWidth, int patchHeight)
#ifdef LICHEN_FFT_KISS
    : transform_(patchKissFft(width, height, patchWidth, patchHeight)){}
#else
    : transform_(patchFftw(width, height, patchWidth, patchHeight)) {
}
#endif
      PatchFft::PatchFft(PatchFft &&) noexcept = default;
PatchFft& PatchFft::operator=(PatchFft&&) noexcept = default;
PatchFft::~PatchFft() = default;

void PatchFft::forward(std::span<const float> patch, HalfSpectrum& spectrum) {
  transform_->forward(patch, spectrum);
}

void PatchFft::inverse(const HalfSpectrum& spectrum, std::span<float> patch) {
  transform_->inverse(spectrum, patch);
}

} // namespace lichen
