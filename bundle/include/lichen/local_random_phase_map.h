// SPDX-License-Identifier: MIT
// The data of a local random-phase noise [LRP14]: windowed sums of cosines with random phases.
#pragma once

#include <lichen/table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lichen {

/// Octaves of the lattice: that of octave k has 2^k times the columns and rows of octave 0.
inline constexpr std::size_t kMostOctaves = 12;
inline constexpr int kMostCosines = 254;
/// The number of tiles that hold whole columns and rows of octave 0.
inline constexpr int kOctaveTiles = 8;
inline constexpr int kMostOctaveCells = 64; ///< columns or rows of octave 0 in kOctaveTiles tiles
inline constexpr int kMostVariants = 32;

/// What all maps of a noise share: their cosines and the lattices of these.
///
/// Each vertex of a lattice has the cosines of its octave, under a window that reaches as far as
/// the neighbouring vertices. A vertex takes one of `variants` vectors of each cosine, which say
/// how strongly each channel of each map follows it, and for each cosine one frequency of its
/// rectangle at random and a phase.
struct LocalRandomPhaseNoise {
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< likewise
  /// Cells of octave 0 in kOctaveTiles tiles: columns in [1, kMostOctaveCells], rows even and in
  /// [2, kMostOctaveCells].
  int columns = 7;
  int rows = 8;
  /// The number of cosines of each octave, from octave 0, all even; at most kMostOctaves octaves,
  /// the last of which is not empty. In total 2 to kMostCosines.
  std::vector<int> cosines;
  int variants = 1; ///< a power of two, [1, kMostVariants]

  [[nodiscard]] int cosineCount() const;

  [[nodiscard]] bool operator==(const LocalRandomPhaseNoise&) const = default;
};

/// A map's cosines and inverse table.
///
/// The image has one row for two cosines, ordered by octave, and 1 + variants columns. Its texels
/// are RGBA32F, and each float is a pair of numbers (bfloat16_pair.h): red and green are those of
/// the first cosine, blue and alpha those of the second.
/// - Column 0: the rectangle of its frequencies [cycles / tile]: the middle along x and y, then the
///   width and the height.
/// - Column 1 + v, variant v: the amplitudes of the first and second channel [Gaussian values],
///   then that of the third, and what is added to the phase [turns].
/// The rectangles are the same for all maps.
struct LocalRandomPhaseMap {
  std::size_t cosines = 0;                 ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< as TilingMap::inverseTable
  int dimensions = 1;                      ///< D, [1, 3]

  /// As those of TilingMap.
  [[nodiscard]] std::size_t imageTable() const { return cosines; }
  [[nodiscard]] std::optional<std::size_t> decodingTable() const { return inverseTable; }

  /// Calls visit(index) for each table index.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.cosines);
    if (self.inverseTable)
      visit(*self.inverseTable);
  }

  [[nodiscard]] bool operator==(const LocalRandomPhaseMap&) const = default;
};

/// Columns of the image before the variants, and cosines in a row.
inline constexpr std::uint32_t kCosineColumns = 1, kRowCosines = 2;

/// A cosine's part of a texel: its rectangle or one of its vectors, in the order above.
using CosineTexel = std::array<float, 4>;

/// The parts of both cosines of each texel, row by row, from the floats of an image.
[[nodiscard]] std::vector<std::array<CosineTexel, kRowCosines>>
cosineTexels(const std::vector<float>& image);

/// The largest magnitudes in the image: of frequencies, amplitudes and phases.
inline constexpr float kMostFrequency = 16384.0f, kMostAmplitude = 4.0f, kMostTurns = 1.0f;

} // namespace lichen
