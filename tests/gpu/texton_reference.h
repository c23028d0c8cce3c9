// SPDX-License-Identifier: MIT
// A second, slow and simple evaluation of texton noise in double precision: the oracle for the
// shader and its CPU twin. It lists all impacts of a periodic domain with all their copies around
// it, and sums their textons over all coefficients. It uses neither a window of cells nor a border
// of zeros. It shares only the integer hash with the code under test; other tests check that hash.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <lichen_interface.h>
#include <vector>

namespace lichen::test {

/// The centred B-spline of an order by the Cox-de Boor recursion, on half-open intervals.
[[nodiscard]] double centredSpline(int order, double x);
/// Inverts the distribution function of a Poisson variable of mean 1 at a quantile.
[[nodiscard]] int poissonQuantile(double quantile);

/// The standard deviation of a channel's stored values at a mix weight: linear between the steps.
[[nodiscard]] double deviationAt(const NoiseMap& map, double weight, std::size_t channel);

class TextonReference {
public:
  /// Of the bundle's first noise. `material` must be periodic.
  TextonReference(const Bundle& bundle, const shader::LichenMaterial& material);

  struct Impact {
    double x = 0.0, y = 0.0; ///< texels of the exemplar
    double sign = 1.0;
  };
  /// The impacts of one period.
  [[nodiscard]] const std::vector<Impact>& impacts() const { return impacts_; }

  /// The sum over all impacts at a position [tiles], in stored values minus their mean, with the
  /// texton fetched at a whole mip level (0: its own spline). The derivatives of the first channel
  /// [1 / tile] follow.
  struct Sum {
    std::array<double, 3> value{};
    std::array<double, 2> gradient{};
  };
  [[nodiscard]] Sum at(double tileX, double tileY, std::uint32_t mip, double mixWeight = 0.0,
                       std::array<double, 2> mixGradient = {}) const;

private:
  const Bundle& bundle_;
  const shader::LichenMaterial material_;
  const shader::LichenTextonMaterial part_;
  const shader::LichenNoise noise_;
  const shader::LichenTextonNoise texton_;
  std::vector<Impact> impacts_;
  std::vector<std::vector<float>> mips_;
};

} // namespace lichen::test
