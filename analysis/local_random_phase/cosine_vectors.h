// SPDX-License-Identifier: MIT
// The cross-spectra of an exemplar's Gaussian channels -> how strongly each channel follows each
// cosine, in which variants.
#pragma once

#include "cosine_fit.h"

#include <lichen/fft.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace lichen::local_random_phase {

/// The channels of one map as transforms over the tile, divided by the number of its pixels, and by
/// the standard deviation of a Gaussian value. Empty for a map that does not vary.
struct MapSpectrum {
  std::vector<HalfSpectrum> channels;
  std::vector<double> variances; ///< of each channel, in squared standard deviations
  /// How the stored values follow the channels, to the first order: a square matrix whose squares
  /// sum to the number of channels.
  Eigen::MatrixXd toStored;
  /// How luminance follows each channel, up to a factor; empty where the map has no luminance.
  std::vector<double> luminance;

  /// The coefficient of frequency (u, v) in cycles per tile, u >= 0; 0 beyond the map's own.
  [[nodiscard]] std::complex<double> at(std::size_t channel, int u, int v) const;
};

/// The sum of the power of all stored values of all maps: a channel counts as much as it changes
/// them. Columns and rows are those of the largest maps, without the highest frequencies of even
/// sizes, which have no mirror.
[[nodiscard]] PowerPlane powerPlane(const std::vector<MapSpectrum>& maps);

/// Vectors over all channels, map after map. vectors[j](c, v): what variant v of cosine j adds to
/// the amplitude of channel c, in Gaussian values, and phases[j](m, v) what it adds to the phase of
/// map m [turns].
struct CosineVectors {
  int variants = 1; ///< a power of two
  std::vector<Eigen::MatrixXd> vectors;
  std::vector<Eigen::MatrixXd> phases;
};

/// The covariance of the noise is that of the channels, up to rounding. Of each cosine, all
/// variants change the luminance equally much: otherwise a few of the cosines would dominate at
/// each vertex, and strokes along their waves would show. Throws std::bad_alloc.
[[nodiscard]] CosineVectors cosineVectors(const std::vector<MapSpectrum>& maps,
                                          const std::vector<Cosine>& cosines);

} // namespace lichen::local_random_phase
