// SPDX-License-Identifier: MIT
// A second, slow and obvious evaluation of texton noise on a surface in double precision: the
// oracle for shader and twin. It looks at every cube of a large box around the point and sums the
// textons of all impacts over all coefficients; it takes only the integer hash from the rest.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <lichen_interface.h>
#include <vector>

namespace lichen::test {

class SurfaceReference {
public:
  using Vec = std::array<double, 3>;

  SurfaceReference(const Bundle& bundle, const shader::LichenNoise& noise,
                   const shader::LichenTexton& texton);

  /// The sum over impacts in stored values less their mean, with the texton fetched at a whole mip
  /// level (0: its own spline). `right`, `down` and `outward` are orthonormal: where the exemplar's
  /// x and y point on the surface, and the normal. The point is in metres.
  [[nodiscard]] Vec at(const Vec& point, const Vec& right, const Vec& down, const Vec& outward,
                       std::uint32_t mip, double mixWeight = 0.0,
                       std::array<double, 2> mixGradient = {}) const;

private:
  /// h of a step of the texton, in texels of its frame.
  [[nodiscard]] Vec textonAt(double x, double y, std::uint32_t mip, int step) const;

  const Bundle& bundle_;
  const shader::LichenNoise noise_;
  const shader::LichenTexton texton_;
  std::vector<std::vector<float>> mips_;
};

} // namespace lichen::test
