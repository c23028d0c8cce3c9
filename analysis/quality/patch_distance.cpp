// SPDX-License-Identifier: MIT
// Sliced Wasserstein-2 distance between the neighbourhoods of two pictures' pixels.
//
// Two images, each averaged over squares of `spacing` pixels -> patches of 9 x 9 luminances -> one
// number. Source: [RPDB12], of patches as of colours.
#include "boundary.h"

#include <lichen/lattice.h>
#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace lichen {
namespace {

constexpr int kPatchSide = 9;
constexpr int kPatchPixels = kPatchSide * kPatchSide;
constexpr int kMostSpacing = 1024;
constexpr int kDirections = 256;       // fixed, so that values can be compared
constexpr int kMostPatchesAcross = 96; // as many along each axis; more change little

/// A row of pixels at a time.
using Patches = Eigen::Matrix<float, Eigen::Dynamic, kPatchPixels, Eigen::RowMajor>;
using Directions = Eigen::Matrix<float, kPatchPixels, kDirections>;

struct Plane {
  std::vector<float> values;
  int width = 0, height = 0;
};

/// The luminance, averaged over whole squares.
Plane averaged(const SrgbImage& image, int spacing) {
  const std::vector<float> luminance = luminancePlane(image);
  Plane plane{{}, image.width / spacing, image.height / spacing};
  plane.values.reserve(std::size_t(plane.width) * std::size_t(plane.height));
  const float share = 1.0f / float(spacing * spacing);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      float sum = 0.0f;
      for (int j = y * spacing; j < (y + 1) * spacing; ++j)
        for (int i = x * spacing; i < (x + 1) * spacing; ++i)
          sum += luminance[std::size_t(j) * std::size_t(image.width) + std::size_t(i)];
      plane.values.push_back(share * sum);
    }
  return plane;
}

/// The place of part `index` of `parts` equal parts of a row of places, all of them in turn if
/// there are as many parts. `random` is in [0, 2^32).
int placeIn(int index, int parts, int places, std::uint32_t random) {
  const auto fixed = (std::uint64_t(index) << 32U) + random; // 32 bits after the point
  return int(fixed * std::uint64_t(places) / std::uint64_t(parts) >> 32U);
}

/// All patches, or at most kMostPatchesAcross^2: one from a random place in each cell of a grid
/// over the plane. At a fixed spacing, patches of a periodic picture would show only a few of its
/// phases.
Patches patchesOf(const Plane& plane) {
  const int placesX = plane.width - kPatchSide + 1, placesY = plane.height - kPatchSide + 1;
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
        patches(row, k) =
            plane.values[std::size_t(top + k / kPatchSide) * std::size_t(plane.width) +
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

Result<double> patchDistance(const SrgbImage& exemplar, const SrgbImage& result,
                             int spacingPixels) {
  return withinMemory(exhausted, [&]() -> Result<double> {
    if (spacingPixels < 1 || spacingPixels > kMostSpacing)
      return Error{ErrorKind::usage, "spacing " + std::to_string(spacingPixels) +
                                         "; expected 1 to " + std::to_string(kMostSpacing) +
                                         " pixels"};
    if (auto error = refusal(exemplar, result, kPatchSide * spacingPixels))
      return *error;
    const Patches a = patchesOf(averaged(exemplar, spacingPixels));
    const Patches b = patchesOf(averaged(result, spacingPixels));
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
  });
}

Result<double> lookDistance(const SrgbImage& exemplar, const SrgbImage& result) {
  constexpr int kCoarsest = 4;
  if (auto error = refusal(exemplar, result, kLeastLookSide))
    return *error;
  const int side = std::min(shorterSide(exemplar), shorterSide(result));
  double sum = 0.0;
  int spacings = 0;
  for (int spacing = 1; spacing <= kCoarsest && side >= kLeastLookSide * spacing; spacing *= 2) {
    const Result<double> distance = patchDistance(exemplar, result, spacing);
    if (!distance)
      return distance;
    sum += distance.value() * distance.value();
    ++spacings;
  }
  return std::sqrt(sum / spacings);
}

} // namespace lichen
