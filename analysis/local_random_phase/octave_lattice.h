// SPDX-License-Identifier: MIT
// The lattices of a local random-phase noise, one for each octave, and the window at a vertex.
#pragma once

#include <lichen/local_random_phase_map.h>

#include <array>
#include <vector>

namespace lichen::local_random_phase {

/// The windows of the three vertices around a point, scaled so that their squares sum to 1: then
/// the variance of a sum with random phases is the same everywhere.
struct Windows {
  std::array<std::array<int, 2>, 3> corner{}; ///< of the cell that holds the point
  /// From the vertex to the point, in lattice coordinates.
  std::array<std::array<double, 2>, 3> offset{};
  std::array<double, 3> weight{};
};

/// `column` and `row`: the position inside a cell of the skewed lattice, in [0, 1).
[[nodiscard]] Windows windowsAt(double column, double row);

/// The octave of the lattice at whose vertices tiles of the structure lie: its edges are about a
/// quarter of a tile.
inline constexpr int kPlacementOctave = 2;

/// The columns and rows in kOctaveTiles tiles that make triangles as nearly equilateral as
/// possible, with edges about as long as the shorter side of the tile.
[[nodiscard]] std::array<int, 2> cellsOfOctave0(int texelsX, int texelsY);

/// Edges of octave 0 along x and 2 / sqrt(3) of its rows' distance along y, in tiles. Both are the
/// length of an edge where triangles are equilateral.
[[nodiscard]] std::array<double, 2> edgesOfOctave0(int columns, int rows);

/// The power spectral density of a cosine of frequency 0 and variance 1 under the windows of a
/// lattice, on average over the lattice, as a summed-area table over frequencies in cycles per
/// edge.
class WindowSpectrum {
public:
  /// Throws std::bad_alloc. About 10 ms.
  WindowSpectrum();

  /// The integral of the density over all frequencies below (x, y) along both axes: rises from 0 to
  /// 1.
  [[nodiscard]] double below(double x, double y) const;

  /// The autocovariance of that cosine at the lag (x, y) in edges: 1 at (0, 0), 0 where windows do
  /// not meet.
  [[nodiscard]] double correlation(double x, double y) const;

private:
  std::vector<double> sums_;
  std::vector<float> correlation_;
};

} // namespace lichen::local_random_phase
