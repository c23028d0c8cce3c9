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

} // namespace lichen
