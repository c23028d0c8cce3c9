// SPDX-License-Identifier: MIT
// Real two-dimensional transforms by FFTW in single precision.
//
// Plane (height, width) row-major <-> half spectrum (height, width / 2 + 1).
// Source: [FJ05] and FFTW's manual.
#include "fft_backend.h"

#include <cassert>
#include <complex>
#include <fftw3.h>
#include <mutex>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace lichen {
namespace {

// FFTW's plan, and with it the rounding, depends on whether memory is aligned to 16 bytes. That of
// a vector always is, so transforms run between vectors.
static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= 16);
using Lines = std::vector<std::complex<float>>; ///< rows of a half spectrum

[[nodiscard]] fftwf_complex* fftw(Lines& lines) {
  return reinterpret_cast<fftwf_complex*>(lines.data()); // the same layout, by FFTW's manual
}

/// Only fftwf_execute is thread-safe by default; creating and destroying plans is not, anywhere in
/// the process. After this call FFTW locks its planner itself, which also covers a host that makes
/// plans.
void lockPlanner() {
  static std::once_flag once;
  std::call_once(once, fftwf_make_planner_thread_safe);
}

/// What a plan depends on beside its kind: the length of its lines and their number.
using Sizes = std::pair<int, int>;

/// The plan of a thread's last transform of one kind, which the next of the same sizes uses again.
/// FFTW_ESTIMATE takes no timings, so a plan is always the same.
class LastPlan {
public:
  LastPlan() = default;
  LastPlan(const LastPlan&) = delete;
  LastPlan& operator=(const LastPlan&) = delete;
  ~LastPlan() { fftwf_destroy_plan(plan_); }

  template <class MakePlan>
  [[nodiscard]] fftwf_plan of(const Sizes& sizes, MakePlan make) {
    if (plan_ == nullptr || sizes != sizes_) {
      lockPlanner();
      fftwf_destroy_plan(std::exchange(plan_, nullptr));
      plan_ = make();
      sizes_ = sizes;
    }
    if (plan_ == nullptr)
      throw std::bad_alloc();
    return plan_;
  }

private:
  fftwf_plan plan_ = nullptr;
  Sizes sizes_{};
};

/// Transforms all columns in place.
void transformColumns(Lines& lines, int columns, int height, int sign) {
  thread_local LastPlan forward, backward;
  LastPlan& plan = sign == FFTW_FORWARD ? forward : backward;
  fftwf_execute_dft(plan.of({height, columns},
                            [&] {
                              return fftwf_plan_many_dft(1, &height, columns, fftw(lines), nullptr,
                                                         columns, 1, fftw(lines), nullptr, columns,
                                                         1, sign, FFTW_ESTIMATE);
                            }),
                    fftw(lines), fftw(lines));
}

} // namespace

HalfSpectrum forwardFftw(std::span<const float> plane, int width, int height) {
  HalfSpectrum spectrum{width, height, {}};
  const int columns = spectrum.columns();
  const int rows = int(plane.size() / std::size_t(width));
  assert(width >= 1 && rows >= 1 && rows <= height && plane.size() % std::size_t(width) == 0);
  std::vector<float> in(plane.begin(), plane.end());
  spectrum.values.resize(std::size_t(columns) * std::size_t(height));
  thread_local LastPlan plan;
  fftwf_execute_dft_r2c(plan.of({width, rows},
                                [&] {
                                  return fftwf_plan_many_dft_r2c(
                                      1, &width, rows, in.data(), nullptr, 1, width,
                                      fftw(spectrum.values), nullptr, 1, columns, FFTW_ESTIMATE);
                                }),
                        in.data(), fftw(spectrum.values));
  transformColumns(spectrum.values, columns, height, FFTW_FORWARD);
  return spectrum;
}

std::vector<float> inverseFftw(const HalfSpectrum& spectrum, int rows) {
  const int width = spectrum.width;
  const int height = spectrum.height;
  assert(rows >= 1 && rows <= height);
  Lines lines = spectrum.values;
  transformColumns(lines, spectrum.columns(), height, FFTW_BACKWARD);
  std::vector<float> plane(std::size_t(width) * std::size_t(rows));
  thread_local LastPlan plan;
  fftwf_execute_dft_c2r(plan.of({width, rows},
                                [&] {
                                  return fftwf_plan_many_dft_c2r(
                                      1, &width, rows, fftw(lines), nullptr, 1, spectrum.columns(),
                                      plane.data(), nullptr, 1, width, FFTW_ESTIMATE);
                                }),
                        fftw(lines), plane.data());
  const float scale = 1.0f / (float(width) * float(height));
  for (float& value : plane)
    value *= scale;
  return plane;
}

} // namespace lichen
