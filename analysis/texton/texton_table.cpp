// SPDX-License-Identifier: MIT
// Coefficients (channels, height, width) -> frames of texels (height, width, channels) with mips.
//
// A mip's texel is the average of the texels below it. So the noise at level l is the noise of
// level 0, averaged over squares of 2^l texels and interpolated bilinearly. A frame has room for
// the interpolation at that level, so a texton never leaves its frame. Source: [GLM17] section 5.
#include "texton_table.h"

#include "coefficients.h"
#include "exemplar/value_encoding.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace lichen::texton {
namespace {

/// The texels of one channel, row by row; zero outside.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  [[nodiscard]] float at(int x, int y) const {
    const bool isInside = x >= 0 && y >= 0 && x < width && y < height;
    return isInside ? values[std::size_t(y) * std::size_t(width) + std::size_t(x)] : 0.0f;
  }
};

/// Returns averages of 2 x 2 texels; texels outside count as 0.
Plane halved(const Plane& plane) {
  Plane half{(plane.width + 1) / 2, (plane.height + 1) / 2, {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      half.values.push_back(0.25f * (plane.at(2 * x, 2 * y) + plane.at(2 * x + 1, 2 * y) +
                                     plane.at(2 * x, 2 * y + 1) + plane.at(2 * x + 1, 2 * y + 1)));
  return half;
}

/// Returns the variance of one channel's noise whose texels are `side` texels of level 0 wide.
double variance(const Plane& plane, int order, double side) {
  const TextonCoefficients alone{plane.width, plane.height, 1, plane.values};
  return side * side * noiseCovariance(alone, order)(0, 0);
}

TexelFormat formatOf(std::size_t channels, int bits) {
  if (bits == 32)
    return channels == 1 ? TexelFormat::r32Sfloat : TexelFormat::rgba32Sfloat;
  constexpr std::array<TexelFormat, 3> kHalf = {TexelFormat::r16Sfloat, TexelFormat::rg16Sfloat,
                                                TexelFormat::rgba16Sfloat};
  return kHalf[channels - 1];
}

/// Returns the frames of one channel, one above the other.
Plane stacked(std::span<const TextonCoefficients* const> steps, const TextonShape& shape,
              std::size_t channel, double scale) {
  Plane plane{int(shape.frameWidth()), int(shape.frameHeight()) * shape.steps, {}};
  plane.values.resize(std::size_t(plane.width) * std::size_t(plane.height));
  for (std::size_t step = 0; step < steps.size() && scale > 0.0; ++step)
    for (int y = 0; y < shape.coefficientsY; ++y)
      for (int x = 0; x < shape.coefficientsX; ++x) {
        const std::size_t row = step * shape.frameHeight() + std::size_t(y);
        const std::size_t from = (channel * std::size_t(shape.coefficientsY) + std::size_t(y)) *
                                     std::size_t(shape.coefficientsX) +
                                 std::size_t(x);
        plane.values[row * std::size_t(plane.width) + std::size_t(x)] =
            float(double(steps[step]->values[from]) / scale);
      }
  return plane;
}

/// Returns the lost variance at each level of averaging, for one channel of one step.
std::vector<double> lostShares(std::vector<Plane> mips, int order) {
  std::vector<double> lost(kMaxTextonLosses, 0.0);
  const double whole = variance(mips[0], order, 1.0);
  double side = 1.0;
  for (std::size_t level = 1; level < lost.size() && whole > 0.0; ++level) {
    side *= 2.0;
    if (level == mips.size())
      mips.push_back(halved(mips.back()));
    // Minified textons are interpolated bilinearly, whatever the order. For small textons, rounding
    // could make the losses decrease.
    const double kept = variance(mips[level], 1, side) / whole;
    lost[level] = std::clamp(1.0 - kept, lost[level - 1], 1.0);
  }
  return lost;
}

/// Returns one channel of one step at each of the table's levels.
std::vector<Plane> mipsOf(const Table& table, std::span<const std::vector<float>> levels,
                          const TextonShape& shape, int step, std::size_t channel) {
  const auto stride = std::size_t(channelCount(table.format));
  std::vector<Plane> mips;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    Plane mip{int(table.width >> level), int(shape.frameHeight() >> level), {}};
    const std::size_t texels = std::size_t(mip.width) * std::size_t(mip.height);
    for (std::size_t i = 0; i < texels; ++i)
      mip.values.push_back(levels[level][(std::size_t(step) * texels + i) * stride + channel]);
    mips.push_back(std::move(mip));
  }
  return mips;
}

} // namespace

Table textonTable(std::span<const TextonCoefficients* const> steps, const TextonShape& shape,
                  std::size_t firstChannel, std::span<const double> scale, int bits) {
  assert(int(steps.size()) == shape.steps);
  const std::size_t channels = scale.size();
  Table table;
  table.format = formatOf(channels, bits);
  table.width = shape.frameWidth();
  table.height = shape.frameHeight() * std::uint32_t(shape.steps);
  table.mipLevels = std::uint32_t(shape.mipLevels);
  std::vector<Plane> planes;
  for (std::size_t c = 0; c < channels; ++c)
    planes.push_back(stacked(steps, shape, firstChannel + c, scale[c]));
  const auto stride = std::size_t(channelCount(table.format));
  for (int level = 0; level < shape.mipLevels; ++level) {
    std::vector<float> texels(planes[0].values.size() * stride, 0.0f);
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t i = 0; i < planes[c].values.size(); ++i)
        texels[i * stride + c] = planes[c].values[i];
      planes[c] = halved(planes[c]);
    }
    appendTexels(table.texels, table.format, texels);
  }
  return table;
}

TextonCoefficients storedTexton(const Noise& noise, std::span<const NoiseMap> maps,
                                std::span<const Table> tables, int step) {
  const TextonShape& shape = noise.as<TextonShape>();
  TextonCoefficients texton{shape.coefficientsX, shape.coefficientsY, 0, {}};
  for (const NoiseMap& map : maps) {
    const Table& table = tables[map.as<TextonMap>().image];
    const std::vector<float> texels = decodeLevel(table, 0);
    const auto stride = std::size_t(channelCount(table.format));
    for (std::size_t c = 0; c < map.channels.size(); ++c, ++texton.channels)
      for (int y = 0; y < texton.height; ++y)
        for (int x = 0; x < texton.width; ++x) {
          const std::size_t row = std::size_t(step) * shape.frameHeight() + std::size_t(y);
          const float texel = texels[(row * table.width + std::size_t(x)) * stride + c];
          texton.values.push_back(float(map.as<TextonMap>().scale[c] * double(texel)));
        }
  }
  return texton;
}

std::vector<std::vector<double>> mipLosses(const Table& table, const TextonShape& shape,
                                           std::size_t channels) {
  std::vector<std::vector<float>> levels;
  for (std::uint32_t level = 0; level < table.mipLevels; ++level)
    levels.push_back(decodeLevel(table, level));
  std::vector<std::vector<double>> losses;
  for (int step = 0; step < shape.steps; ++step) {
    std::vector<double>& ofStep = losses.emplace_back();
    for (std::size_t c = 0; c < channels; ++c) {
      const std::vector<double> lost =
          lostShares(mipsOf(table, levels, shape, step, c), shape.order);
      ofStep.insert(ofStep.end(), lost.begin(), lost.end());
    }
  }
  return losses;
}

// Coefficients of each step -> statistics, scale and table of each map.
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The stored value is the mean plus six standard deviations per unit, as in other Gaussian values
/// that are decoded without a table.
constexpr double kScaleDeviations = 6.0;

/// Returns mean and covariance of `n` channels starting at `first`.
TextonStep statisticsOf(const Eigen::VectorXd& mean, const MatrixXd& covariance, Index first,
                        Index n) {
  TextonStep statistics;
  for (Index c = first; c < first + n; ++c) {
    statistics.mean.push_back(mean[c]);
    for (Index d = first; d < first + n; ++d)
      statistics.covariance.push_back(covariance(c, d));
  }
  return statistics;
}

/// Returns six times the largest standard deviation of each of these channels.
std::vector<double> scaleOf(std::span<const MatrixXd> covariances, Index first, Index n) {
  std::vector<double> scale;
  for (Index c = first; c < first + n; ++c) {
    double variance = 0.0;
    for (const MatrixXd& covariance : covariances)
      variance = std::max(variance, covariance(c, c));
    scale.push_back(kScaleDeviations * std::sqrt(variance));
  }
  return scale;
}

} // namespace

TextonCoefficients inStoredUnits(TextonCoefficients coefficients, const Eigen::VectorXd& units) {
  const std::size_t texels = coefficients.values.size() / std::size_t(units.size());
  for (std::size_t i = 0; i < coefficients.values.size(); ++i)
    coefficients.values[i] *= float(units[Index(i / texels)]);
  return coefficients;
}

void storeMaps(std::span<const TextonOfMaps> steps, std::span<const MapExemplar> maps, int bits,
               Noise& noise, std::vector<Table>& tables) {
  const auto& shape = noise.as<TextonShape>();
  std::vector<MatrixXd> covariances;
  std::vector<const TextonCoefficients*> coefficients;
  for (const TextonOfMaps& step : steps) {
    covariances.push_back(noiseCovariance(step.coefficients, shape.order));
    coefficients.push_back(&step.coefficients);
  }
  Index first = 0;
  for (const MapExemplar& source : maps) {
    const auto n = Index(source.channels.size());
    NoiseMap map;
    map.target = source.target;
    map.channels = source.channels;
    map.encoding = exemplar::storedEncoding(source.encoding);
    TextonMap texton;
    texton.scale = scaleOf(covariances, first, n);
    Table table =
        textonTable(coefficients, shape, std::size_t(first), texton.scale, bits == 16 ? 32 : 16);
    table.name = noise.name + "." + std::string(nameOf(map.target)) + ".texton";
    const std::vector<std::vector<double>> losses = mipLosses(table, shape, std::size_t(n));
    for (std::size_t k = 0; k < steps.size(); ++k) {
      TextonStep step = statisticsOf(steps[k].mean, covariances[k], first, n);
      step.mipLoss = losses[k];
      if (k > 0) {
        texton.laterSteps.push_back(std::move(step));
        continue;
      }
      map.mean = std::move(step.mean);
      map.covariance = std::move(step.covariance);
      texton.mipLoss = std::move(step.mipLoss);
    }
    texton.image = tables.size();
    map.data = std::move(texton);
    tables.push_back(std::move(table));
    noise.maps.push_back(std::move(map));
    first += n;
  }
}

} // namespace lichen::texton
