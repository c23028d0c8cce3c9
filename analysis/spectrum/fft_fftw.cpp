// SPDX-License-Identifier: MIT
// Real two-dimensional transforms by FFTW in single precision.
//
// Plane (height, width) row-major <-> half spectrum (height, width / 2 + 1).
// Source: [FJ05] and FFTW's manual.
#include "fft_backend.h"

#include <algorithm>
#include <cassert>
#include <fftw3.h>
#include <memory>
#include <mutex>
#include <new>

namespace lichen {
namespace {

struct FftwFree {
  void operator()(void* memory) const { fftwf_free(memory); }
};

/// Uses FFTW's own allocator, so that alignment is always the same. Otherwise the plan, and with it
/// the rounding, would depend on the address of the caller's memory.
template <class T>
std::unique_ptr<T[], FftwFree> allocate(std::size_t count) {
  void* memory = fftwf_malloc(count * sizeof(T));
  if (memory == nullptr)
    throw std::bad_alloc();
  return std::unique_ptr<T[], FftwFree>(static_cast<T*>(memory));
}

/// Only fftwf_execute is thread-safe by default; creating and destroying plans is not, anywhere in
/// the process. After this call FFTW locks its planner itself, which also covers a host that makes
/// plans.
void lockPlanner() {
  static std::once_flag once;
  std::call_once(once, fftwf_make_planner_thread_safe);
}

/// A plan made with FFTW_ESTIMATE, which takes no timings, so the plan is always the same.
class Plan {
public:
  template <class MakePlan>
  explicit Plan(MakePlan make) {
    lockPlanner();
    plan_ = make();
    if (plan_ == nullptr)
      throw std::bad_alloc();
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() { fftwf_destroy_plan(plan_); }
  void execute() const { fftwf_execute(plan_); }

private:
  fftwf_plan plan_ = nullptr;
};

} // namespace

HalfSpectrum forwardFftw(std::span<const float> plane, int width, int height) {
  assert(width >= 1 && height >= 1 && plane.size() == std::size_t(width) * std::size_t(height));
  HalfSpectrum spectrum{width, height, {}};
  spectrum.values.resize(std::size_t(spectrum.columns()) * std::size_t(height));
  const auto in = allocate<float>(plane.size());
  const auto out = allocate<fftwf_complex>(spectrum.values.size());
  const Plan plan(
      [&] { return fftwf_plan_dft_r2c_2d(height, width, in.get(), out.get(), FFTW_ESTIMATE); });
  std::copy(plane.begin(), plane.end(), in.get());
  plan.execute();
  for (std::size_t i = 0; i < spectrum.values.size(); ++i)
    spectrum.values[i] = {out[i][0], out[i][1]};
  return spectrum;
}

std::vector<float> inverseFftw(const HalfSpectrum& spectrum) {
  const int width = spectrum.width;
  const int height = spectrum.height;
  std::vector<float> plane(std::size_t(width) * std::size_t(height));
  const auto in = allocate<fftwf_complex>(spectrum.values.size());
  const auto out = allocate<float>(plane.size());
  const Plan plan(
      [&] { return fftwf_plan_dft_c2r_2d(height, width, in.get(), out.get(), FFTW_ESTIMATE); });
  for (std::size_t i = 0; i < spectrum.values.size(); ++i) {
    in[i][0] = spectrum.values[i].real();
    in[i][1] = spectrum.values[i].imag();
  }
  plan.execute();
  const float scale = 1.0f / float(plane.size());
  std::transform(out.get(), out.get() + plane.size(), plane.begin(),
                 [scale](float value) { return value * scale; });
  return plane;
}

namespace {

/// Transforms the patch's rows only, then all columns; the inverse runs in the opposite order.
class FftwPatch final : public PatchTransform {
public:
  FftwPatch(int width, int height, int patchWidth, int patchHeight)
      : width_(width), columns_(width / 2 + 1), patchWidth_(patchWidth), patchHeight_(patchHeight),
        count_(std::size_t(columns_) * std::size_t(height)),
        rows_(allocate<float>(std::size_t(width) * std::size_t(patchHeight))),
        lines_(allocate<fftwf_complex>(count_)), rowsForward_([&] {
          return fftwf_plan_many_dft_r2c(1, &width_, patchHeight_, rows_.get(), nullptr, 1, width_,
                                         lines_.get(), nullptr, 1, columns_, FFTW_ESTIMATE);
        }),
        rowsInverse_([&] {
          return fftwf_plan_many_dft_c2r(1, &width_, patchHeight_, lines_.get(), nullptr, 1,
                                         columns_, rows_.get(), nullptr, 1, width_, FFTW_ESTIMATE);
        }),
        columnsForward_([&] { return columnsPlan(height, FFTW_FORWARD); }),
        columnsInverse_([&] { return columnsPlan(height, FFTW_BACKWARD); }) {}

  void forward(std::span<const float> patch, HalfSpectrum& spectrum) override {
    std::fill_n(rows_.get(), std::size_t(width_) * std::size_t(patchHeight_), 0.0f);
    for (int y = 0; y < patchHeight_; ++y)
      std::copy_n(patch.data() + std::ptrdiff_t(y) * patchWidth_, patchWidth_,
                  rows_.get() + std::ptrdiff_t(y) * width_);
    rowsForward_.execute();
    float* lines = lines_[0];
    std::fill(lines + 2 * std::size_t(columns_) * std::size_t(patchHeight_), lines + 2 * count_,
              0.0f);
    columnsForward_.execute();
    for (std::size_t i = 0; i < count_; ++i)
      spectrum.values[i] = {lines_[i][0], lines_[i][1]};
  }

  void inverse(const HalfSpectrum& spectrum, std::span<float> patch) override {
    for (std::size_t i = 0; i < count_; ++i) {
      lines_[i][0] = spectrum.values[i].real();
      lines_[i][1] = spectrum.values[i].imag();
    }
    columnsInverse_.execute();
    rowsInverse_.execute();
    const float scale = 1.0f / (float(width_) * float(spectrum.height));
    for (int y = 0; y < patchHeight_; ++y)
      for (int x = 0; x < patchWidth_; ++x)
        patch[std::size_t(y) * std::size_t(patchWidth_) + std::size_t(x)] =
            rows_[std::size_t(y) * std::size_t(width_) + std::size_t(x)] * scale;
  }

private:
  [[nodiscard]] fftwf_plan columnsPlan(int height, int sign) {
    return fftwf_plan_many_dft(1, &height, columns_, lines_.get(), nullptr, columns_, 1,
                               lines_.get(), nullptr, columns_, 1, sign, FFTW_ESTIMATE);
  }

  int width_, columns_, patchWidth_, patchHeight_;
  std::size_t count_;
  std::unique_ptr<float[], FftwFree> rows_;
  std::unique_ptr<fftwf_complex[], FftwFree> lines_;
  Plan rowsForward_, rowsInverse_, columnsForward_, columnsInverse_;
};

} // namespace

std::unique_ptr<PatchTransform> patchFftw(int width, int height, int patchWidth, int patchHeight) {
  return std::make_unique<FftwPatch>(width, height, patchWidth, patchHeight);
}

} // namespace lichen
