// SPDX-License-Identifier: MIT
// The spectra of a Gaussianized map, from which the methods of random phases are baked.
#pragma once

#include "gaussian/gaussianized_maps.h"
#include "power_tree.h"

#include <lichen/baked_noise.h>
#include <lichen/fft.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <Eigen/Dense>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

namespace lichen::random_phase {

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
[[nodiscard]] MapSpectrum spectrumOf(const gaussian::GaussianizedMap& map);

/// What a bake of random phases begins with: Gaussianizes the maps into `bake`, and sets the size
/// of the tile in `shared`, the spectrum of each map, and the dimensions and the table of its data.
/// Errors: as gaussianizeMaps(). Throws std::bad_alloc.
template <class Shared, class Data>
[[nodiscard]] Result<void> beginBake(const std::string& name, std::span<const MapExemplar> maps,
                                     const GaussianizationOptions& options, MethodBake& bake,
                                     Shared& shared, std::vector<MapSpectrum>& spectra,
                                     std::vector<Data>& data) {
  const auto append = [&](gaussian::GaussianizedMap map) {
    shared.texelsPerTileX = std::max(shared.texelsPerTileX, map.image.width);
    shared.texelsPerTileY = std::max(shared.texelsPerTileY, map.image.height);
    spectra.push_back(spectrumOf(map));
    Data& own = data.emplace_back();
    own.dimensions = map.image.dimensions;
    if (map.inverse)
      own.inverseTable = gaussian::appended(*std::move(map.inverse), bake.tables);
    bake.noise.maps.push_back(std::move(map.map));
  };
  const Result<gaussian::BorderTreatment> borders =
      gaussian::gaussianizeMaps(name, maps, options, gaussian::UsesGrain::no, append);
  if (!borders)
    return borders.error();
  bake.figures.bordersWereKept = borders.value().fit;
  return {};
}

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

/// Replaces the transforms of all maps by transforms of random fields with the powers of `picture`
/// in each channel, and the variances that they had. The channels have phases of their own; of a
/// coloured picture the stored channels of colour maps do, and the channels are sums of them with
/// the covariance that they had. MapSpectrum::fromIndependent says so. Errors:
/// badInput for a picture without power at the frequencies of a map. Throws std::bad_alloc.
[[nodiscard]] Result<void> replaceSpectra(const SpectrumPicture& picture,
                                          std::vector<MapSpectrum>& maps);

} // namespace lichen::random_phase
