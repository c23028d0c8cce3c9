// SPDX-License-Identifier: MIT
// (cosines, vectors, structure) -> RGBA texels: one row for two cosines, then the structure.
#include "cosine_table.h"

#include <lichen/bfloat16_pair.h>
#include <lichen/lattice.h>
#include <lichen/local_random_phase_map.h>
#include <lichen/structure_texel.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <tuple>

namespace lichen::local_random_phase {
namespace {

/// Writes the levels of a structure from the column `column` on. `largest`: per channel.
void setLevels(std::vector<float>& texels, const CosineImageLayout& layout, std::size_t column,
               const StructureImage& image, const std::array<double, 3>& largest) {
  for (std::size_t k = 0; k < image.levels.size(); ++k) {
    const StructureImage::Level& level = image.levels[k];
    const std::array<std::uint32_t, 2> corner = layout.levelCorner(int(k));
    for (int y = 0; y < level.rows; ++y)
      for (int x = 0; x < level.columns; ++x) {
        const auto& own =
            level.texels[std::size_t(y) * std::size_t(level.columns) + std::size_t(x)];
        std::array<int, 3> integers{};
        for (std::size_t c = 0; c < 3; ++c)
          if (largest[c] > 0.0)
            integers[c] = int(std::lround(kMostStructureInteger *
                                          std::clamp(double(own[c]) / largest[c], -1.0, 1.0)));
        const std::size_t texel = (corner[1] + std::size_t(y / 2)) * layout.width + corner[0] +
                                  column + std::size_t(x / 2);
        texels[4 * texel + std::size_t(2 * (y % 2) + x % 2)] = structureTexel(integers);
      }
  }
}

} // namespace

double MapStructure::largest(std::size_t channel) const {
  double result = 0.0;
  for (const StructureImage* part : {&image, &mean})
    for (const StructureImage::Level& level : part->levels)
      for (const std::array<float, 3>& texel : level.texels)
        result = std::max(result, std::abs(double(texel[channel])));
  return result;
}

std::vector<int> cosinesByOctave(const std::vector<Cosine>& cosines) {
  std::vector<int> counts;
  for (const Cosine& cosine : cosines) {
    if (counts.size() <= std::size_t(cosine.octave))
      counts.resize(std::size_t(cosine.octave) + 1, 0);
    ++counts[std::size_t(cosine.octave)];
  }
  return counts;
}

Table cosineTable(const LocalRandomPhaseNoise& shared, const std::vector<Cosine>& cosines,
                  const CosineVectors& vectors, const MapRows& rows,
                  const MapStructure& structure) {
  const CosineImageLayout layout(shared);
  Table table;
  table.format = TexelFormat::rgba32Sfloat;
  table.width = layout.width;
  table.height = layout.height;
  std::vector<float> texels(4 * std::size_t(table.width) * table.height);
  const auto set = [&](std::size_t j, std::size_t column, const CosineTexel& own) {
    const std::size_t texel = j / kRowCosines * table.width + column;
    float* pairs = &texels[4 * texel + 2 * (j % kRowCosines)];
    pairs[0] = bfloat16Pair(own[0], own[1]);
    pairs[1] = bfloat16Pair(own[2], own[3]);
  };
  for (std::size_t j = 0; j < cosines.size(); ++j) {
    const FrequencyBox& box = cosines[j].box;
    set(j, 0,
        {float(0.5 * (box.low() + box.high())), float(0.5 * (box.lowRow() + box.highRow())),
         float(box.width()), float(box.height())});
    // A vertex has one column of all its cosines, in which their signs should not agree.
    const auto first = std::size_t(pcg(std::uint32_t(j)) & std::uint32_t(vectors.variants - 1));
    for (std::size_t v = 0; v < std::size_t(vectors.variants); ++v) {
      CosineTexel variant{};
      for (std::size_t c = 0; c < rows.channels; ++c)
        variant[c] = float(vectors.vectors[j](Eigen::Index(rows.first + c), Eigen::Index(v)));
      variant[3] = float(vectors.phases[j](Eigen::Index(rows.map), Eigen::Index(v)));
      set(j, kCosineColumns + (v ^ first), variant);
    }
  }
  const std::array largest{structure.largest(0), structure.largest(1), structure.largest(2)};
  setLevels(texels, layout, 0, structure.image, largest);
  setLevels(texels, layout, layout.meanColumn, structure.mean, largest);
  float* list = texels.data() + 4 * std::size_t(layout.offsetRow) * layout.width;
  for (const std::array<double, 2>& offset : structure.offsets) {
    *list++ = float(offset[0]);
    *list++ = float(offset[1]);
  }
  appendTexels(table.texels, table.format, texels);
  return table;
}

// Spectrum -> the frequencies with fixed phases -> B-spline coefficients of their sum.
//
// [LRP14] section 4.2 and 5: "the structure". Its images are stored, where the paper reduces them
// to blocks of cosines, which hold more numbers: docs/decisions/009-local-random-phase.md.
namespace {

/// The amplitude that a footprint leaves of a cosine, for the square of the cycles that it spans,
/// as lichenCosineRetained (shaders_glsl/noise/wave.glsl) has it.
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
