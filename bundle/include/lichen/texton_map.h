// SPDX-License-Identifier: MIT
// The data of a texton noise [GLM17]: sparse convolution of a texton.
#pragma once

#include <lichen/table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lichen {

/// The properties that the textons of all maps of a noise share.
///
/// The coefficients fill the top left part of a frame of frameWidth() x frameHeight() texels; the
/// rest is zero. Because the image repeats, this leaves a margin of half a texel of the last mip
/// level on all sides. An image stacks `steps` frames vertically and is at most kMaxTableSide high.
struct TextonShape {
  int coefficientsX = 0;  ///< [1, kMaxTextonSide], at most the exemplar's texels
  int coefficientsY = 0;  ///< [1, kMaxTextonSide], at most the exemplar's texels
  int order = 1;          ///< degree of the interpolating B-spline: 0, 1 or 3
  int mipLevels = 1;      ///< of the images, [1, mostMipLevels()]
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int steps = 1;          ///< textons of a mix, from its first exemplar to the last; 1 if not a mix

  /// The largest number of mip levels whose last level has at least four texels, each 2^(mipLevels
  /// - 1) coefficients wide, inside the texton. Coarser texels would reach far beyond the texton,
  /// and a pixel would pay for impacts that hardly contribute.
  [[nodiscard]] int mostMipLevels() const;

  /// Frame size in texels: the coefficients rounded up to whole texels of the last mip level, plus
  /// one of those texels.
  [[nodiscard]] std::uint32_t frameWidth() const;
  [[nodiscard]] std::uint32_t frameHeight() const;

  [[nodiscard]] bool operator==(const TextonShape&) const = default;
};
inline constexpr int kMaxTextonSide = 1024;
inline constexpr int kMaxTextonMips = 9; ///< mostMipLevels() of the largest texton
inline constexpr int kMaxTextonSteps = 64;

/// Maximum number of averaging levels for which a texton's channel states its lost variance.
inline constexpr std::size_t kMaxTextonLosses = 16;

/// Row `row` of a TextonMap::mipLoss that has `rows` rows. Precondition: `row` < `rows`.
[[nodiscard]] std::span<const double> lossRow(std::span<const double> mipLoss, std::size_t row,
                                              std::size_t rows);

/// A step of a mix after the first. The members mean the same as the map's, which describe the
/// first step.
struct TextonStep {
  std::vector<double> mean;
  std::vector<double> covariance;
  std::vector<double> mipLoss;

  [[nodiscard]] bool operator==(const TextonStep&) const = default;
};

/// A map's texton. The stored value is NoiseMap::mean + scale x the sum over impacts. In a mix,
/// mean, covariance and mipLoss describe the first step.
struct TextonMap {
  /// Index into Bundle::tables of an image in a float format, with at least one colour channel per
  /// map channel. TextonShape specifies the layout of the coefficients.
  std::size_t image = 0;
  /// A factor >= 0 per channel: six times its standard deviation, in a mix the largest of all
  /// steps.
  std::vector<double> scale;
  /// The lost variance at each level of averaging, as a share of the full variance. One row per
  /// channel, one value per level, with TextonShape::mipLevels to kMaxTextonLosses levels. Values
  /// are in [0, 1], start at 0 and never decrease. Levels beyond the image's mip levels are box
  /// averages.
  std::vector<double> mipLoss;
  std::vector<TextonStep> laterSteps; ///< TextonShape::steps - 1 elements

  /// As in TilingMap.
  [[nodiscard]] std::size_t imageTable() const { return image; }
  [[nodiscard]] static std::optional<std::size_t> decodingTable() { return std::nullopt; }

  /// Calls visit(index) for each table index.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.image);
  }

  [[nodiscard]] bool operator==(const TextonMap&) const = default;
};

} // namespace lichen
