// SPDX-License-Identifier: MIT
// The cross-spectra of an exemplar's Gaussian channels -> how each channel follows the signs of a
// kernel's impacts.
#pragma once

#include "kernel_spectrum.h"
#include "spectra/map_spectrum.h"

#include <Eigen/Dense>

#include <vector>

namespace lichen::multiple_kernels {

/// The signs of an impact, each +1 or -1 at random.
inline constexpr int kSigns = 4;

/// For each kernel, the factors of all channels of all maps, map after map: channels x kSigns. The
/// sum over impacts of factors times signs times a kernel has the covariance of the channels in
/// Gaussian values if the square of the kernel, summed over impacts, is 1 in the mean; over the
/// kernels it is exact, while of sets of more than kSigns channels each kernel keeps the strongest
/// combinations. Phases between channels are lost. Throws std::bad_alloc.
[[nodiscard]] std::vector<Eigen::MatrixXd>
kernelColors(const std::vector<spectra::MapSpectrum>& maps, const WindowSpectrum& spectrum,
             const std::vector<Kernel>& kernels);

} // namespace lichen::multiple_kernels
