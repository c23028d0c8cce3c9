// SPDX-License-Identifier: MIT
// Spectrum -> the frequencies with fixed phases -> B-spline coefficients of their sum.
//
// [LRP14] section 4.2 and 5: "the structure". Its images are stored, where the paper reduces them
// to blocks of cosines, which hold more numbers: docs/decisions/009-local-random-phase.md.
#include "structure.h"


#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <tuple>

namespace lichen::local_random_phase {
namespace {

/// The amplitude that a footprint leaves of a cosine, for the square of the cycles that it spans, as
/// lichenCosineRetained (shaders_glsl/noise/wave.glsl) has it.
double retainedAt(double squaredCycles) {
  constexpr double kSlope = 0.548311356; // pi^2 / 18
  return std::pow(std::clamp(1.0 - kSlope * squaredCycles, 0.0, 1.0), 3.0);
}

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

/// The root mean square, over all places between samples, of the cubic B-splines of a wave's
/// samples at `frequency` [cycles / sample], for an amplitude of root 2: of sums of squares of the
/// spline's transform sinc^4, which are the samples of the B-spline of degree 7.
double splineAmplitude(double frequency) {
  const auto cosine = [&](int k) { return std::cos(2.0 * std::numbers::pi * k * frequency); };
  return std::sqrt((2416.0 + 2.0 * (1191.0 * cosine(1) + 120.0 * cosine(2) + cosine(3))) / 5040.0);
}

/// The mean of exp(2 pi i f . s) over the offsets s.
Complex meanWave(const std::vector<std::array<double, 2>>& offsets, int u, int v) {
  if (offsets.empty())
    return 1.0;
  Complex sum = 0.0;
  for (const std::array<double, 2>& offset : offsets)
    sum += std::polar(1.0, 2.0 * std::numbers::pi * (u * offset[0] + v * offset[1]));
  return sum / double(offsets.size());
}

MatrixXd covarianceOf(const std::vector<HalfSpectrum>& channels) {
  const auto count = Index(channels.size());
  MatrixXd covariance = MatrixXd::Zero(count, count);
  for (Index c = 0; c < count; ++c)
    for (Index d = 0; d < count; ++d) {
      const HalfSpectrum &one = channels[std::size_t(c)], &other = channels[std::size_t(d)];
      for (int row = 0; row < one.height; ++row)
        for (int u = 0; u < one.columns(); ++u)
          covariance(c, d) +=
              one.multiplicity(u) * double((one.at(u, row) * std::conj(other.at(u, row))).real());
    }
  return covariance;
}

} // namespace

std::array<int, 2> FrequencySet::largest() const {
  std::array<int, 2> largest{};
  for (int v = -(rows_ / 2); v <= rows_ / 2; ++v)
    for (int u = 0; u < columns_; ++u)
      if (holds(u, v))
        largest = {std::max(largest[0], u), std::max(largest[1], std::abs(v))};
  return largest;
}

FrequencySet strongestFrequencies(const PowerPlane& power, double share) {
  struct Frequency {
    double order, power; // power around it, and its own
    int u, v;
  };
  const PowerPlane smooth = smoothed(power);
  std::vector<Frequency> all;
  double sum = 0.0;
  for (int v = -(power.rows / 2); v <= power.rows / 2; ++v)
    for (int u = 0; u < power.columns; ++u) {
      // (0, v) stands for (0, -v) too. An image cannot hold higher frequencies.
      const bool isHeld = 2 * u < kMostStructureTexels && 2 * std::abs(v) < kMostStructureTexels;
      if (!isHeld || (u == 0 && v <= 0))
        continue;
      all.push_back({smooth.at(u, v), power.at(u, v), u, v});
      sum += all.back().power;
    }
  std::sort(all.begin(), all.end(), [](const Frequency& a, const Frequency& b) {
    return std::tuple(-a.order, a.v, a.u) < std::tuple(-b.order, b.v, b.u);
  });
  FrequencySet set(power.columns, power.rows);
  double held = 0.0;
  for (const Frequency& frequency : all) {
    if (share < 1.0 && held >= share * sum)
      break;
    held += frequency.power;
    set.add(frequency.u, frequency.v);
    if (frequency.u == 0)
      set.add(0, -frequency.v);
  }
  return set;
}

SplitSpectrum split(MapSpectrum spectrum, const FrequencySet& set) {
  SplitSpectrum result{spectrum, std::move(spectrum)};
  for (std::size_t c = 0; c < result.inside.channels.size(); ++c) {
    HalfSpectrum &inside = result.inside.channels[c], &outside = result.outside.channels[c];
    for (int row = 0; row < inside.height; ++row) {
      const int v = inside.signedRow(row);
      for (int u = 0; u < inside.columns(); ++u) {
        const bool isInside = u < set.columns() && std::abs(v) <= set.rows() / 2 && set.holds(u, v);
        (isInside ? outside : inside).at(u, row) = 0.0f;
      }
    }
  }
  result.inside.covariance = covarianceOf(result.inside.channels);
  result.outside.covariance -= result.inside.covariance;
  return result;
}

std::array<int, 2> structureSize(const FrequencySet& set) {
  // A texel more than twice the highest frequency, whose phase would be lost otherwise.
  const auto side = [](int largest) {
    return std::max(int(std::bit_ceil(2u * unsigned(largest) + 1u)), kFewestStructureTexels);
  };
  const std::array<int, 2> largest = set.largest();
  return {side(largest[0]), side(largest[1])};
}

StructureImage structureImage(const MapSpectrum& inside, const CosineStructure& structure,
                              const std::vector<std::array<double, 2>>& offsets) {
  StructureImage image;
  for (int level = 0; level < structureLevels(structure); ++level) {
    StructureImage::Level own{structure.columns >> level, structure.rows >> level, {}};
    own.texels.resize(std::size_t(own.columns) * std::size_t(own.rows));
    const double side = std::ldexp(1.0, level);
    const double beyondTexel = side * side - std::pow(side, -6.0); // as beyondTexel() of pixels
    std::vector<double> variances(inside.channels.size());
    tbb::parallel_for(std::size_t(0), inside.channels.size(), [&](std::size_t c) {
      HalfSpectrum spectrum{own.columns, own.rows, {}};
      spectrum.values.resize(std::size_t(spectrum.columns()) * std::size_t(own.rows));
      const double texels = double(own.columns) * double(own.rows);
      for (int v = -(own.rows / 2) + 1; v < own.rows / 2; ++v)
        for (int u = 0; u < own.columns / 2; ++u) {
          const Complex coefficient(inside.at(c, u, v));
          if (coefficient == 0.0)
            continue;
          const double x = double(u) / structure.columns, y = double(v) / structure.rows;
          const double retained = retainedAt(beyondTexel * (x * x + y * y));
          // Pixels of the exemplar and texels of this image have their centres at other places.
          const HalfSpectrum& source = inside.channels[c];
          const double turns = 0.5 * (u * (1.0 / own.columns - 1.0 / source.width) +
                                      v * (1.0 / own.rows - 1.0 / source.height));
          const Complex value = retained * coefficient * meanWave(offsets, u, v) *
                                std::polar(1.0, 2.0 * std::numbers::pi * turns);
          variances[c] += (u == 0 ? 1.0 : 2.0) * std::norm(value);
          const double response =
              splineAmplitude(double(u) / own.columns) * splineAmplitude(double(v) / own.rows);
          spectrum.at(u, (v + own.rows) % own.rows) =
              std::complex<float>(value * (texels / response));
        }
      const std::vector<float> plane = inverseFft(spectrum);
      for (std::size_t i = 0; i < plane.size(); ++i)
        own.texels[i][c] = plane[i];
    });
    double sum = 0.0;
    for (const double variance : variances)
      sum += variance;
    const double channels = std::max(1.0, double(inside.channels.size()));
    image.deviations.push_back(std::min(1.0, std::sqrt(sum / channels)));
    image.levels.push_back(std::move(own));
  }
  return image;
}

} // namespace lichen::local_random_phase
