// SPDX-License-Identifier: MIT
// Map -> correlation of the picture with itself, moved without wrapping around -> the lattice of
// vectors that repeat it -> the smallest upright cell of it -> as many cells as fit; of a picture
// in perspective, of the picture without it.
//
// docs/decisions/012-quilting.md says how the constants were chosen.
#include "whole_periods.h"

#include "exemplar/planes.h"
#include "perspective.h"
#include "self_similarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace lichen::placement {
namespace {

using exemplar::ImageLevel;

/// The picture without slow variation.
ImageLevel withDetail(const ImageLevel& image) {
  constexpr double kRadius = 0.1; // of a mean side
  const int radius =
      std::max(1, int(std::lround(kRadius * std::sqrt(double(image.width) * image.height))));
  const auto channels = std::size_t(image.channels);
  ImageLevel result = image;
  std::vector<float> plane(image.values.size() / channels);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = image.values[i * channels + c];
    const std::vector<float> slow = exemplar::boxMean(plane, image.width, image.height, radius);
    for (std::size_t i = 0; i < plane.size(); ++i)
      result.values[i * channels + c] -= slow[i];
  }
  return result;
}

/// A vector of the lattice, or a position. [pixels] y is down.
using Vector = std::array<double, 2>;

double lengthOf(const Vector& v) { return std::hypot(v[0], v[1]); }
double cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }
Vector combined(double i, const Vector& a, double j, const Vector& b) {
  return {i * a[0] + j * b[0], i * a[1] + j * b[1]};
}

/// How highly the picture correlates with itself, moved, and how far that can be trusted.
class Repetition {
public:
  explicit Repetition(const ImageLevel& image)
      : width_(image.width), height_(image.height), correlation_(selfCorrelation(image)) {
    grainArea_ = (2.0 * reachOfGrain(1, 0) + 1.0) * (2.0 * reachOfGrain(0, 1) + 1.0);
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] double at(int x, int y) const { return double(correlation_.at(x, y)); }
  /// The highest within a pixel.
  [[nodiscard]] double near(const Vector& v) const {
    const int x = int(std::lround(v[0])), y = int(std::lround(v[1]));
    double highest = at(x, y);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        highest = std::max(highest, at(x + dx, y + dy));
    return highest;
  }
  /// The share of the picture that has a partner.
  [[nodiscard]] double overlap(const Vector& v) const {
    return std::max(0.0, 1.0 - std::abs(v[0]) / width_) *
           std::max(0.0, 1.0 - std::abs(v[1]) / height_);
  }
  /// The variance of an estimated correlation, of as many independent samples as grains overlap.
  [[nodiscard]] double variance(double correlation, const Vector& v) const {
    const double grains = overlap(v) * width_ * height_ / grainArea_;
    const double rest = 1.0 - correlation * correlation;
    return rest * rest / grains;
  }

private:
  /// Up to where half of the correlation remains.
  [[nodiscard]] int reachOfGrain(int x, int y) const {
    int k = 0;
    while (k < std::min(width_, height_) && correlation_.at(k * x, k * y) > 0.5f)
      ++k;
    return k;
  }

  int width_, height_;
  SelfCorrelation correlation_;
  double grainArea_ = 1.0;
};

constexpr double kLeastOverlap = 0.25; // of the picture, for vectors whose correlation counts

/// The position of the peak around a pixel: of a parabola through the correlations beside it.
Vector refined(const Repetition& repetition, int x, int y) {
  const auto shift = [](double before, double here, double after) {
    const double bend = before - 2.0 * here + after;
    return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
  };
  const double here = repetition.at(x, y);
  return {x + shift(repetition.at(x - 1, y), here, repetition.at(x + 1, y)),
          y + shift(repetition.at(x, y - 1), here, repetition.at(x, y + 1))};
}

/// The highest peaks, less their standard errors; of two opposite ones the lower in the picture.
std::vector<Vector> highestPeaks(const Repetition& repetition) {
  constexpr int kApart = 4; // pixels
  constexpr std::size_t kMost = 60;
  struct Peak {
    Vector at;
    double height = 0.0;
  };
  std::vector<Peak> found;
  for (int y = 0; y < repetition.height(); ++y)
    for (int x = y == 0 ? 1 : 1 - repetition.width(); x < repetition.width(); ++x) {
      const double value = repetition.at(x, y);
      const Vector at{double(x), double(y)};
      if (value <= 0.0 || repetition.overlap(at) < kLeastOverlap)
        continue;
      bool isPeak = true;
      for (int dy = -kApart; dy <= kApart && isPeak; ++dy)
        for (int dx = -kApart; dx <= kApart && isPeak; ++dx)
          isPeak = repetition.at(x + dx, y + dy) <= value;
      if (isPeak)
        found.push_back(
            {refined(repetition, x, y), value - std::sqrt(repetition.variance(value, at))});
    }
  std::ranges::stable_sort(found, std::greater(), &Peak::height);
  std::vector<Vector> result;
  for (std::size_t i = 0; i < std::min(found.size(), kMost); ++i)
    result.push_back(found[i].at);
  return result;
}

/// Two vectors whose whole combinations repeat the picture.
struct Lattice {
  Vector a{}, b{};
};

/// The same lattice by its two shortest vectors, the shorter one first. Lagrange's reduction.
Lattice reduced(Lattice lattice) {
  auto& [a, b] = lattice;
  while (true) {
    if (lengthOf(a) > lengthOf(b))
      std::swap(a, b);
    const Vector shorter = combined(1.0, b, -std::round(dot(a, b) / dot(a, a)), a);
    if (!(lengthOf(shorter) < lengthOf(b)))
      return lattice;
    b = shorter;
  }
}

/// Calls use(i, j, vector) for half of the combinations i a + j b of the lattice's vectors whose
/// overlap counts; the others are opposite. i and j are whole numbers of at most so many steps,
/// plus `beside`, each 0 or 1/2; one of them is at least 1, since within a cell all is alike.
void eachOf(const Repetition& repetition, const Lattice& lattice, int steps, const auto& use,
            const Vector& beside = {}) {
  for (int row = 0; row <= steps; ++row)
    for (int column = -steps; column <= steps; ++column) {
      const double i = column + beside[0], j = row + beside[1];
      if ((j == 0.0 && i < 0.0) || (std::abs(i) < 1.0 && std::abs(j) < 1.0))
        continue;
      const Vector v = combined(i, lattice.a, j, lattice.b);
      if (repetition.overlap(v) >= kLeastOverlap)
        use(i, j, v);
    }
}

struct Estimate {
  double mean = 0.0, error = 0.0;
};

/// The mean correlation at the lattice's vectors, or `beside` them, as for eachOf().
Estimate correlationAlong(const Repetition& repetition, const Lattice& lattice, int steps,
                          const Vector& beside = {}) {
  double sum = 0.0, weights = 0.0, variance = 0.0;
  const auto add = [&](double, double, const Vector& v) {
    const double weight = repetition.overlap(v), value = repetition.near(v);
    sum += weight * value;
    weights += weight;
    variance += weight * weight * repetition.variance(value, v);
  };
  eachOf(repetition, lattice, steps, add, beside);
  return weights > 0.0 ? Estimate{sum / weights, std::sqrt(variance) / weights} : Estimate{};
}

/// How much higher the lattice's vectors correlate than those half way between them.
double contrastOf(const Repetition& repetition, const Lattice& lattice, int steps) {
  const double mean = correlationAlong(repetition, lattice, steps).mean;
  double least = 1.0;
  for (const Vector& half : {Vector{0.5, 0.0}, Vector{0.0, 0.5}, Vector{0.5, 0.5}})
    least = std::min(least, mean - correlationAlong(repetition, lattice, steps, half).mean);
  return least;
}

/// Fits the lattice to the peaks near its vectors by least squares, from the shortest vectors on:
/// only a good fit of those says which peaks belong to longer ones.
Lattice fitted(const Repetition& repetition, Lattice lattice, int mostSteps) {
  constexpr int kNear = 2; // pixels
  for (int steps = 2; steps <= 2 * mostSteps; steps *= 2) {
    double ii = 0.0, ij = 0.0, jj = 0.0;
    Vector iv{}, jv{};
    eachOf(repetition, lattice, std::min(steps, mostSteps),
           [&](double i, double j, const Vector& v) {
             int x = int(std::lround(v[0])), y = int(std::lround(v[1]));
             const int fromX = x, fromY = y;
             for (int dy = -kNear; dy <= kNear; ++dy)
               for (int dx = -kNear; dx <= kNear; ++dx)
                 if (repetition.at(fromX + dx, fromY + dy) > repetition.at(x, y)) {
                   x = fromX + dx;
                   y = fromY + dy;
                 }
             const double weight = repetition.overlap(v) * std::max(0.0, repetition.at(x, y));
             const Vector peak = refined(repetition, x, y);
             ii += weight * i * i;
             ij += weight * i * j;
             jj += weight * j * j;
             iv = combined(1.0, iv, weight * i, peak);
             jv = combined(1.0, jv, weight * j, peak);
           });
    const double determinant = ii * jj - ij * ij;
    if (determinant <= 1e-9 * ii * jj)
      return lattice;
    lattice = {combined(jj / determinant, iv, -ij / determinant, jv),
               combined(ii / determinant, jv, -ij / determinant, iv)};
  }
  return lattice;
}

/// The smallest parallelogram of the lattice's vectors that is nearly upright and nearly a
/// rectangle: bricks of a row to the right, and rows down.
std::optional<Lattice> uprightCell(const Lattice& lattice) {
  constexpr int kSteps = 12;
  constexpr double kMostTurn = 25.0 * std::numbers::pi / 180.0,
                   kMostSkew = 10.0 * std::numbers::pi / 180.0;
  constexpr double kSkewLoss = 6.0, kTurnLoss = 1.0; // of the size, per radian
  std::vector<Vector> rights, downs;
  for (int j = -kSteps; j <= kSteps; ++j)
    for (int i = -kSteps; i <= kSteps; ++i) {
      const Vector v = combined(i, lattice.a, j, lattice.b);
      if (v[0] > 0.0 && std::abs(std::atan2(v[1], v[0])) < kMostTurn)
        rights.push_back(v);
      if (v[1] > 0.0 && std::abs(std::atan2(v[0], v[1])) < kMostTurn)
        downs.push_back(v);
    }
  std::optional<Lattice> best;
  double least = 0.0;
  for (const Vector& right : rights)
    for (const Vector& down : downs) {
      const double skew = std::abs(
          std::asin(std::clamp(dot(right, down) / (lengthOf(right) * lengthOf(down)), -1.0, 1.0)));
      if (skew > kMostSkew)
        continue;
      const double size =
          lengthOf(right) * lengthOf(down) *
          (1.0 + kSkewLoss * skew + kTurnLoss * std::abs(std::atan2(right[1], right[0])));
      if (!best || size < least) {
        best = {right, down};
        least = size;
      }
    }
  return best;
}

/// The sides of the largest frame: of the most copies of the cell, side by side, that fit in the
/// picture.
std::optional<Lattice> repeated(const Lattice& cell, int width, int height) {
  std::optional<Lattice> best;
  double most = 0.0;
  for (int m = 1; m * cell.a[0] <= width; ++m)
    for (int n = 1; n * cell.b[1] <= height; ++n)
      if (m * cell.a[0] + n * std::abs(cell.b[0]) <= width &&
          m * std::abs(cell.a[1]) + n * cell.b[1] <= height && m * n > most) {
        most = m * n;
        best = {combined(m, cell.a, 0.0, cell.b), combined(0.0, cell.a, n, cell.b)};
      }
  return best;
}

/// The cell without its turn and skew, if it correlates no less so: along boards any shift repeats
/// the picture, and one that turns or shears the boards costs some of them.
Lattice levelled(const Repetition& repetition, const Lattice& cell) {
  constexpr int kSteps = 8;
  constexpr double kNoLess = 0.5;       // standard errors
  constexpr double kLeastOfSide = 0.02; // overlap
  const Lattice level{{cell.a[0], 0.0}, {0.0, cell.b[1]}};
  double fall = 0.0, variance = 0.0; // sums over the same vectors of both
  const auto add = [&](double i, double j, const Vector& v) {
    const Vector upright = combined(i, level.a, j, level.b);
    const double weight = std::min(repetition.overlap(v), repetition.overlap(upright));
    const double own = repetition.near(v);
    fall += weight * (own - repetition.near(upright));
    variance += weight * weight * repetition.variance(own, v);
  };
  eachOf(repetition, cell, kSteps, add);
  // Adds long sides too, which eachOf() leaves out.
  const auto isLeftOut = [&](const Vector& side) {
    const double overlap = repetition.overlap(side);
    return overlap >= kLeastOfSide && overlap < kLeastOverlap;
  };
  if (isLeftOut(cell.a))
    add(1.0, 0.0, cell.a);
  if (isLeftOut(cell.b))
    add(0.0, 1.0, cell.b);
  return fall <= kNoLess * std::sqrt(variance) ? level : cell;
}

struct FoundLattice {
  Lattice lattice;
  Lattice cell;             ///< upright
  double correlation = 0.0; ///< the mean less its standard error
  double contrast = 0.0;    ///< as in WholePeriods
};

/// The lattice that repeats the picture most highly, among the lattices of two peaks that have a
/// frame. Vectors in between that repeat it as well count in favour of the lattice that has them.
FoundLattice bestLattice(const Repetition& repetition) {
  constexpr int kLeastSide = 16;          // pixels
  constexpr double kShortest = 5.0;       // pixels
  constexpr double kDensityGain = 0.025;  // of the correlation, for twice as many vectors
  constexpr double kLeastContrast = 0.06; // of the correlation; along a groove there is none
  constexpr int kSteps = 4, kMostSteps = 64;
  const int width = repetition.width(), height = repetition.height();
  if (std::min(width, height) < kLeastSide)
    return {};
  const std::vector<Vector> peaks = highestPeaks(repetition);
  const auto hasFrame = [&](const Lattice& lattice) {
    const std::optional<Lattice> cell = uprightCell(lattice);
    return cell && repeated(*cell, width, height);
  };
  FoundLattice best;
  double highest = 0.0;
  for (std::size_t i = 0; i < peaks.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Lattice lattice = reduced({peaks[k], peaks[i]});
      const double area = std::abs(cross(lattice.a, lattice.b));
      if (lengthOf(lattice.a) < kShortest || area < 0.5 * lengthOf(lattice.a) * lengthOf(lattice.b))
        continue;
      const Estimate estimate = correlationAlong(repetition, lattice, kSteps);
      const double score = (estimate.mean - estimate.error) *
                           (1.0 + kDensityGain * std::log2(double(width) * double(height) / area));
      if (score <= highest || !hasFrame(lattice) ||
          contrastOf(repetition, lattice, kSteps) < kLeastContrast * estimate.mean)
        continue;
      highest = score;
      best.lattice = lattice;
    }
  if (highest == 0.0)
    return {};
  best.lattice = reduced(fitted(repetition, best.lattice, kMostSteps));
  if (lengthOf(best.lattice.a) < kShortest)
    return {};
  const std::optional<Lattice> cell = uprightCell(best.lattice);
  if (!cell)
    return {};
  best.cell = levelled(repetition, *cell);
  const Estimate estimate = correlationAlong(repetition, best.lattice, kMostSteps);
  best.correlation = estimate.mean - estimate.error;
  best.contrast =
      estimate.mean > 0.0 ? contrastOf(repetition, best.lattice, kMostSteps) / estimate.mean : 0.0;
  return best;
}

/// Whether a side of the picture is clearly between the lattice's vectors.
bool misses(const Lattice& lattice, int width, int height) {
  constexpr double kClearly = 0.2; // of the lattice's vectors
  const auto& [a, b] = lattice;
  const auto away = [&](const Vector& side) {
    const double i = cross(side, b) / cross(a, b), j = cross(a, side) / cross(a, b);
    return std::max(std::abs(i - std::round(i)), std::abs(j - std::round(j)));
  };
  return away({double(width), 0.0}) > kClearly || away({0.0, double(height)}) > kClearly;
}

/// Whether the picture's own opposite borders look alike across both axes.
bool lookAlike(const ImageLevel& image) {
  const BorderMisfit misfit(image);
  return misfit.bordersLookAlike(0) && misfit.bordersLookAlike(1);
}

/// The corners of a parallelogram inside the picture, with these sides: where opposite borders
/// fit best, as they do in joints.
TileCorners placed(const Lattice& sides, const ImageLevel& image) {
  const auto& [right, down] = sides;
  const auto cornersFrom = [&](const Vector& corner) {
    return TileCorners{{corner, combined(1.0, corner, 1.0, right),
                        combined(1.0, combined(1.0, corner, 1.0, right), 1.0, down),
                        combined(1.0, corner, 1.0, down)}};
  };
  // The range of the upper left corner.
  const Vector least{std::max(0.0, -down[0]), std::max(0.0, -right[1])};
  const Vector most{image.width - right[0] - std::max(0.0, down[0]),
                    image.height - down[1] - std::max(0.0, right[1])};
  const BorderMisfit misfit(image);
  Vector best = combined(0.5, least, 0.5, most);
  for (const std::size_t axis : {std::size_t(0), std::size_t(1)}) {
    const Vector& side = axis == 0 ? down : right;
    const Vector& apart = axis == 0 ? right : down;
    double lowest = misfit.between(best, side, apart);
    Vector corner = best;
    for (corner[axis] = least[axis]; corner[axis] <= most[axis]; corner[axis] += 1.0)
      if (const double own = misfit.between(corner, side, apart); own < lowest) {
        lowest = own;
        best = corner;
      }
  }
  return cornersFrom(best);
}

} // namespace

WholePeriods wholePeriods(const MapExemplar& map, bool bordersFit) {
  constexpr double kLeastCorrelation = 0.25, kLeastOfFew = 0.45;
  constexpr double kFew = 8.0; // periods in the picture, which may be alike by chance
  ImageLevel image = exemplar::reducedImage(map, kMostPeriodSide);
  const auto latticeOf = [](const ImageLevel& level) {
    return bestLattice(Repetition(withDetail(level)));
  };
  const auto isSure = [&](const FoundLattice& found) {
    const double area = std::abs(cross(found.lattice.a, found.lattice.b));
    const bool areFew = kFew * area > double(image.width) * image.height;
    return found.correlation >= (areFew ? kLeastOfFew : kLeastCorrelation);
  };
  const auto isWhole = [&](const FoundLattice& found) {
    return bordersFit && isSure(found) && !misses(found.lattice, image.width, image.height);
  };
  FoundLattice found = latticeOf(image);
  const bool tiles = isWhole(found) || (bordersFit && lookAlike(image));
  std::optional<Keystone> keystone;
  if (!tiles)
    keystone =
        keystoneOf(image, [&](const ImageLevel& level) { return latticeOf(level).correlation; });
  if (keystone) {
    image = straightened(image, *keystone);
    found = latticeOf(image);
  }
  WholePeriods result;
  result.correlation = found.correlation;
  result.contrast = found.contrast;
  result.areSure = isSure(found);
  if (tiles || !result.areSure || isWhole(found))
    return result;
  const std::optional<Lattice> sides = repeated(found.cell, image.width, image.height);
  if (!sides)
    return result;
  TileCorners corners = placed(*sides, image);
  for (auto& corner : corners) {
    corner = {corner[0] / image.width, corner[1] / image.height};
    if (keystone)
      corner = seen(*keystone, corner[0], corner[1]);
    corner = {corner[0] * map.width, corner[1] * map.height};
  }
  result.part = corners;
  return result;
}

} // namespace lichen::placement
