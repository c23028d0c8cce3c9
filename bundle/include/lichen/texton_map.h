// SPDX-License-Identifier: MIT
// What a bundle holds of a noise by sparse convolution of textons [GLM17].
#pragma once

#include <lichen/table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen {

/// What the textons of all maps of a noise have in common.
///
/// Their coefficients are the top left part of a frame of frameWidth() x frameHeight() texels,
/// which is zero elsewhere: half a texel of the last mip on all sides, as the image repeats. An
/// image is `steps` frames, one above the other, together at most kMaxTableSide high.
struct TextonShape {
  int coefficientsX = 0;  ///< [1, kMaxTextonSide], at most the exemplar's texels
  int coefficientsY = 0;  ///< likewise
  int order = 1;          ///< of the B-spline between coefficients: 0, 1 or 3
  int mipLevels = 1;      ///< of the images, [1, mostMipLevels()]
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< likewise
  int steps = 1;          ///< of a mix, textons from its first exemplar to the last; otherwise 1

  /// As many as keep four texels of the last mip, 2^(mipLevels - 1) coefficients wide, inside the
  /// texton: wider ones would reach far beyond it and make a pixel pay for impacts that it hardly
  /// sees.
  [[nodiscard]] int mostMipLevels() const;

  /// Texels of a frame: whole texels of the last mip, and one more.
  [[nodiscard]] std::uint32_t frameWidth() const;
  [[nodiscard]] std::uint32_t frameHeight() const;

  [[nodiscard]] bool operator==(const TextonShape&) const = default;
};
inline constexpr int kMaxTextonSide = 1024;
inline constexpr int kMaxTextonMips = 9; ///< mostMipLevels() of the largest texton
inline constexpr int kMaxTextonSteps = 64;

/// Levels of averaging for which the losses of a texton's channel are known.
inline constexpr std::size_t kMaxTextonLosses = 16;

/// One row of a TextonMap::mipLoss, which has `rows` of them; `row` < `rows`.
[[nodiscard]] std::span<const double> lossRow(std::span<const double> mipLoss, std::size_t row,
                                              std::size_t rows);

/// One later step of a mix; its members mean the same as those of the map for the first step.
struct TextonStep {
  std::vector<double> mean;
  std::vector<double> covariance;
  std::vector<double> mipLoss;

  [[nodiscard]] bool operator==(const TextonStep&) const = default;
};

/// A map's texton. The stored value is NoiseMap::mean + scale x the sum over impacts. In a mix,
/// mean, covariance and mipLoss are those of its first step.
struct TextonMap {
  /// Index into Bundle::tables: an image of a float format with a colour channel for each of the
  /// map's. TextonShape says where its coefficients lie.
  std::size_t image = 0;
  /// A factor >= 0 for each channel: six times its standard deviation, in a mix the largest of all
  /// steps.
  std::vector<double> scale;
  /// One row a channel, one value a level of averaging, TextonShape::mipLevels to kMaxTextonLosses
  /// of them: the share of the variance that is lost there, in [0, 1], 0 first, never decreasing.
  /// Values beyond the image's mips are those of box averages.
  std::vector<double> mipLoss;
  std::vector<TextonStep> laterSteps; ///< TextonShape::steps - 1

  /// Calls visit(index) for each index of a table.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.image);
  }

  [[nodiscard]] bool operator==(const TextonMap&) const = default;
};

} // namespace lichen
