// SPDX-License-Identifier: MIT
// Exemplar, Gaussian image and inverse table -> decibels between the spectra of noise and exemplar.
#include "spectrum_error.h"

#include "exemplar/value_encoding.h"
#include "random_blend.h"
#include "table_lookup.h"

#include <lichen/lattice.h>
#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace lichen::gaussianization {
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

} // namespace lichen::gaussianization
