// SPDX-License-Identifier: MIT
// The data of a local random-phase noise [LRP14]: windowed sums of cosines with random phases.
#pragma once

#include <lichen/table.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lichen {

/// Octaves of the lattice: that of octave k has 2^k times the columns and rows of octave 0.
inline constexpr std::size_t kMostOctaves = 12;
inline constexpr int kMostCosines = 255;
/// The number of tiles that hold whole columns and rows of octave 0.
inline constexpr int kOctaveTiles = 8;
inline constexpr int kMostOctaveCells = 64; ///< columns or rows of octave 0 in kOctaveTiles tiles
inline constexpr int kMostVariants = 32;

/// What all maps of a noise share: their cosines and the lattices of these.
///
/// Each vertex of a lattice has the cosines of its octave, under a window that reaches as far as
/// the neighbouring vertices. Cosine j takes one frequency of a rectangle at random, a phase, and
/// one of `variants` vectors, which say how strongly each channel of each map follows it.
struct LocalRandomPhaseNoise {
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< likewise
  /// Cells of octave 0 in kOctaveTiles tiles: columns in [1, kMostOctaveCells], rows even and in
  /// [2, kMostOctaveCells].
  int columns = 7;
  int rows = 8;
  /// The number of cosines of each octave, from octave 0; at most kMostOctaves octaves, the last of
  /// which is not empty. In total 1 to kMostCosines.
  std::vector<int> cosines;
  int variants = 1; ///< a power of two, [1, kMostVariants]

  [[nodiscard]] int cosineCount() const;

  [[nodiscard]] bool operator==(const LocalRandomPhaseNoise&) const = default;
};

/// A map's cosines and inverse table.
///
/// The image has one row for each cosine, ordered by octave, and 1 + variants columns of half
/// floats or floats, RGBA:
/// - column 0: the rectangle of its frequencies, in cycles per tile, as 1,024 x 1,024 equal parts:
/// the
///   middle of the first (red, green), and the width and height of each (blue, alpha);
/// - column 1 + v: variant v: the amplitude of each channel (red, green, blue), in Gaussian values,
///   and what is added to the phase, in turns (alpha).
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

/// Columns of the image before the variants, and steps along each side of a rectangle.
inline constexpr std::uint32_t kCosineColumns = 1;
inline constexpr double kFrequencySteps = 1024.0;

/// The largest magnitudes in the image: of frequencies, amplitudes and phases.
inline constexpr float kMostFrequency = 16384.0f, kMostAmplitude = 4.0f, kMostTurns = 1.0f;

} // namespace lichen
