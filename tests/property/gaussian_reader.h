// SPDX-License-Identifier: MIT
// The Gaussian value of a noise and what filtering lost of it, read from decoded values.
#pragma once

#include <lichen/noise_evaluator.h>

#include <Eigen/Dense>

#include <memory>

namespace lichen::test {

/// What was read in each channel; 0 in channels that the map does not have.
struct GaussianReading {
  Eigen::Vector3d z{0.0, 0.0, 0.0};    ///< deviations from the mean, times the contrast
  Eigen::Vector3d lost{0.0, 0.0, 0.0}; ///< share of the variance, times the squared contrast
};

/// Reads the first map of noise 0, of every method but quilting. Two maps decode to (1 + z)^2 + s
/// and (1 - z)^2 + s, as the format has it for the encoding root: exact but for rounding.
class GaussianReader {
public:
  explicit GaussianReader(Bundle bundle, const MaterialNoise& material,
                          const Placement& placement = {}) {
    std::vector<NoiseMap>& maps = bundle.noises[0].maps;
    maps = {squared(maps[0], 1.0), squared(maps[0], -1.0)};
    channels_ = Eigen::Index(maps[0].channels.size());
    evaluator_ = NoiseEvaluator::create(bundle, material, placement).value();
  }

  template <class Footprint>
  [[nodiscard]] GaussianReading at(const Footprint& footprint, const MixPlace& mix = {}) const {
    const auto above = evaluator_->evaluate(0, footprint, mix);
    const auto below = evaluator_->evaluate(1, footprint, mix);
    GaussianReading reading;
    for (Eigen::Index c = 0; c < channels_; ++c) {
      const double plus = double(above[std::size_t(c)]), minus = double(below[std::size_t(c)]);
      reading.z[c] = (plus - minus) / 4.0;
      reading.lost[c] = (plus + minus) / 2.0 - 1.0 - reading.z[c] * reading.z[c];
    }
    return reading;
  }

private:
  /// `map` with the deviation 1, without an inverse table.
  static NoiseMap squared(NoiseMap map, double mean) {
    const std::size_t n = map.channels.size();
    map.encoding = ValueEncoding::root;
    map.mean.assign(n, mean);
    map.covariance.assign(n * n, 0.0);
    for (std::size_t c = 0; c < n; ++c)
      map.covariance[c * (n + 1)] = 1.0;
    if (auto* const tiling = std::get_if<TilingMap>(&map.data))
      tiling->inverseTable.reset();
    if (auto* const cosines = std::get_if<LocalRandomPhaseMap>(&map.data))
      cosines->inverseTable.reset();
    if (auto* const kernels = std::get_if<MultipleKernelsMap>(&map.data))
      kernels->inverseTable.reset();
    if (auto* const textons = std::get_if<TextonMap>(&map.data)) {
      textons->scale.assign(n, 6.0);
      for (TextonStep& step : textons->laterSteps) {
        step.mean = map.mean;
        step.covariance = map.covariance;
      }
    }
    return map;
  }

  std::unique_ptr<const NoiseEvaluator> evaluator_;
  Eigen::Index channels_ = 0;
};

} // namespace lichen::test
