// SPDX-License-Identifier: MIT
// The data of a tiling noise [HN18]: tiling and blending.
#pragma once

#include <lichen/gaussian_image.h>
#include <lichen/inverse_table.h>
#include <lichen/lattice.h>
#include <lichen/table.h>

#include <cstddef>
#include <optional>
#include <string_view>

namespace lichen {

/// What all maps of a tiling noise share.
struct TilingNoise {
  /// Stretches the lattice. Materials that rotate tiles ignore it, since the streaks of rotated
  /// tiles run along any direction.
  Grain grain = Grain::none;

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

  /// The image that the shader fetches, and the table that decodes its Gaussian values.
  [[nodiscard]] std::size_t imageTable() const { return gaussian; }
  [[nodiscard]] std::optional<std::size_t> decodingTable() const { return inverseTable; }

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
