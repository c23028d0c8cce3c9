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

/// Octaves of the lattice: the lattice of octave k has 2^k times the columns and rows of octave 0.
inline constexpr std::size_t kMostOctaves = 12;
inline constexpr int kMostCosines = 254;
/// The number of tiles that hold whole columns and rows of octave 0.
inline constexpr int kOctaveTiles = 8;
inline constexpr int kMostOctaveCells = 64; ///< columns or rows of octave 0 in kOctaveTiles tiles
inline constexpr int kMostVariants = 32;

/// Columns and rows of a structure's image are powers of two between these.
inline constexpr int kFewestStructureTexels = 64, kMostStructureTexels = 8192;
inline constexpr int kFewestStructureOffsets = 3, kMostStructureOffsets = 64;

/// What the structures of all maps share. A structure is an image of the frequencies that keep the
/// exemplar's phases. Each vertex of a lattice has a tile of it, and tiles are blended.
struct CosineStructure {
  int columns = 0; ///< texels of level 0; 0 without a structure
  int rows = 0;    ///< texels of level 0
  /// The number of offsets of tiles that preserve what repeats in the exemplar; 0 if tiles have any
  /// offset.
  int offsets = 0;
  /// The deviation of the displacement of tiles along each axis [tiles], [0, 1]: 0 leaves them as
  /// they are.
  double turbulence = 0.0;

  [[nodiscard]] bool operator==(const CosineStructure&) const = default;
};

/// The number of levels of a structure's image. The smaller side of the last is 2 texels; beyond
/// it all is averaged out.
[[nodiscard]] int structureLevels(const CosineStructure& structure);

/// What all maps of a noise share: their cosines and the lattices of these.
///
/// Each vertex of a lattice has the cosines of its octave, under a window that reaches as far as
/// the neighbouring vertices. A vertex takes one of `variants` vectors of each cosine, which say
/// how strongly each channel of each map follows it, and for each cosine one frequency of its
/// rectangle at random and a phase.
struct LocalRandomPhaseNoise {
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< size of the exemplar, [1, kMaxTableSide]
  /// Cells of octave 0 in kOctaveTiles tiles: columns in [1, kMostOctaveCells], rows even and in
  /// [2, kMostOctaveCells].
  int columns = 7;
  int rows = 8;
  /// The number of cosines of each octave, from octave 0, all even; at most kMostOctaves octaves,
  /// the last of which is not empty. In total 2 to kMostCosines.
  std::vector<int> cosines;
  int variants = 1; ///< a power of two, [1, kMostVariants]
  CosineStructure structure;
  /// Whether the spectrum is not the exemplar's, which gives colours only.
  bool hasGivenSpectrum = false;

  [[nodiscard]] int cosineCount() const;

  [[nodiscard]] bool operator==(const LocalRandomPhaseNoise&) const = default;
};

/// A map's cosines and inverse table.
///
/// The image's texels are RGBA32F. It begins with one row for two cosines, ordered by octave. These
/// rows have 1 + variants columns, and each float is a pair of numbers (bfloat16_pair.h): red and
/// green belong to the first cosine, blue and alpha to the second.
/// - Column 0: the rectangle of its frequencies [cycles / tile]: the middle along x and y, then the
///   width and the height.
/// - Column 1 + v, variant v: the amplitudes of the first and second channel [Gaussian values],
///   then of the third, and what is added to the phase [turns].
/// The rectangles are the same for all maps. Then come the parts that CosineImageLayout names, if
/// the noise has a structure.
struct LocalRandomPhaseMap {
  std::size_t cosines = 0;                 ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< as TilingMap::inverseTable
  int dimensions = 1;                      ///< D, [1, 3]
  /// D Gaussian values that the largest integer of the structure's texels stands for
  /// (structure_texel.h), [0, kMostAmplitude]. Empty without a structure.
  std::vector<double> structureAmplitudes;
  /// The deviation of each level of the structure over the noise's, [0, 1].
  std::vector<double> structureDeviations;

  /// As in TilingMap.
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

/// Where the parts of an image of cosines lie [texels of the image].
struct CosineImageLayout {
  std::uint32_t width = 0, height = 0;
  std::uint32_t cosineColumns = 0, cosineRows = 0; ///< of the cosines, in the upper left
  /// The row of the list of offsets, two in a texel as (x0, y0, x1, y1) [tiles]. It follows the
  /// cosines, and the levels follow it.
  std::uint32_t offsetRow = 0;
  std::uint32_t meanColumn = 0; ///< the first of the means over the offsets, right of the levels

  explicit CosineImageLayout(const LocalRandomPhaseNoise& shared);

  /// The first column and row of level `level` of a structure, level 1 below level 0 and each of
  /// the others on the right of the one before. Level l has the structure's columns and rows
  /// divided by 2^l, and four texels, two columns of two rows, share one of the image.
  [[nodiscard]] std::array<std::uint32_t, 2> levelCorner(int level) const;

private:
  std::uint32_t firstLevelRow_ = 0, structureColumns_ = 0, structureRows_ = 0;
};

/// A cosine's part of a texel: its rectangle or one of its vectors, in the order above.
using CosineTexel = std::array<float, 4>;

/// The parts of both cosines of each texel, row by row, from the floats of an image. Only the
/// rows and columns of the cosines are in the result.
[[nodiscard]] std::vector<std::array<CosineTexel, kRowCosines>>
cosineTexels(const std::vector<float>& image, const CosineImageLayout& layout);

/// The largest magnitudes in the image: of frequencies, amplitudes and phases.
inline constexpr float kMostFrequency = 16384.0f, kMostAmplitude = 4.0f, kMostTurns = 1.0f;

} // namespace lichen
