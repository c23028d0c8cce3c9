// SPDX-License-Identifier: MIT
// What noises of random phases with the exemplar's histogram are judged by: the Gaussian version of
// the exemplar, its Gaussian values with random phases, decoded.
#pragma once

#include "method_report.h"

#include <cstdint>
#include <vector>

namespace lichen {

/// The risk "outlines"; where it is not none, `more` are settings that help before its own. Slow
/// variation is no risk: such a noise has it.
[[nodiscard]] Result<std::vector<Risk>> outlineRisks(const MapExemplar& map,
                                                     const std::vector<BakeSetting>& more,
                                                     const Progress& progress);

/// Measures the result against the exemplar's Gaussian version, or, of a noise with another
/// spectrum on purpose, against the exemplar's colours only.
[[nodiscard]] Result<void> judgeRandomPhase(const ComparedResult& result, bool hasGivenSpectrum,
                                            const GaussianTargets& targets,
                                            NoiseComparison& comparison);

/// The Gaussian version, as large as the exemplar, which must be within its ranges; decoded values
/// as synthesize() returns them. One phase serves all channels, so that the covariance of all
/// channels stays. Errors: as bakeTiling(). Throws std::bad_alloc. Source: [GGM11].
[[nodiscard]] Result<LinearImage> randomPhaseVersion(const MapExemplar& exemplar,
                                                     std::uint32_t seed);

} // namespace lichen
