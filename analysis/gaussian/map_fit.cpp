// SPDX-License-Identifier: MIT
// Map (width * height * channels) -> matched Gaussian points (width * height) and inverse table.
#include "map_fit.h"

#include "exemplar/resample.h"
#include "exemplar/value_encoding.h"
#include "table_lookup.h"

#include <lichen/lattice.h>
#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace lichen::gaussian {
namespace {

/// In pixels. The share for a larger map is chosen on its middle.
constexpr int kLargestTrialSide = 512;

/// Twelve exemplars need -0.1 to 0.35.
constexpr float kLeastShare = -0.25f;

/// A trial costs as much as a bake without a choice. After two, a line through both leaves less
/// than the tolerance on all twelve exemplars.
constexpr int kMostTrials = 3;

/// Decibels, of the mean over radii. Differences between radii add to it and cannot be corrected by
/// one number; together they should stay below 0.6.
constexpr double kToleranceDb = 0.25;

/// Decibels per unit of share: twelve exemplars have -2 to -4.
constexpr double kTypicalSlope = -3.0;

/// The detail that blending adds falls as the share grows; a flatter measured slope is noise.
constexpr double kLeastSlope = 0.5 * kTypicalSlope;

/// The next trial's part of the remaining progress of trials: 15 of 18 exemplars need only one.
constexpr double kTrialOfRest = 0.8;

/// Part of a fit's progress before it is correlated with settled maps, which takes 0.15 to 0.25 of
/// its time on the photographed sets, 512 x 512.
constexpr double kAloneOfProgress = 0.8;

/// Mean squared difference of adjacent pixels over twice the variance, all channels together:
/// 1 minus their correlation.
double neighbourDifference(const MapExemplar& map, const exemplar::ColorSpace& space) {
  const std::size_t channels = map.channels.size();
  const auto width = std::size_t(map.width), height = std::size_t(map.height);
  const auto squares = [&](std::size_t columns, std::size_t rows, std::size_t step) {
    double sum = 0.0;
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t k = y * width * channels; k < (y * width + columns) * channels; ++k) {
        const double difference = double(map.values[k + step]) - double(map.values[k]);
        sum += difference * difference;
      }
    return sum;
  };
  const double sum =
      squares(width - 1, height, channels) + squares(width, height - 1, width * channels);
  const double pairs = double(width - 1) * double(height) + double(width) * double(height - 1);
  return sum / (2.0 * pairs * space.moments.covariance.trace());
}

/// Finer detail needs a smaller share. Least squares on two windows of each of six photographs and
/// on the generated materials, with a standard deviation of 0.057 from the share without error. It
/// leaves 3 of the 18 with an error beyond the tolerance; a share of 0.1 for all leaves 8.
float expectedShare(const MapExemplar& map, const exemplar::ColorSpace& space, float largest) {
  constexpr double kSmooth = 0.32, kSlope = -0.81;
  const double difference = neighbourDifference(map, space);
  return std::clamp(float(kSmooth + kSlope * difference), kLeastShare, largest);
}

bool isTriedOnMiddle(const MapExemplar& map) {
  return std::max(map.width, map.height) > kLargestTrialSide;
}

MapExemplar middleOf(const MapExemplar& map) {
  const int width = std::min(map.width, kLargestTrialSide);
  const int height = std::min(map.height, kLargestTrialSide);
  return exemplar::cropped(map,
                           {(map.width - width) / 2, (map.height - height) / 2, width, height});
}

/// Fits Gaussian image and table with a share of the surroundings in every point.
MapFit fitWith(const MapExemplar& map, const exemplar::ColorSpace& space, float share,
               const MapFitOptions& options) {
  const std::vector<Point> points = exemplar::transportPoints(map, space, share);
  transport::TransportOptions transport;
  transport.progress = options.progress.part(0.0, 0.7);
  MapFit fit{
      share,
      gaussianize(map, points, space.dimensions(), options.borders, options.precision, transport),
      {}};
  std::vector<float> values(map.values.size());
  std::transform(map.values.begin(), map.values.end(), values.begin(),
                 [&](float value) { return exemplar::tableValue(value, map.encoding); });
  transport.progress = options.progress.part(0.7, 1.0);
  fit.table =
      fitInverseTable(fit.gaussian, points, values, int(map.channels.size()), transport,
                      map.encoding == ValueEncoding::slope ? CellValue::mean : CellValue::onePixel);
  return fit;
}

/// The zero of a line through the last two trials, or through one with the typical slope.
float nextShare(const std::vector<std::array<double, 2>>& tried, float largestShare) {
  const auto [share, error] = tried.back();
  double slope = kTypicalSlope;
  if (tried.size() > 1) {
    const auto [shareBefore, errorBefore] = tried[tried.size() - 2];
    slope = std::min((error - errorBefore) / (share - shareBefore), kLeastSlope);
  }
  return std::clamp(float(share - error / slope), kLeastShare, largestShare);
}

/// Tries shares until one is good enough; returns the best.
MapFit bestTrial(const MapExemplar& map, const exemplar::ColorSpace& space,
                 const MapFitOptions& options) {
  MapFit best;
  double bestError = 0.0;
  std::vector<std::array<double, 2>> tried;
  float share = expectedShare(map, space, options.largestShare);
  ProgressPart rest = options.progress;
  for (int k = 0; k < kMostTrials; ++k) {
    MapFitOptions once = options;
    once.progress = rest.part(0.0, kTrialOfRest);
    rest = rest.part(kTrialOfRest, 1.0);
    MapFit fit = fitWith(map, space, share, once);
    const double error = spectrumErrorDb(map, fit.gaussian, fit.table);
    tried.push_back({double(share), error});
    if (k == 0 || std::abs(error) < std::abs(bestError)) {
      best = std::move(fit);
      bestError = error;
    }
    const float next = nextShare(tried, options.largestShare);
    if (std::abs(error) <= kToleranceDb || next == share)
      break;
    share = next;
  }
  return best;
}

/// Fits the map without regard to other maps.
MapFit fitAlone(const MapExemplar& map, const exemplar::ColorSpace& space,
                const MapFitOptions& options) {
  if (options.share || space.dimensions() == 1)
    return fitWith(map, space, options.share.value_or(exemplar::kUsualShare), options);
  if (!hasSpectrum(map))
    return fitWith(map, space, std::min(exemplar::kUsualShare, options.largestShare), options);
  if (!isTriedOnMiddle(map))
    return bestTrial(map, space, options);
  const double middle = double(kLargestTrialSide) * double(kLargestTrialSide);
  const double tried = middle / (middle + double(map.width) * double(map.height));
  MapFitOptions trial = options;
  trial.progress = options.progress.part(0.0, tried);
  trial.borders.fit = false;
  const float share = bestTrial(middleOf(map), space, trial).share;
  MapFitOptions whole = options;
  whole.progress = options.progress.part(tried, 1.0);
  return fitWith(map, space, share, whole);
}

} // namespace

MapFit fitMap(const MapExemplar& map, const exemplar::ColorSpace& space,
              const MapFitOptions& options) {
  if (options.settled.empty())
    return fitAlone(map, space, options);
  MapFitOptions alone = options;
  alone.progress = options.progress.part(0.0, kAloneOfProgress);
  MapFit fit = fitAlone(map, space, alone);
  fit.gaussian =
      withCrossCovariances(map, space, options.settled, std::move(fit.gaussian), fit.table,
                           options.borders, options.progress.part(kAloneOfProgress, 1.0));
  return fit;
}

// Exemplar, Gaussian image and inverse table -> decibels between the spectra of noise and exemplar.
namespace {

constexpr int kSmallestWindow = 16;

/// Texels of noise in all windows: as many as 1024 x 1024 pixels.
constexpr int kSampledTexels = 1 << 20;

int windowSide(const MapExemplar& map) { return comparedCropSide(std::min(map.width, map.height)); }

using Spectrum = std::vector<double>;
using Planes = std::vector<std::vector<float>>;

/// Power by radius in cycles per window, summed over the planes.
Spectrum powerOf(const Planes& planes, int width, int height, int window) {
  Spectrum sum(std::size_t(window / 2 + 1), 0.0);
  for (const std::vector<float>& plane : planes) {
    const Spectrum power = radialPowerSpectrum(plane, width, height, window);
    std::transform(sum.begin(), sum.end(), power.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

/// Colour becomes luminance, as the eye perceives its detail; other maps keep every channel.
Planes planesOf(const MapExemplar& map, std::vector<float> values, int width, int height) {
  const std::size_t channels = map.channels.size();
  if (map.target == MapTarget::baseColor || map.target == MapTarget::emissive) {
    SrgbImage image;
    image.width = width;
    image.height = height;
    image.channels = int(channels);
    image.values = std::move(values);
    return {luminancePlane(image)};
  }
  Planes planes(channels);
  for (std::size_t i = 0; i < values.size(); ++i)
    planes[i % channels].push_back(values[i]);
  return planes;
}

/// Three windows anywhere in the image, with wrapping, and the weights that blend them.
struct Blend {
  std::array<std::array<int, 2>, 3> corners;
  std::array<float, 3> weights;
};

Blend blendAt(std::uint32_t sample, const Gaussianized& gaussian) {
  const std::array<std::uint32_t, 3> columns = pcg3d({sample, 0u, 0u});
  const std::array<std::uint32_t, 3> rows = pcg3d({sample, 1u, 0u});
  const std::array<std::uint32_t, 3> place = pcg3d({sample, 2u, 0u});
  Blend blend{{}, randomBlendWeights(place[0], place[1])};
  for (std::size_t k = 0; k < 3; ++k)
    blend.corners[k] = {int(columns[k] % std::uint32_t(gaussian.width)),
                        int(rows[k] % std::uint32_t(gaussian.height))};
  return blend;
}

template <std::size_t kDimensions>
std::vector<float> noiseWindow(const Gaussianized& gaussian, const TableLookup<kDimensions>& lookup,
                               const Blend& blend, std::size_t channels, int window) {
  std::vector<float> values;
  values.reserve(std::size_t(window) * std::size_t(window) * channels);
  constexpr auto kMean = float(gaussian::kGaussianMean);
  for (int y = 0; y < window; ++y)
    for (int x = 0; x < window; ++x) {
      std::array<float, 3> value{kMean, kMean, kMean};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [left, top] = blend.corners[k];
        const auto row = std::size_t((top + y) % gaussian.height);
        const auto column = std::size_t((left + x) % gaussian.width);
        const Point& p = gaussian.image[row * std::size_t(gaussian.width) + column];
        value[0] += blend.weights[k] * (p.x - kMean);
        value[1] += blend.weights[k] * (p.y - kMean);
        value[2] += blend.weights[k] * (p.z - kMean);
      }
      const TableValue looked = lookup(value);
      for (std::size_t c = 0; c < channels; ++c)
        values.push_back(looked[c]);
    }
  return values;
}

template <std::size_t kDimensions>
Spectrum noisePower(const MapExemplar& map, const Gaussianized& gaussian, const InverseTable& table,
                    int window) {
  InverseTable encodedTable = table;
  for (float& value : encodedTable.values)
    value = exemplar::storedOfTable(value, map.encoding);
  const TableLookup<kDimensions> lookup(encodedTable);
  const auto count = std::uint32_t(kSampledTexels / (window * window));
  std::vector<Spectrum> powers(count);
  tbb::parallel_for(0u, count, [&](std::uint32_t sample) {
    const Blend blend = blendAt(sample, gaussian);
    std::vector<float> values = noiseWindow(gaussian, lookup, blend, map.channels.size(), window);
    powers[sample] =
        powerOf(planesOf(map, std::move(values), window, window), window, window, window);
  });
  Spectrum mean(powers.front().size(), 0.0);
  for (const Spectrum& power : powers)
    for (std::size_t radius = 0; radius < mean.size(); ++radius)
      mean[radius] += power[radius] / double(count);
  return mean;
}

Spectrum noisePower(const MapExemplar& map, const Gaussianized& gaussian, const InverseTable& table,
                    int window) {
  switch (table.dimensions) {
  case 1:
    return noisePower<1>(map, gaussian, table, window);
  case 2:
    return noisePower<2>(map, gaussian, table, window);
  default:
    return noisePower<3>(map, gaussian, table, window);
  }
}

} // namespace

bool hasSpectrum(const MapExemplar& map) { return windowSide(map) >= kSmallestWindow; }

double spectrumErrorDb(const MapExemplar& map, const Gaussianized& gaussian,
                       const InverseTable& table) {
  assert(hasSpectrum(map));
  const int window = windowSide(map);
  const Spectrum exemplar =
      powerOf(planesOf(map, map.values, map.width, map.height), map.width, map.height, window);
  const Spectrum noise = noisePower(map, gaussian, table, window);
  // Power below the power of rounding the stored values counts as none.
  const double roundingPower = map.quantum * map.quantum / 12.0;
  const auto decibels = [&](double power) {
    return 10.0 * std::log10(std::max(power, roundingPower));
  };
  double sum = 0.0;
  for (std::size_t radius = kLowestComparedCycles; radius < noise.size(); ++radius)
    sum += decibels(noise[radius]) - decibels(exemplar[radius]);
  return sum / double(noise.size() - kLowestComparedCycles);
}

} // namespace lichen::gaussian
