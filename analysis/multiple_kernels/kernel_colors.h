// SPDX-License-Identifier: MIT
// The cross-spectra of an exemplar's Gaussian channels -> how each channel follows the waves of a
// kernel's impacts.
#pragma once

#include "kernel.h"
#include "random_phase/map_spectrum.h"

#include <Eigen/Dense>

#include <vector>

namespace lichen::multiple_kernels {

/// The waves of an impact, each of a phase of its own.
inline constexpr int kWaves = 4;

/// For each kernel, the factors of all channels of all maps, map after map: channels x kWaves. The
/// sum over impacts and waves of factors times waves has the covariance of the channels in
/// Gaussian values if the square of a wave, summed over impacts, is 1 in the mean; over the
/// kernels it is exact, while of sets of more than kWaves channels each kernel keeps the strongest
/// combinations. Phases between channels are lost. Throws std::bad_alloc.
[[nodiscard]] std::vector<Eigen::MatrixXd>
kernelColors(const std::vector<random_phase::MapSpectrum>& maps, const WindowSpectrum& spectrum,
             const std::vector<Kernel>& kernels);

} // namespace lichen::multiple_kernels
