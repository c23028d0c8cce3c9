// SPDX-License-Identifier: MIT
// The data of a tiling noise [HN18]: tiling and blending.
#pragma once

#include <cstddef>
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
/// The Gaussian image has D = 1, 2 or 3 colour channels (R8/R16F/R32F, RG.., RGBA.. with alpha
/// unused), where D is the dimension of the affine space that the exemplar's values span: a grey
/// photograph stored as RGB has D = 1 and three channels. The inverse table maps [0, 1]^D to the
/// channels, as L slabs: D = 1: 2-D, 256 x L; D = 2: 2-D, 64 x 64 L; D = 3: 3-D, 32 x 32 x 32 L.
/// Slab k is prefiltered for the lost variance levels[k] = 1 - (1 - k / (L - 1))^2, as a share of
/// the full variance. The kept amplitude therefore falls linearly from slab 0 (no loss) to slab L -
/// 1 (constant).
struct TilingMap {
  std::size_t gaussian = 0;                ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< absent if the exemplar is already Gaussian
  std::vector<double> levels;              ///< L >= 2 values from 0 to 1; empty without a table
  /// The lost variance of each mip level of the Gaussian image, as a share of the full variance,
  /// averaged over the channels. Values are in [0, 1], start at 0 and never decrease.
  std::vector<double> mipLoss;

  /// Calls visit(index) for each table index.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.gaussian);
    if (self.inverseTable)
      visit(*self.inverseTable);
  }

  [[nodiscard]] bool operator==(const TilingMap&) const = default;
};

/// How Gaussian values are decoded: by one table over all dimensions, or by the affine map from the
/// mean and covariance.
enum class TableKind { joint, none };
[[nodiscard]] TableKind tableKindOf(const TilingMap& map);
/// "joint" or "none".
[[nodiscard]] std::string_view nameOf(TableKind kind);

} // namespace lichen
