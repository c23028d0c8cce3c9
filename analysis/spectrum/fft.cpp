// SPDX-License-Identifier: MIT
// Forwards to the backend that LICHEN_FFT selects.
#include "fft_backend.h"

namespace lichen {
namespace {

#ifdef LICHEN_FFT_KISS
constexpr auto* kForward = forwardKissFft;
constexpr auto* kInverse = inverseKissFft;
constexpr auto* kPatch = patchKissFft;
#else
constexpr auto* kForward = forwardFftw;
constexpr auto* kInverse = inverseFftw;
constexpr auto* kPatch = patchFftw;
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

std::vector<float> inverseFft(const HalfSpectrum& spectrum) { return kInverse(spectrum); }

PatchFft::PatchFft(int width, int height, int patchWidth, int patchHeight)
    : transform_(kPatch(width, height, patchWidth, patchHeight)) {}
PatchFft::PatchFft(PatchFft&&) noexcept = default;
PatchFft& PatchFft::operator=(PatchFft&&) noexcept = default;
PatchFft::~PatchFft() = default;

void PatchFft::forward(std::span<const float> patch, HalfSpectrum& spectrum) {
  transform_->forward(patch, spectrum);
}

void PatchFft::inverse(const HalfSpectrum& spectrum, std::span<float> patch) {
  transform_->inverse(spectrum, patch);
}

} // namespace lichen
