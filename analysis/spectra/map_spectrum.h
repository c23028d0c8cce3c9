// SPDX-License-Identifier: MIT
// The spectra of a Gaussianized map, from which the methods of random phases are baked.
#pragma once

#include "gaussianization/gaussianized_maps.h"
#include "power_tree.h"

#include <lichen/fft.h>

#include <Eigen/Dense>

#include <complex>
#include <cstddef>
#include <vector>

namespace lichen::spectra {

/// The channels of one map as transforms over the tile, divided by the number of its pixels, and by
/// the standard deviation of a Gaussian value. Empty for a map that does not vary.
struct MapSpectrum {
  std::vector<HalfSpectrum> channels;
  /// The channels' covariance, in squared standard deviations. Subtraction may leave eigenvalues
  /// that are negative by rounding.
  Eigen::MatrixXd covariance;
  /// For a given spectrum: the channels are `fromIndependent` times channels with phases of their
  /// own, and `toIndependent` is its inverse. Empty for an exemplar's.
  Eigen::MatrixXd fromIndependent, toIndependent;
  /// How the stored values follow the channels, to the first order: a square matrix whose squares
  /// sum to the number of channels.
  Eigen::MatrixXd toStored;
  /// How luminance follows each channel, up to a factor; empty where the map has no luminance.
  std::vector<double> luminance;

  /// The coefficient of frequency (u, v) in cycles per tile, u >= 0; 0 beyond the map's own.
  [[nodiscard]] std::complex<double> at(std::size_t channel, int u, int v) const;
};

/// The transforms of a Gaussianized map. Throws std::bad_alloc.
[[nodiscard]] MapSpectrum spectrumOf(const gaussianization::GaussianizedMap& map);

/// The first channel of each map among all channels, and their number.
[[nodiscard]] std::vector<Eigen::Index> firstChannels(const std::vector<MapSpectrum>& maps);

/// The cross-power of all channels at a frequency: f f^H, where f holds the channels. Channels of a
/// given spectrum have random phases, and their cross-power is its mean over these: a spectrum of
/// few frequencies has too few phases to average.
[[nodiscard]] Eigen::MatrixXcd crossPower(const std::vector<MapSpectrum>& maps, int u, int v);

/// What the real part of crossPower() is multiplied with, so that the sum is the power as
/// powerPlane() has it.
[[nodiscard]] Eigen::MatrixXd powerWeights(const std::vector<MapSpectrum>& maps);

/// Gives a covariance of all channels, a sum over the plane's frequencies, each map's own
/// covariance within the map: the highest frequencies of even sizes have no mirror and are not in
/// the plane, but belong to the covariance all the same.
void setMapCovariances(Eigen::MatrixXd& covariance, const std::vector<MapSpectrum>& maps);

/// The sum of the power of all stored values of all maps: a channel counts as much as it changes
/// them. Columns and rows are the largest maps', without the highest frequencies of even sizes,
/// which have no mirror.
[[nodiscard]] PowerPlane powerPlane(const std::vector<MapSpectrum>& maps);

} // namespace lichen::spectra
