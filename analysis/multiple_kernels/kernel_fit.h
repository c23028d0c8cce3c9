// SPDX-License-Identifier: MIT
// A power spectrum -> few kernels whose noise has it.
#pragma once

#include "kernel.h"
#include "random_phase/power_tree.h"

#include <vector>

namespace lichen::multiple_kernels {

/// Kernels that follow a power plane, and spectrumErrorDb() of them.
struct KernelFit {
  std::vector<Kernel> kernels;
  double decibels = 0.0;
};

/// Fits kernels to a power plane whose values, each counted for its frequency and for the mirror,
/// sum to the variance: at most as many as each of `counts` says, which grow. Kernels with windows
/// on the square have rectangles of the plane and the energy there. Gabors are fitted together in
/// all their parameters, from such rectangles and from the fewer kernels of the count before; rings
/// take their place where few of them have the spectrum nearly as closely.
/// Deterministic. Throws std::bad_alloc. Without kernels for a plane without power.
[[nodiscard]] std::vector<KernelFit> fitKernels(const random_phase::PowerPlane& power,
                                                const WindowSpectrum& spectrum,
                                                const std::vector<std::size_t>& counts);

/// The root mean square of the difference of a power plane and the kernels' power in decibels, over
/// blocks of frequencies that grow with the frequency.
[[nodiscard]] double spectrumErrorDb(const random_phase::PowerPlane& power,
                                     const WindowSpectrum& spectrum,
                                     const std::vector<Kernel>& kernels);

} // namespace lichen::multiple_kernels
