// SPDX-License-Identifier: MIT
// Amplitudes at frequencies -> the transform of one random field that has them. [LRP14] section
// 6.1, figure 10.
#include "given_spectrum.h"

#include "transport/covariance_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace lichen::spectra {
namespace {

/// A channel of a picture, or kAll for the mean of their powers.
constexpr int kAll = -1;

/// The power at a frequency of the half plane and at its mirror, as a field is real.
double powerAt(const SpectrumPicture& picture, int channel, int u, int v) {
  const auto at = [&](int x, int y) {
    x += picture.width / 2;
    y += picture.height / 2;
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height)
      return 0.0;
    const float* pixel =
        &picture.amplitudes[std::size_t(picture.channels) *
                            (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
    double mean = 0.0;
    for (int c = 0; c < picture.channels; ++c)
      mean += double(pixel[c]) * double(pixel[c]) / picture.channels;
    if (channel == kAll)
      return mean;
    // A tenth of the mean amplitude of all in each, so that a picture of one hue still has all of
    // the map's colours.
    constexpr double kShared = 0.01;
    return double(pixel[channel]) * double(pixel[channel]) + kShared * mean;
  };
  return 0.5 * (at(u, v) + at(-u, -v));
}

/// Replaces one channel; returns false if the picture has no power at its frequencies.
bool replaceChannel(const SpectrumPicture& picture, int channel, double variance,
                    std::uint32_t seed, HalfSpectrum& spectrum) {
  std::mt19937 generator(seed);
  double sum = 0.0;
  for (int row = 0; row < spectrum.height; ++row) {
    const int v = spectrum.signedRow(row);
    for (int u = 0; u < spectrum.columns(); ++u) {
      // The bits as they are: distributions differ between libraries.
      const double turns = double(generator()) * 0x1p-32;
      const bool hasMirror = 2 * u < spectrum.width && 2 * std::abs(v) < spectrum.height;
      const double power = hasMirror && (u != 0 || v != 0) ? powerAt(picture, channel, u, v) : 0.0;
      sum += spectrum.multiplicity(u) * power;
      spectrum.at(u, row) =
          std::complex<float>(std::polar(std::sqrt(power), 2.0 * std::numbers::pi * turns));
    }
  }
  if (!(sum > 0.0))
    return false;
  // Column 0 holds both mirrors.
  for (int row = spectrum.height / 2 + 1; row < spectrum.height; ++row)
    spectrum.at(0, row) = std::conj(spectrum.at(0, spectrum.height - row));
  const auto scale = float(std::sqrt(variance / sum));
  for (std::complex<float>& value : spectrum.values)
    value *= scale;
  return true;
}

/// The sum of the powers of a channel of a picture at the frequencies of a transform.
double sumOf(const SpectrumPicture& picture, int channel, const HalfSpectrum& spectrum) {
  double sum = 0.0;
  for (int row = 0; row < spectrum.height; ++row)
    for (int u = 0; u < spectrum.columns(); ++u)
      if (const int v = spectrum.signedRow(row);
          2 * u < spectrum.width && 2 * std::abs(v) < spectrum.height && (u != 0 || v != 0))
        sum += spectrum.multiplicity(u) * powerAt(picture, channel, u, v);
  return sum;
}

/// Replaces the channels of a colour map by what makes its stored values follow the channels of the
/// picture, with the covariance that they had in the mean over phases. Returns false as
/// replaceChannel().
bool replaceColors(const SpectrumPicture& picture, std::uint32_t seed, MapSpectrum& map) {
  const auto count = Eigen::Index(map.channels.size());
  std::vector<HalfSpectrum> stored = map.channels;
  for (std::size_t c = 0; c < stored.size(); ++c)
    if (!replaceChannel(picture, int(c), sumOf(picture, int(c), stored[c]), seed + std::uint32_t(c),
                        stored[c]))
      return false;
  const Eigen::MatrixXd fromStored = map.toStored.inverse();
  Eigen::MatrixXd ofStored = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index c = 0; c < count; ++c)
    ofStored(c, c) = sumOf(picture, int(c), stored[std::size_t(c)]); // they are independent
  const Eigen::MatrixXd own = fromStored * ofStored * fromStored.transpose();
  const Eigen::MatrixXf factors =
      (transport::covarianceMap<Eigen::MatrixXd>(own, map.covariance) * fromStored).cast<float>();
  map.fromIndependent = factors.cast<double>();
  map.toIndependent = map.fromIndependent.inverse();
  for (std::size_t i = 0; i < stored[0].values.size(); ++i) {
    Eigen::VectorXcf values(count);
    for (Eigen::Index c = 0; c < count; ++c)
      values[c] = stored[std::size_t(c)].values[i];
    const Eigen::VectorXcf mixed = factors * values;
    for (Eigen::Index c = 0; c < count; ++c)
      map.channels[std::size_t(c)].values[i] = mixed[c];
  }
  return true;
}

bool replaceMap(const SpectrumPicture& picture, std::uint32_t seed, MapSpectrum& map) {
  constexpr std::size_t kColors = 3;
  if (picture.channels == int(kColors) && map.channels.size() == kColors && !map.luminance.empty())
    return replaceColors(picture, seed, map);
  const auto count = Eigen::Index(map.channels.size());
  for (Eigen::Index c = 0; c < count; ++c)
    if (!replaceChannel(picture, kAll, map.covariance(c, c), seed + std::uint32_t(c),
                        map.channels[std::size_t(c)]))
      return false;
  map.fromIndependent = map.toIndependent = Eigen::MatrixXd::Identity(count, count);
  return true;
}

} // namespace

Result<void> replaceSpectra(const SpectrumPicture& picture, std::vector<MapSpectrum>& maps) {
  std::uint32_t seed = 1;
  for (MapSpectrum& map : maps) {
    if (!replaceMap(picture, seed, map)) {
      const HalfSpectrum& own = map.channels[0];
      return Error{ErrorKind::badInput,
                   "the spectrum has no power at the frequencies of an exemplar of " +
                       std::to_string(own.width) + " x " + std::to_string(own.height) +
                       "; expected some below " +
                       std::to_string(std::max(own.width, own.height) / 2) + " cycles per tile"};
    }
    seed += std::uint32_t(map.channels.size());
  }
  return {};
}

} // namespace lichen::spectra
