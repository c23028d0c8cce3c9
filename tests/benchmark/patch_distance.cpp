// SPDX-License-Identifier: MIT
// Two pictures -> patches of 9 x 9 luminances -> their projections, sorted -> one number. Source:
// [RPDB12], of patches as of colours.
#include "patch_distance.h"

#include <lichen/lattice.h>
#include <lichen/spectrum.h>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace lichen::bench {
namespace {

constexpr int kPatchSide = 9;
constexpr int kPatchPixels = kPatchSide * kPatchSide;
constexpr int kDirections = 256;       // fixed, so that values can be compared
constexpr int kMostPatchesAcross = 96; // as many along each axis; more change little

/// A row of pixels at a time.
using Patches = Eigen::Matrix<float, Eigen::Dynamic, kPatchPixels, Eigen::RowMajor>;
using Directions = Eigen::Matrix<float, kPatchPixels, kDirections>;

/// The place of part `index` of `parts` equal parts of a row of places, all of them in turn if
/// there are as many parts. `random` is in [0, 2^32).
int placeIn(int index, int parts, int places, std::uint32_t random) {
  const auto fixed = (std::uint64_t(index) << 32U) + random; // 32 bits after the point
  return int(fixed * std::uint64_t(places) / std::uint64_t(parts) >> 32U);
}

/// All patches, or at most kMostPatchesAcross^2: one from a random place in each cell of a grid
/// over the picture. At a fixed spacing, patches of a periodic picture would show only a few of its
/// phases.
Patches patchesOf(const SrgbImage& image) {
  const std::vector<float> luminance = luminancePlane(image);
  const int placesX = image.width - kPatchSide + 1, placesY = image.height - kPatchSide + 1;
  const int columns = std::min(placesX, kMostPatchesAcross);
  const int rows = std::min(placesY, kMostPatchesAcross);
  Patches patches(Eigen::Index(columns) * rows, kPatchPixels);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto random = pcg3d({std::uint32_t(i), std::uint32_t(j), 1}); // 0 is of directions()
      const int left = placeIn(i, columns, placesX, random[0]);
      const int top = placeIn(j, rows, placesY, random[1]);
      const Eigen::Index row = Eigen::Index(j) * columns + i;
      for (int k = 0; k < kPatchPixels; ++k)
        patches(row, k) = luminance[std::size_t(top + k / kPatchSide) * std::size_t(image.width) +
                                    std::size_t(left + k % kPatchSide)];
    }
  return patches;
}

/// Independent unit vectors: of normal deviates [BM58].
Directions directions() {
  Directions all;
  for (int k = 0; k < kDirections; ++k)
    for (int i = 0; i < kPatchPixels; ++i) {
      const auto words = pcg3d({std::uint32_t(i), std::uint32_t(k), 0});
      const double radius = std::sqrt(-2.0 * std::log((double(words[0]) + 0.5) * 0x1p-32));
      all(i, k) = float(radius * std::cos(2.0 * std::numbers::pi * double(words[1]) * 0x1p-32));
    }
  all.colwise().normalize();
  return all;
}

std::vector<float> sortedProjections(const Patches& patches, const Directions& all, int direction) {
  const Eigen::VectorXf projected = patches * all.col(direction);
  std::vector<float> values(projected.data(), projected.data() + projected.size());
  std::sort(values.begin(), values.end());
  return values;
}

/// The integral of the squared difference between the quantile functions of two sorted sets.
double squaredDistance(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0, reached = 0.0;
  const double shareA = 1.0 / double(a.size()), shareB = 1.0 / double(b.size());
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double endA = shareA * double(i + 1), endB = shareB * double(j + 1);
    const double end = std::min(endA, endB), difference = double(a[i]) - double(b[j]);
    sum += (end - reached) * difference * difference;
    reached = end;
    i += endA <= endB ? 1U : 0U;
    j += endB <= endA ? 1U : 0U;
  }
  return sum;
}

} // namespace

double patchDistance(const SrgbImage& exemplar, const SrgbImage& result) {
  const Patches a = patchesOf(exemplar), b = patchesOf(result);
  const Directions all = directions();
  std::vector<double> squares(kDirections, 0.0);
  tbb::parallel_for(0, kDirections, [&](int k) {
    squares[std::size_t(k)] =
        squaredDistance(sortedProjections(a, all, k), sortedProjections(b, all, k));
  });
  double sum = 0.0;
  for (const double square : squares)
    sum += square;
  return std::sqrt(sum / kDirections);
}

} // namespace lichen::bench
