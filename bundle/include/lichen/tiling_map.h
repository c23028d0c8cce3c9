// SPDX-License-Identifier: MIT
// The data of a tiling noise [HN18]: tiling and blending.
#pragma once

#include <lichen/table.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace lichen {

/// The maps of a tiling noise share nothing beyond the members of Noise.
struct TilingNoise {
  [[nodiscard]] bool operator==(const TilingNoise&) const = default;
};

/// A map's Gaussian image and inverse table.
///
/// The exemplar's values span an affine space of D = 1, 2 or 3 dimensions: a grey photograph stored
/// as RGB has D = 1 and three channels. The Gaussian image has D channels, and in its last one the
/// loss of each mip level, see fetchLosses(): RG for D = 1, otherwise RGBA, 8-bit or half floats.
/// The inverse table maps [0, 1]^D to the channels: a 3-D image whose first D sides have as many
/// cells and whose other sides have one. Mip level k is prefiltered for Gaussian values of 1 - k /
/// 5 of the full amplitude.
struct TilingMap {
  std::size_t gaussian = 0;                ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< absent if the exemplar is already Gaussian
  int dimensions = 1;                      ///< D, [1, 3]

  /// Calls visit(index) for each table index.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.gaussian);
    if (self.inverseTable)
      visit(*self.inverseTable);
  }

  [[nodiscard]] bool operator==(const TilingMap&) const = default;
};

/// Sides of an inverse table: powers of two in this range. It has at most kMostTableLevels mip
/// levels, and none of one cell.
inline constexpr std::uint32_t kLeastTableSide = 4, kMostTableSide = 256;
inline constexpr std::uint32_t kMostTableLevels = 5;

/// What a Gaussian image holds in place of the mean 1/2: a value of 8-bit texels, so that coarse
/// mip levels, which hold little else, are not rounded away from it.
inline constexpr float kStoredGaussianMean = 128.0f / 255.0f;

/// The last channel of each mip level of a Gaussian image: the share of the variance that a fetch
/// of the level loses, interpolation between texels included. In [0, 1], never decreasing.
[[nodiscard]] std::vector<float> fetchLosses(const Table& gaussian);

/// How Gaussian values are decoded: by one table over all dimensions, or by the affine map from the
/// mean and covariance.
enum class TableKind { joint, none };
[[nodiscard]] TableKind tableKindOf(const TilingMap& map);
/// "joint" or "none".
[[nodiscard]] std::string_view nameOf(TableKind kind);

} // namespace lichen
