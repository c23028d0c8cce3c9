// SPDX-License-Identifier: MIT
// The lattices of a local random-phase noise, one for each octave, and the window at a vertex.
#pragma once

#include <lichen/local_random_phase_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lichen::local_random_phase {

/// The window before its normalisation, at the squared distance `square` from its vertex in units
/// of the squared edge of a lattice's triangles: (1 - square / (3 / 4))^3, 0 from sqrt(3) / 2 on.
/// A smaller radius than [LRP14]'s 1.5: within sqrt(3) / 2, the height of a triangle, a point has
/// windows of the three vertices around it and no others.
template <class Real>
[[nodiscard]] Real windowAt(Real square) {
  constexpr Real kPerSquaredRadius = Real(4) / Real(3);
  const Real left = Real(1) - kPerSquaredRadius * square;
  return left > Real(0) ? left * left * left : Real(0);
}

/// The vector from a vertex, in lattice coordinates -> its squared length in edges.
template <class Real>
[[nodiscard]] Real squaredEdges(Real column, Real row) {
  return column * column + column * row + row * row;
}

/// The windows of the three vertices around a point, scaled so that their squares sum to 1: then
/// the variance of a sum with random phases is the same everywhere.
template <class Real>
struct Windows {
  std::array<std::array<int, 2>, 3> corner{}; ///< of the cell that holds the point
  std::array<std::array<Real, 2>, 3>
      offset{}; ///< from the vertex to the point, lattice coordinates
  std::array<Real, 3> weight{};
};

/// `column` and `row`: the place inside a cell of the skewed lattice, in [0, 1).
template <class Real>
[[nodiscard]] Windows<Real> windowsAt(Real column, Real row) {
  const int corner = column + row < Real(1) ? 0 : 1;
  Windows<Real> windows;
  windows.corner = {{{corner, corner}, {1, 0}, {0, 1}}};
  Real squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    windows.offset[k] = {column - Real(windows.corner[k][0]), row - Real(windows.corner[k][1])};
    windows.weight[k] = windowAt(squaredEdges(windows.offset[k][0], windows.offset[k][1]));
    squares += windows.weight[k] * windows.weight[k];
  }
  const Real scale = Real(1) / std::sqrt(squares);
  for (Real& weight : windows.weight)
    weight *= scale;
  return windows;
}

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
