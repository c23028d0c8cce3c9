// SPDX-License-Identifier: MIT
// A second, slow and simple evaluation of tiling revision 1 in double precision, written from the
// format's specification: the oracle for the shader library. It shares only the integer hash with
// the code under test; other tests check that hash.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <lichen_interface.h>
#include <vector>

namespace lichen::test {

/// A texture coordinate and its gradients along the screen axes.
struct Point {
  std::array<float, 2> uv{};
  std::array<float, 2> gradientX{};
  std::array<float, 2> gradientY{};
  std::array<float, 2> unused{};
};

/// A mip level or a table, as floats.
struct Volume {
  int width = 1, height = 1, depth = 1;
  std::size_t channels = 4;
  std::vector<float> values;
};

/// How the Gaussian image is fetched.
enum class FetchedBy {
  level,     ///< at the level of detail of step 4, trilinearly
  gradients, ///< with the footprint's gradients; exact for a sampler of anisotropy 1, and for
             ///< others the lost variance is
};

/// One map of a bundle's first noise, decoded.
class TilingReference {
public:
  explicit TilingReference(const Bundle& bundle, std::size_t map = 0,
                           FetchedBy fetchedBy = FetchedBy::level);

  /// The map's value, and the blended Gaussian value with the lost variance as its last component.
  struct Sample {
    std::array<double, 4> value{};
    std::array<double, 4> gaussian{};
    double loss = 0.0; ///< of a fetch, on average between texels
    double here = 1.0; ///< of one at the point, over that
  };
  [[nodiscard]] Sample evaluate(const Point& point, const shader::LichenMaterial& material) const;

  using Decoded = std::array<double, 4>;
  /// Step 6: the value of a Gaussian value. `loss` and `here`: as in Sample.
  [[nodiscard]] Decoded decoded(const Decoded& gaussian, double loss, double here,
                                double contrast) const;

private:
  [[nodiscard]] Decoded fromTable(const Decoded& gaussian, double lost) const;
  [[nodiscard]] Decoded withoutTable(const Decoded& gaussian, double lost) const;

  std::vector<Volume> levels_;
  std::vector<Volume> table_; ///< by mip level; empty without one
  const shader::LichenNoise noise_;
  const shader::LichenMap shaderMap_;
  const NoiseMap map_;
  const FetchedBy fetchedBy_;
};

} // namespace lichen::test
