// SPDX-License-Identifier: MIT
// Coefficients of each step -> statistics, scale and table of each map; see texton_maps.h.
#include "texton_maps.h"

#include "color_correction.h"
#include "exemplar/value_encoding.h"
#include "texton_table.h"

#include <algorithm>
#include <cmath>

namespace lichen::texton {
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
