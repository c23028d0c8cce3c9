// SPDX-License-Identifier: MIT
// A second, slow and simple evaluation of texton noise on a surface in double precision: the oracle
// for the shader and its CPU twin. It visits every cube of a large box around the point and sums
// the textons of all impacts over all coefficients. It shares only the integer hash with the code
// under test.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <lichen_interface.h>
#include <vector>

namespace lichen::test {

class SurfaceReference {
public:
  using Vec = std::array<double, 3>;

  SurfaceReference(const Bundle& bundle, const shader::LichenMaterial& material);

  /// Returns the sum over impacts, in stored values minus their mean, with the texton fetched at a
  /// whole mip level (0: its own spline). `right`, `down` and `outward` are orthonormal: the
  /// directions of the exemplar's x and y on the surface, and the normal. `point` is in metres.
  [[nodiscard]] Vec at(const Vec& point, const Vec& right, const Vec& down, const Vec& outward,
                       std::uint32_t mip, double mixWeight = 0.0,
                       std::array<double, 2> mixGradient = {}) const;

private:
  /// Value h of one step of the texton, at (x, y) in texels of its frame.
  [[nodiscard]] Vec textonAt(double x, double y, std::uint32_t mip, int step) const;

  const Bundle& bundle_;
  const shader::LichenMaterial material_;
  const shader::LichenTextonMaterial part_;
  const shader::LichenNoise noise_;
  const shader::LichenTextonNoise texton_;
  std::vector<std::vector<float>> mips_;
};

} // namespace lichen::test
