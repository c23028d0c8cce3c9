// SPDX-License-Identifier: MIT
// The data of a quilting noise: tiles of the exemplar that are cut along the outlines of its cells,
// such as bricks, stones or threads. docs/decisions/012-quilting.md.
#pragma once

#include <lichen/lattice.h>
#include <lichen/table.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace lichen {

inline constexpr std::size_t kMostQuiltingOffsets = 24;
/// The largest texel of an image in magnitude, and with the encoding log2.
inline constexpr float kMostQuiltingTexel = 65504.0f, kMostQuiltingLog2 = 16.0f;
/// The largest distance from a texel to the centre of its cell. [tiles]
inline constexpr double kMostCellReach = 0.5;

/// What all maps of a quilting noise share.
struct QuiltingNoise {
  Grain grain = Grain::none;     ///< stretches the lattice, of all materials
  double reach = kMostCellReach; ///< (0, kMostCellReach], of the image of cells [tiles]
  /// [0, 1] How highly two tiles correlate on average where they overlap, close up.
  double correlation = 0.0;
  /// Where tiles are taken from, [0, 1) tiles: shifts that nearly repeat the exemplar. At most
  /// kMostQuiltingOffsets, no fewer than kFewestQuiltingOffsets; or none, and tiles are taken from
  /// anywhere.
  std::vector<std::array<double, 2>> offsets;

  [[nodiscard]] bool operator==(const QuiltingNoise&) const = default;
};
inline constexpr std::size_t kFewestQuiltingOffsets = 3; // fewer hardly differ from a plain repeat

/// A map's image, and the image of the exemplar's cells, which all maps share. Both repeat, and
/// have the full chain of mip levels.
///
/// The image holds the stored values in as many channels (three in RGBA, whose alpha is 1); of
/// slopes the third channel of RGBA is the mean of their squares along both axes, so that
/// mip levels know the variance that they lose. A texel of level l is the average of the decoded
/// quantity, light for colours, over 2^l x 2^l texels, stored again.
///
/// The image of cells is RGBA with values in [0, 1]. Red and green are the vector from a texel to
/// the centre of its cell: (2 value - 1) reach along x and y. Blue is the sharpness of cuts,
/// constant over each level, alpha is 1.
struct QuiltingMap {
  std::size_t image = 0; ///< index into Bundle::tables
  std::size_t cells = 0; ///< index into Bundle::tables, the same for all maps of a noise

  /// As in TilingMap.
  [[nodiscard]] std::size_t imageTable() const { return image; }
  [[nodiscard]] std::optional<std::size_t> decodingTable() const { return std::nullopt; }

  /// Calls visit(index) for each table index.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.image);
    visit(self.cells);
  }

  [[nodiscard]] bool operator==(const QuiltingMap&) const = default;
};

} // namespace lichen
