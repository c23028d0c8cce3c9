// SPDX-License-Identifier: MIT
// A Gaussianized map -> its transforms, and how its stored values follow them; several -> one power
// spectrum.
#include "map_spectrum.h"

#include "gaussian/gaussian_distribution.h"
#include "transport/covariance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace lichen::random_phase {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

/// The spectrum of a Gaussian image of at least one dimension.
MapSpectrum transformsOf(const gaussian::Gaussianized& image) {
  MapSpectrum result;
  const auto pixels = image.image.size();
  constexpr auto kMean = float(gaussian::kGaussianMean);
  constexpr auto kPerDeviation = float(1.0 / gaussian::kGaussianDeviation);
  const auto isConstant = [&] {
    const Point& first = image.image.front();
    return std::all_of(image.image.begin(), image.image.end(), [&](const Point& point) {
      return point.x == first.x && point.y == first.y && point.z == first.z;
    });
  };
  if (isConstant())
    return result;
  const float scale = kPerDeviation / float(pixels);
  for (int channel = 0; channel < image.dimensions; ++channel) {
    std::vector<float> plane;
    plane.reserve(pixels);
    for (const Point& point : image.image)
      plane.push_back(scale * ((channel == 0   ? point.x
                                : channel == 1 ? point.y
                                               : point.z) -
                               kMean));
    result.channels.push_back(forwardFft(plane, image.width, image.height));
  }
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Point& point : image.image) {
    const Eigen::Vector3d value =
        double(kPerDeviation) *
        (Eigen::Vector3f(point.x, point.y, point.z).array() - kMean).matrix().cast<double>();
    squares += value * value.transpose();
  }
  result.covariance = squares.topLeftCorner(image.dimensions, image.dimensions) / double(pixels);
  return result;
}

/// How stored values follow the Gaussian channels about their mean, to the first order, scaled as
/// MapSpectrum::toStored: by the root of their covariance, the symmetric one with a table, the
/// triangular one without.
Eigen::MatrixXd toStoredOf(const gaussian::GaussianizedMap& map) {
  const auto channels = Eigen::Index(map.map.mean.size());
  if (channels != map.image.dimensions) // which axes the Gaussian ones are is not known
    return Eigen::MatrixXd::Identity(map.image.dimensions, map.image.dimensions);
  const Eigen::MatrixXd covariance =
      Eigen::Map<const Eigen::MatrixXd>(map.map.covariance.data(), channels, channels);
  const Eigen::MatrixXd root = map.inverse ? transport::power<Eigen::MatrixXd>(covariance, 0.5)
                                           : Eigen::MatrixXd(covariance.llt().matrixL());
  return std::sqrt(double(channels)) / root.norm() * root;
}

/// How luminance follows the Gaussian channels of a colour map about its mean, to the first order
/// and up to a factor. Empty for others.
std::vector<double> luminanceOf(const gaussian::GaussianizedMap& map,
                                const Eigen::MatrixXd& toStored) {
  constexpr std::array<double, 3> kLuminance{0.2126, 0.7152, 0.0722}; // ITU-R BT.709
  const bool isColor =
      map.map.target == MapTarget::baseColor || map.map.target == MapTarget::emissive;
  if (!isColor || map.image.dimensions != int(kLuminance.size()))
    return {};
  Eigen::Vector3d ofStored(kLuminance.data());
  if (map.map.encoding == ValueEncoding::root) // light is the square
    ofStored = ofStored.cwiseProduct(Eigen::Vector3d(map.map.mean.data()));
  const Eigen::Vector3d luminance = toStored.transpose() * ofStored;
  return {luminance[0], luminance[1], luminance[2]};
}

} // namespace

MapSpectrum spectrumOf(const gaussian::GaussianizedMap& map) {
  MapSpectrum result = transformsOf(map.image);
  if (!result.channels.empty()) {
    result.toStored = toStoredOf(map);
    result.luminance = luminanceOf(map, result.toStored);
  }
  return result;
}

Complex MapSpectrum::at(std::size_t channel, int u, int v) const {
  const HalfSpectrum& spectrum = channels[channel];
  if (2 * u >= spectrum.width || 2 * std::abs(v) >= spectrum.height)
    return {};
  return Complex(spectrum.at(u, v < 0 ? v + spectrum.height : v));
}

std::vector<Index> firstChannels(const std::vector<MapSpectrum>& maps) {
  std::vector<Index> first{0};
  for (const MapSpectrum& map : maps)
    first.push_back(first.back() + Index(map.channels.size()));
  return first;
}

Eigen::MatrixXd powerWeights(const std::vector<MapSpectrum>& maps) {
  const std::vector<Index> first = firstChannels(maps);
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(first.back(), first.back());
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Eigen::MatrixXd& own = maps[m].toStored;
    weights.block(first[m], first[m], own.cols(), own.cols()) = own.transpose() * own;
  }
  return weights;
}

Eigen::MatrixXcd crossPower(const std::vector<MapSpectrum>& maps, int u, int v) {
  const std::vector<Index> first = firstChannels(maps);
  VectorXcd values(first.back());
  Index row = 0;
  for (const MapSpectrum& map : maps)
    for (std::size_t c = 0; c < map.channels.size(); ++c)
      values[row++] = map.at(c, u, v);
  Eigen::MatrixXcd products = values * values.adjoint();
  for (std::size_t m = 0; m < maps.size(); ++m)
    if (const Eigen::MatrixXd& mixing = maps[m].fromIndependent; mixing.size() > 0) {
      const Index count = first[m + 1] - first[m];
      const Eigen::VectorXd powers =
          (maps[m].toIndependent * values.segment(first[m], count)).cwiseAbs2();
      products.middleRows(first[m], count).setZero();
      products.middleCols(first[m], count).setZero();
      products.block(first[m], first[m], count, count) =
          (mixing * powers.asDiagonal() * mixing.transpose()).cast<Complex>();
    }
  return products;
}

void setMapCovariances(Eigen::MatrixXd& covariance, const std::vector<MapSpectrum>& maps) {
  const std::vector<Index> first = firstChannels(maps);
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Index count = first[m + 1] - first[m];
    if (count == 0)
      continue;
    const Eigen::MatrixXd own = covariance.block(first[m], first[m], count, count);
    const Eigen::MatrixXd map = transport::covarianceMap<Eigen::MatrixXd>(own, maps[m].covariance);
    covariance.middleRows(first[m], count) = (map * covariance.middleRows(first[m], count)).eval();
    covariance.middleCols(first[m], count) = (covariance.middleCols(first[m], count) * map).eval();
  }
}

PowerPlane powerPlane(const std::vector<MapSpectrum>& maps) {
  int width = 1, height = 1;
  for (const MapSpectrum& map : maps)
    for (const HalfSpectrum& channel : map.channels) {
      width = std::max(width, channel.width);
      height = std::max(height, channel.height);
    }
  PowerPlane power;
  power.columns = (width + 1) / 2;
  power.rows = 2 * ((height - 1) / 2) + 1;
  power.values.assign(std::size_t(power.columns) * std::size_t(power.rows), 0.0);
  tbb::parallel_for(0, power.rows, [&](int row) {
    for (const MapSpectrum& map : maps) {
      VectorXcd values(Index(map.channels.size()));
      const bool isGiven = map.fromIndependent.size() > 0;
      const Eigen::MatrixXd storedOfIndependent =
          isGiven ? Eigen::MatrixXd(map.toStored * map.fromIndependent) : Eigen::MatrixXd();
      for (int u = 0; u < power.columns; ++u) {
        for (Index c = 0; c < values.size(); ++c)
          values[c] = map.at(std::size_t(c), u, row - power.rows / 2);
        power.values[std::size_t(row) * std::size_t(power.columns) + std::size_t(u)] +=
            isGiven ? (storedOfIndependent * VectorXcd(map.toIndependent * values).asDiagonal())
                          .squaredNorm() // as crossPower()
                    : (map.toStored * values).squaredNorm();
      }
    }
  });
  return power;
}

// Amplitudes at frequencies -> the transform of one random field that has them. [LRP14] section
// 6.1, figure 10.
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

} // namespace lichen::random_phase
