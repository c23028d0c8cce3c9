// SPDX-License-Identifier: MIT
// The two implementations of fft.h. The library links one of them; the tests link both.
#pragma once

#include <lichen/fft.h>

#include <memory>
#include <span>
#include <vector>

namespace lichen {

[[nodiscard]] HalfSpectrum forwardFftw(std::span<const float> plane, int width, int height);
[[nodiscard]] std::vector<float> inverseFftw(const HalfSpectrum& spectrum);

[[nodiscard]] HalfSpectrum forwardKissFft(std::span<const float> plane, int width, int height);
[[nodiscard]] std::vector<float> inverseKissFft(const HalfSpectrum& spectrum);

/// Same contract as PatchFft.
class PatchTransform {
public:
  PatchTransform() = default;
  PatchTransform(const PatchTransform&) = delete;
  PatchTransform& operator=(const PatchTransform&) = delete;
  virtual ~PatchTransform() = default;
  virtual void forward(std::span<const float> patch, HalfSpectrum& spectrum) = 0;
  virtual void inverse(const HalfSpectrum& spectrum, std::span<float> patch) = 0;
};
[[nodiscard]] std::unique_ptr<PatchTransform> patchFftw(int width, int height, int patchWidth,
                                                        int patchHeight);
[[nodiscard]] std::unique_ptr<PatchTransform> patchKissFft(int width, int height, int patchWidth,
                                                           int patchHeight);

} // namespace lichen
