// SPDX-License-Identifier: MIT
// The cross-spectra of an exemplar's Gaussian channels -> how strongly each channel follows each
// cosine, in which variants.
#pragma once

#include "cosine_fit.h"
#include "random_phase/map_spectrum.h"

#include <Eigen/Dense>

#include <vector>

namespace lichen::local_random_phase {

using random_phase::MapSpectrum;

/// Vectors over all channels, map after map. vectors[j](c, v): what variant v of cosine j adds to
/// the amplitude of channel c, in Gaussian values, and phases[j](m, v) what it adds to the phase of
/// map m [turns].
struct CosineVectors {
  int variants = 1; ///< a power of two
  std::vector<Eigen::MatrixXd> vectors;
  std::vector<Eigen::MatrixXd> phases;
};

/// The covariance of the noise equals the channels' covariance, up to rounding. All variants of a
/// cosine change the luminance equally much: otherwise a few of the cosines would dominate at each
/// vertex, and strokes along their waves would show. Throws std::bad_alloc.
[[nodiscard]] CosineVectors cosineVectors(const std::vector<MapSpectrum>& maps,
                                          const std::vector<Cosine>& cosines);

} // namespace lichen::local_random_phase
