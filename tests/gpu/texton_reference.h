// SPDX-License-Identifier: MIT
// A second, slow and simple evaluation of texton noise in double precision: the oracle for the
// shader library. In the plane it lists all impacts of a periodic domain with all their copies
// around it; on a surface, all impacts in a large box around the point. It sums their textons over
// all coefficients, and uses neither a window of cells nor a border of zeros. It shares only the
// integer hash with the code under test; other tests check that hash.
#pragma once

#include "device_noise.h"

namespace lichen::test {

/// The first map of a bundle's first noise, as one material uses it.
class TextonReference {
public:
  TextonReference(const Bundle& bundle, const shader::LichenMaterial& material);

  /// The sum over all impacts at a position [tiles] of the plane, in stored values minus their
  /// mean. Textons are fetched at a whole mip level; 0 is their own spline. The material must be
  /// periodic.
  [[nodiscard]] Vec inPlane(double tileX, double tileY, std::uint32_t mip,
                            const MixPlace& mix = {}) const;
  /// The same at a point [metres] of a surface.
  [[nodiscard]] Vec onSurface(const Vec& point, const SurfaceFrame& frame, std::uint32_t mip,
                              const MixPlace& mix) const;

  /// The Gaussian value of a sum, by the standard deviation at a mix weight: linear between steps.
  [[nodiscard]] double gaussian(const Vec& sum, double mixWeight, std::size_t channel) const;

private:
  /// Adds the texton of the impact that is (x, y) [texels] from the point.
  void addTexton(Vec& sum, double x, double y, std::uint32_t mip, const MixPlace& mix,
                 double factor) const;
  /// One word for each impact of a cell.
  [[nodiscard]] std::vector<std::uint32_t> wordsOf(std::uint32_t word, std::uint32_t count) const;

  struct Impact {
    double x = 0.0, y = 0.0; ///< texels of the exemplar
    double sign = 1.0;
  };

  const NoiseMap map_;
  const TextonMap textonMap_;
  const Table image_;
  const shader::LichenMaterial material_;
  const shader::LichenTextonMaterial part_;
  const shader::LichenNoise noise_;
  const shader::LichenTextonNoise texton_;
  std::vector<Impact> impacts_; ///< of one period
  std::vector<std::vector<float>> mips_;
};

} // namespace lichen::test
