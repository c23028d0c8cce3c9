// SPDX-License-Identifier: MIT
// A second, slow and obvious evaluation of texton noise in double precision: the oracle for shader
// and twin. It lists all impacts of a periodic domain, with all their copies around it, and sums
// their textons over all coefficients; it knows no window of cells and no frame of zeros, and takes
// only the integer hash from the rest, which is checked on its own.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <lichen_interface.h>
#include <vector>

namespace lichen::test {

/// The centred B-spline of an order: Cox and de Boor's recursion, half-open.
[[nodiscard]] double centredSpline(int order, double x);
/// A Poisson variable of mean 1 by its distribution function, at a quantile.
[[nodiscard]] int poissonQuantile(double quantile);

/// The deviation of a channel's stored values at a weight of a mix: linear between the steps.
[[nodiscard]] double deviationAt(const NoiseMap& map, double weight, std::size_t channel);

class TextonReference {
public:
  /// `noise` is periodic.
  TextonReference(const Bundle& bundle, const shader::LichenNoise& noise,
                  const shader::LichenTexton& texton);

  struct Impact {
    double x = 0.0, y = 0.0; ///< texels of the exemplar
    double sign = 1.0;
  };
  /// Those of one period.
  [[nodiscard]] const std::vector<Impact>& impacts() const { return impacts_; }

  /// The sum over all impacts in stored values less their mean at a place [tiles], of the texton
  /// fetched at a whole mip level (0: its own spline), the first channel's derivatives [1 / tile]
  /// after it.
  struct Sum {
    std::array<double, 3> value{};
    std::array<double, 2> gradient{};
  };
  [[nodiscard]] Sum at(double tileX, double tileY, std::uint32_t mip, double mixWeight = 0.0,
                       std::array<double, 2> mixGradient = {}) const;

private:
  const Bundle& bundle_;
  const shader::LichenNoise noise_;
  const shader::LichenTexton texton_;
  std::vector<Impact> impacts_;
  std::vector<std::vector<float>> mips_;
};

} // namespace lichen::test
