// SPDX-License-Identifier: MIT
// Contrast as a function of the distance to the nearest vertex of the tiling lattice.
//
// Image (height, width) and lattice -> one number.
#include "boundary.h"

#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lichen {
namespace {

constexpr std::size_t kClasses = 8;
/// Fine distance steps that are grouped into classes of equal population, to about 1 / kSteps.
constexpr std::size_t kSteps = 4096;

/// Distance from (x, y) to the nearest vertex, in tiles of a lattice that is not stretched: blend
/// weights depend on the position in the triangle, whatever its shape.
double vertexDistance(const Lattice& lattice, double x, double y) {
  const double squeezeX = lattice.columnsPerTile / kLatticeColumnsPerTile;
  const double squeezeY = lattice.rowsPerTile / kLatticeRowsPerTile;
  double nearest = 1.0;
  const double row = std::floor(y * lattice.rowsPerTile);
  // The nearest vertex is in the row above or the row below. Vertices of other rows are farther
  // away than the height of a row, which exceeds the largest possible distance.
  for (const double j : {row, row + 1.0}) {
    const double i = std::round(x * lattice.columnsPerTile - 0.5 * j);
    const double dx = x - (i + 0.5 * j) / lattice.columnsPerTile;
    const double dy = y - j / lattice.rowsPerTile;
    nearest = std::min(nearest, std::hypot(squeezeX * dx, squeezeY * dy));
  }
  return nearest;
}

/// The class in [0, kClasses) of each pixel by its distance. All classes are about equally large.
std::vector<std::uint8_t> distanceClasses(int width, int height, const LatticeView& view) {
  constexpr Lattice kUnstretched;
  const double farthest =
      std::hypot(0.5 / kUnstretched.columnsPerTile, 1.0 / kUnstretched.rowsPerTile);
  std::vector<std::uint16_t> steps(std::size_t(width) * std::size_t(height));
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const double distance =
          vertexDistance(view.lattice, view.originTilesX + (x + 0.5) * view.tilesPerPixelX,
                         view.originTilesY + (y + 0.5) * view.tilesPerPixelY);
      const auto step = std::size_t(distance / farthest * double(kSteps));
      steps[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
          std::uint16_t(std::min(step, kSteps - 1));
    }
  });

  std::vector<std::size_t> population(kSteps, 0);
  for (const std::uint16_t step : steps)
    ++population[step];
  std::vector<std::uint8_t> classOfStep(kSteps, 0);
  std::size_t below = 0;
  for (std::size_t step = 0; step < kSteps; ++step) {
    const std::size_t middle = below + population[step] / 2;
    classOfStep[step] = std::uint8_t(std::min(kClasses * middle / steps.size(), kClasses - 1));
    below += population[step];
  }
  std::vector<std::uint8_t> classes(steps.size());
  std::transform(steps.begin(), steps.end(), classes.begin(),
                 [&](std::uint16_t step) { return classOfStep[step]; });
  return classes;
}

double visibility(const std::vector<float>& plane, const std::vector<std::uint8_t>& classes) {
  double total = 0.0;
  for (const float value : plane)
    total += double(value);
  const double mean = total / double(plane.size());
  std::array<double, kClasses> squares{};
  std::array<double, kClasses> counts{};
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const double deviation = double(plane[i]) - mean;
    squares[classes[i]] += deviation * deviation;
    counts[classes[i]] += 1.0;
  }
  double smallest = 0.0, largest = 0.0, sum = 0.0, used = 0.0;
  for (std::size_t k = 0; k < kClasses; ++k) {
    if (counts[k] == 0.0)
      continue; // the view has so few pixels that a class is empty
    const double variance = squares[k] / counts[k];
    smallest = used == 0.0 ? variance : std::min(smallest, variance);
    largest = std::max(largest, variance);
    sum += variance;
    used += 1.0;
  }
  return sum > 0.0 ? (largest - smallest) * used / sum : 0.0;
}

std::optional<Error> viewRefusal(const SrgbImage& image, const LatticeView& view) {
  constexpr std::size_t kFewestPixels = 64;
  if (auto error = refusal(image, "the result", 1))
    return error;
  if (image.pixelCount() < kFewestPixels)
    return Error{ErrorKind::badInput, "the result is " + describe(image) + "; expected at least " +
                                          std::to_string(kFewestPixels) + " pixels"};
  constexpr double kFarthestOrigin = 0x1p30;
  const bool usable = view.lattice.columnsPerTile > 0.0 && view.lattice.rowsPerTile > 0.0 &&
                      view.tilesPerPixelX > 0.0 && view.tilesPerPixelY > 0.0 &&
                      std::abs(view.originTilesX) < kFarthestOrigin &&
                      std::abs(view.originTilesY) < kFarthestOrigin;
  if (usable)
    return std::nullopt;
  return Error{ErrorKind::usage,
               "lattice view out of range; expected positive scales and origins below 2^30"};
}

} // namespace

Result<double> latticeVisibility(const SrgbImage& result, const LatticeView& view) {
  return withinMemory(exhausted, [&]() -> Result<double> {
    if (auto error = viewRefusal(result, view))
      return *error;
    return visibility(luminancePlane(result), distanceClasses(result.width, result.height, view));
  });
}

} // namespace lichen
