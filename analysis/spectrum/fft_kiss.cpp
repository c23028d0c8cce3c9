// SPDX-License-Identifier: MIT
// Real two-dimensional transforms by KissFFT.
//
// Plane (height, width) row-major <-> half spectrum (height, width / 2 + 1). KissFFT's real
// transform needs an even width, so this uses the complex one: any width, at twice the work.
#include "fft_backend.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <kiss_fft.h>
#include <kiss_fftnd.h>
#include <memory>
#include <new>

namespace lichen {
namespace {

struct KissFree {
  void operator()(void* configuration) const { kiss_fft_free(configuration); }
};

std::vector<kiss_fft_cpx> transform(const std::vector<kiss_fft_cpx>& in, int width, int height,
                                    bool inverse) {
  const std::array<int, 2> dimensions{height, width};
  const std::unique_ptr<kiss_fftnd_state, KissFree> configuration(
      kiss_fftnd_alloc(dimensions.data(), 2, inverse ? 1 : 0, nullptr, nullptr));
  if (!configuration)
    throw std::bad_alloc();
  std::vector<kiss_fft_cpx> out(in.size());
  kiss_fftnd(configuration.get(), in.data(), out.data());
  return out;
}

} // namespace

HalfSpectrum forwardKissFft(std::span<const float> plane, int width, int height) {
  assert(width >= 1 && height >= 1 && plane.size() <= std::size_t(width) * std::size_t(height));
  std::vector<kiss_fft_cpx> in(std::size_t(width) * std::size_t(height), {0.0f, 0.0f});
  for (std::size_t i = 0; i < plane.size(); ++i)
    in[i] = {plane[i], 0.0f};
  const std::vector<kiss_fft_cpx> out = transform(in, width, height, false);
  HalfSpectrum spectrum{width, height, {}};
  spectrum.values.resize(std::size_t(spectrum.columns()) * std::size_t(height));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < spectrum.columns(); ++u) {
      const kiss_fft_cpx& value = out[std::size_t(v) * std::size_t(width) + std::size_t(u)];
      spectrum.at(u, v) = {value.r, value.i};
    }
  }
  return spectrum;
}

std::vector<float> inverseKissFft(const HalfSpectrum& spectrum, int rows) {
  const int width = spectrum.width;
  const int height = spectrum.height;
  std::vector<kiss_fft_cpx> in(std::size_t(width) * std::size_t(height));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const bool stored = u < spectrum.columns();
      const std::complex<float> value =
          stored ? spectrum.at(u, v) : std::conj(spectrum.at(width - u, (height - v) % height));
      in[std::size_t(v) * std::size_t(width) + std::size_t(u)] = {value.real(), value.imag()};
    }
  }
  const std::vector<kiss_fft_cpx> out = transform(in, width, height, true);
  std::vector<float> plane(std::size_t(width) * std::size_t(rows));
  const float scale = 1.0f / float(out.size());
  for (std::size_t i = 0; i < plane.size(); ++i)
    plane[i] = out[i].r * scale;
  return plane;
}

} // namespace lichen
