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
  assert(width >= 1 && height >= 1 && plane.size() == std::size_t(width) * std::size_t(height));
  std::vector<kiss_fft_cpx> in(plane.size());
  for (std::size_t i = 0; i < in.size(); ++i)
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

std::vector<float> inverseKissFft(const HalfSpectrum& spectrum) {
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
  std::vector<float> plane(out.size());
  const float scale = 1.0f / float(plane.size());
  for (std::size_t i = 0; i < plane.size(); ++i)
    plane[i] = out[i].r * scale;
  return plane;
}

namespace {

using Line = std::vector<kiss_fft_cpx>;

/// One-dimensional transforms of one length.
class LineTransform {
public:
  LineTransform(int length, bool inverse)
      : configuration_(kiss_fft_alloc(length, inverse ? 1 : 0, nullptr, nullptr)) {
    if (!configuration_)
      throw std::bad_alloc();
  }

  /// Reads values `stride` apart and writes them contiguously.
  void run(const kiss_fft_cpx* in, std::size_t stride, Line& out) const {
    kiss_fft_stride(configuration_.get(), in, out.data(), int(stride));
  }

private:
  std::unique_ptr<kiss_fft_state, KissFree> configuration_;
};

/// Transforms the patch's rows only, then all columns; the inverse runs in the opposite order.
class KissPatch final : public PatchTransform {
public:
  KissPatch(int width, int height, int patchWidth, int patchHeight)
      : columns_(std::size_t(width / 2 + 1)), patchWidth_(std::size_t(patchWidth)),
        patchHeight_(std::size_t(patchHeight)), row_(std::size_t(width)), rowOut_(row_.size()),
        columnOut_(std::size_t(height)), lines_(columns_ * columnOut_.size()),
        rowForward_(width, false), rowInverse_(width, true), columnForward_(height, false),
        columnInverse_(height, true) {}

  void forward(std::span<const float> patch, HalfSpectrum& spectrum) override {
    std::fill(row_.begin(), row_.end(), kiss_fft_cpx{0.0f, 0.0f});
    std::fill(lines_.begin(), lines_.end(), kiss_fft_cpx{0.0f, 0.0f});
    for (std::size_t y = 0; y < patchHeight_; ++y) {
      for (std::size_t x = 0; x < patchWidth_; ++x)
        row_[x] = {patch[y * patchWidth_ + x], 0.0f};
      rowForward_.run(row_.data(), 1, rowOut_);
      std::copy_n(rowOut_.begin(), columns_, lines_.begin() + std::ptrdiff_t(y * columns_));
    }
    for (std::size_t u = 0; u < columns_; ++u) {
      columnForward_.run(&lines_[u], columns_, columnOut_);
      for (std::size_t v = 0; v < columnOut_.size(); ++v)
        spectrum.values[v * columns_ + u] = {columnOut_[v].r, columnOut_[v].i};
    }
  }

  void inverse(const HalfSpectrum& spectrum, std::span<float> patch) override {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      lines_[i] = {spectrum.values[i].real(), spectrum.values[i].imag()};
    for (std::size_t u = 0; u < columns_; ++u) {
      columnInverse_.run(&lines_[u], columns_, columnOut_);
      for (std::size_t y = 0; y < patchHeight_; ++y)
        lines_[y * columns_ + u] = columnOut_[y];
    }
    const float scale = 1.0f / (float(row_.size()) * float(columnOut_.size()));
    for (std::size_t y = 0; y < patchHeight_; ++y) {
      const kiss_fft_cpx* line = &lines_[y * columns_];
      std::copy_n(line, columns_, row_.begin());
      for (std::size_t u = columns_; u < row_.size(); ++u) {
        const kiss_fft_cpx& mirror = line[row_.size() - u];
        row_[u] = {mirror.r, -mirror.i};
      }
      rowInverse_.run(row_.data(), 1, rowOut_);
      for (std::size_t x = 0; x < patchWidth_; ++x)
        patch[y * patchWidth_ + x] = rowOut_[x].r * scale;
    }
  }

private:
  std::size_t columns_, patchWidth_, patchHeight_;
  Line row_, rowOut_; ///< of the plane
  Line columnOut_;
  Line lines_; ///< height x columns_
  LineTransform rowForward_, rowInverse_, columnForward_, columnInverse_;
};

} // namespace

std::unique_ptr<PatchTransform> patchKissFft(int width, int height, int patchWidth,
                                             int patchHeight) {
  return std::make_unique<KissPatch>(width, height, patchWidth, patchHeight);
}

} // namespace lichen
