// SPDX-License-Identifier: MIT
// A regular pattern and what the noise has beside it. [MKN12] section 5.
#pragma once

#include "random_phase/map_spectrum.h"

#include <lichen/multiple_kernels.h>

#include <Eigen/Dense>

#include <vector>

namespace lichen::multiple_kernels {

/// One frequency of a pattern: of each channel of all maps the factors of the cosine and the sine,
/// in standard deviations of Gaussian values.
struct PatternTerm {
  int u = 0, v = 0;
  Eigen::MatrixX2d waves;
};

/// A pattern, and what the exemplar was before it was taken.
struct TakenPattern {
  std::vector<PatternTerm> terms;
  /// The covariance of all channels of all maps, in squared deviations.
  Eigen::MatrixXd whole;
  /// For a given pattern: how all channels follow the luminance, the covariance with it where it
  /// has the variance 1. Empty for the exemplar's own.
  Eigen::VectorXd luminance;
};

/// The pattern of a perturbation: the exemplar's own waves, or given ones with its variance along
/// luminance. Takes the power at its frequencies out of `maps`, which are then the noise's. Throws
/// std::bad_alloc.
[[nodiscard]] TakenPattern takePattern(const Perturbation& perturbation,
                                       std::vector<random_phase::MapSpectrum>& maps);

/// What the channels of one map are multiplied with.
struct PerturbedScale {
  Eigen::MatrixXd pattern, noise;
};

/// For each map, so that both together have the covariance of the whole. The exemplar's own pattern
/// and the noise are scaled alike, after the noise was by the amount. A given one takes its share
/// of the luminance, 1 / (1 + amount^2), and the noise has the rest of the covariance. `noise`: the
/// covariance of the noise, in squared deviations.
[[nodiscard]] std::vector<PerturbedScale>
perturbedScales(const TakenPattern& pattern, const Eigen::MatrixXd& noise,
                const std::vector<Eigen::Index>& firstChannels, double amount);

} // namespace lichen::multiple_kernels
