// SPDX-License-Identifier: MIT
// What a bundle holds of a noise by tiling and blending [HN18].
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace lichen {

/// The maps of a tiling noise have nothing in common but what every noise has.
struct TilingNoise {
  [[nodiscard]] bool operator==(const TilingNoise&) const = default;
};

/// A map's Gaussian image and inverse table.
///
/// The Gaussian image has D = 1, 2 or 3 colour channels (R8/R16F/R32F, RG.., RGBA.. with alpha
/// unused), where D is the dimension of the affine space that the exemplar's values span: a grey
/// photograph stored as RGB has D = 1 and three channels. The inverse table maps [0, 1]^D to the
/// channels, as L slabs: D = 1: 2-D, 256 x L; D = 2: 2-D, 64 x 64 L; D = 3: 3-D, 32 x 32 x 32 L.
/// Slab k is prefiltered for the lost variance levels[k] = 1 - (1 - k / (L - 1))^2, in units of the
/// full variance: the amplitude that is left falls linearly from slab 0 (nothing lost) to slab
/// L - 1 (constant).
struct TilingMap {
  std::size_t gaussian = 0;                ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< absent for an exemplar that is Gaussian already
  std::vector<double> levels;              ///< L >= 2 values from 0 to 1; empty without a table
  /// For a separable table: decoded = tableOffset + tableBasis t, t one value an axis; n x D
  /// values, row-major, and n, the number of the map's channels. Empty for a joint table or none.
  std::vector<double> tableBasis;
  std::vector<double> tableOffset;
  /// The share of the variance that each mip level of the Gaussian image has lost, averaged over
  /// its channels; in [0, 1], 0 first, never decreasing.
  std::vector<double> mipLoss;

  /// Calls visit(index) for each index of a table.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.gaussian);
    if (self.inverseTable)
      visit(*self.inverseTable);
  }

  [[nodiscard]] bool operator==(const TilingMap&) const = default;
};

/// How Gaussian values become the map's own: by one table over all dimensions, by one for each, or
/// by the affine map of its mean and covariance.
enum class TableKind { joint, separable, none };
[[nodiscard]] TableKind tableKindOf(const TilingMap& map);
/// "joint", "separable" or "none".
[[nodiscard]] std::string_view nameOf(TableKind kind);

} // namespace lichen
