// SPDX-License-Identifier: MIT
// Position in a cell -> the windows of the vertices around it; and the size of the lattices' cells.
#include "octave_lattice.h"

#include <lichen/fft.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace lichen::local_random_phase {
namespace {

/// The window before its normalisation, at the squared distance `square` from its vertex in units
/// of the squared edge of a lattice's triangles: (1 - square / (3 / 4))^3, 0 from sqrt(3) / 2 on.
/// A smaller radius than [LRP14]'s 1.5: within sqrt(3) / 2, the height of a triangle, a point has
/// windows of the three vertices around it and no others.
double windowAt(double square) {
  constexpr double kPerSquaredRadius = 4.0 / 3.0;
  const double left = 1.0 - kPerSquaredRadius * square;
  return left > 0.0 ? left * left * left : 0.0;
}

/// The vector from a vertex, in lattice coordinates -> its squared length in edges.
double squaredEdges(double column, double row) {
  return column * column + column * row + row * row;
}

} // namespace

Windows windowsAt(double column, double row) {
  const int corner = column + row < 1.0 ? 0 : 1;
  Windows windows;
  windows.corner = {{{corner, corner}, {1, 0}, {0, 1}}};
  double squares = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    windows.offset[k] = {column - windows.corner[k][0], row - windows.corner[k][1]};
    windows.weight[k] = windowAt(squaredEdges(windows.offset[k][0], windows.offset[k][1]));
    squares += windows.weight[k] * windows.weight[k];
  }
  const double scale = 1.0 / std::sqrt(squares);
  for (double& weight : windows.weight)
    weight *= scale;
  return windows;
}

std::array<int, 2> cellsOfOctave0(int texelsX, int texelsY) {
  // 7 columns and 8 rows of a square tile are equilateral to 1 %.
  constexpr double kColumns = 7.0, kHalfRows = 4.0;
  const double shorter = std::min(texelsX, texelsY);
  const auto cells = [&](double ofSquare, int side) {
    return std::clamp(int(std::lround(ofSquare * side / shorter)), 1, kMostOctaveCells / 2);
  };
  return {cells(kColumns, texelsX), 2 * cells(kHalfRows, texelsY)};
}

std::array<double, 2> edgesOfOctave0(int columns, int rows) {
  return {kOctaveTiles / double(columns), 2.0 / std::numbers::sqrt3 * kOctaveTiles / double(rows)};
}

// Window -> the power spectrum of its lattice average, as a summed-area table, and its transform.
//
// The mean over the lattice of sum_v w_v(x) w_v(x + t) is the autocorrelation of one window over
// the area of a cell, so the density is |w^|^2 over that area. [LRP14] section 3.5.
namespace {

constexpr int kSamplesPerEdge = 32;
constexpr int kSide = 512; ///< samples of the plane: frequencies 1/16 of a cycle per edge apart
constexpr int kHalf = kSide / 2;
constexpr double kStep = double(kSamplesPerEdge) / kSide;

/// The window of vertex 0 after its normalisation, on a plane around it in unskewed coordinates.
std::vector<float> windowPlane() {
  std::vector<float> plane(std::size_t(kSide) * kSide, 0.0f);
  for (int y = -kSamplesPerEdge; y < kSamplesPerEdge; ++y)
    for (int x = -kSamplesPerEdge; x < kSamplesPerEdge; ++x) {
      const double row = (y + 0.5) / kSamplesPerEdge * 2.0 / std::numbers::sqrt3;
      const double column = (x + 0.5) / kSamplesPerEdge - 0.5 * row;
      const int left = int(std::floor(column)), top = int(std::floor(row));
      const Windows windows = windowsAt(column - left, row - top);
      for (std::size_t k = 0; k < 3; ++k)
        if (left + windows.corner[k][0] == 0 && top + windows.corner[k][1] == 0)
          plane[std::size_t((y + kSide) % kSide) * kSide + std::size_t((x + kSide) % kSide)] =
              float(windows.weight[k]);
    }
  return plane;
}

} // namespace

WindowSpectrum::WindowSpectrum() : sums_(std::size_t(kSide + 1) * (kSide + 1), 0.0) {
  HalfSpectrum spectrum = forwardFft(windowPlane(), kSide, kSide);
  for (std::complex<float>& value : spectrum.values)
    value = std::norm(value);
  const auto power = [&](int u, int v) { // frequencies in steps, in [-kHalf, kHalf)
    if (u < 0)
      return double(spectrum.at(-u, (kSide - v) % kSide).real());
    return double(spectrum.at(u, (v + kSide) % kSide).real());
  };
  const auto at = [&](int row, int column) -> double& {
    return sums_[std::size_t(row) * (kSide + 1) + std::size_t(column)];
  };
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      at(row + 1, column + 1) = power(column - kHalf, row - kHalf) + at(row, column + 1) +
                                at(row + 1, column) - at(row, column);
  const double whole = sums_.back();
  for (double& sum : sums_)
    sum /= whole;
  correlation_ = inverseFft(spectrum);
  const float variance = correlation_.front();
  for (float& value : correlation_)
    value /= variance;
}

double WindowSpectrum::correlation(double x, double y) const {
  // Windows are disks of radius sqrt(3) / 2: two at a distance of sqrt(3) do not overlap.
  constexpr double kSquaredReach = 3.0;
  if (x * x + y * y >= kSquaredReach)
    return 0.0;
  const double column = x * kSamplesPerEdge, row = y * kSamplesPerEdge;
  const int left = int(std::floor(column)), top = int(std::floor(row));
  const double a = column - left, b = row - top;
  const auto at = [&](int i, int j) {
    return double(
        correlation_[std::size_t((j + kSide) % kSide) * kSide + std::size_t((i + kSide) % kSide)]);
  };
  return (1.0 - b) * ((1.0 - a) * at(left, top) + a * at(left + 1, top)) +
         b * ((1.0 - a) * at(left, top + 1) + a * at(left + 1, top + 1));
}

double WindowSpectrum::below(double x, double y) const {
  // A sample stands for the interval of one step around its frequency.
  const auto place = [](double frequency) {
    return std::clamp(frequency / kStep + kHalf + 0.5, 0.0, double(kSide));
  };
  const double column = place(x), row = place(y);
  const int left = std::min(int(column), kSide - 1), top = std::min(int(row), kSide - 1);
  const double a = column - left, b = row - top;
  const double* upper = &sums_[std::size_t(top) * (kSide + 1) + std::size_t(left)];
  const double* lower = upper + kSide + 1;
  return (1.0 - b) * ((1.0 - a) * upper[0] + a * upper[1]) +
         b * ((1.0 - a) * lower[0] + a * lower[1]);
}

} // namespace lichen::local_random_phase
