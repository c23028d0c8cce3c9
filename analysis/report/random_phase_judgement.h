// SPDX-License-Identifier: MIT
// How a noise of random phases with the exemplar's histogram is judged, and how its spectrum is
// shown.
#pragma once

#include "method_report.h"

#include <vector>

namespace lichen {

/// Measures the result against the exemplar's Gaussian version, or, of a noise with another
/// spectrum on purpose, against the exemplar's colours only.
[[nodiscard]] Result<void> judgeRandomPhase(const ComparedResult& result, bool hasGivenSpectrum,
                                            const GaussianTargets& targets,
                                            NoiseComparison& comparison);

/// A power spectral density of width x height frequencies as grey: white is the largest, black less
/// by 50 decibels or more.
[[nodiscard]] LinearImage spectrumPicture(const std::vector<double>& density, int width,
                                          int height);

} // namespace lichen
