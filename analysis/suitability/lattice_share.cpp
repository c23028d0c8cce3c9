// SPDX-License-Identifier: MIT
// Spectrum of a plane (height, width / 2 + 1) -> share of its variance in spectral lines.
#include "lattice_share.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lichen::suitability {
namespace {

/// Neighbours on each side that enter the median. With a lattice line at every fourth frequency,
/// each spread over its four neighbours, the 9 x 9 frequencies around a line hold nine lines. Four
/// of them are cut at one side and four at two: 5 + 4 * 4 + 4 * 3 = 33 of 81 frequencies. This is
/// less than half, so the median is the power between the lines.
constexpr int kReach = 4;
constexpr int kNeighbours = (2 * kReach + 1) * (2 * kReach + 1);
constexpr float kLineOverMedian = 20.0f; // derived in the header
constexpr int kReachAlong = 8;           // frequencies on each side along the direction
/// Keeps the mean, whose power has no meaning here, out of the neighbours.
constexpr int kLowestCycles = kReach + 1;
/// Half of it is the highest frequency. Along each axis, the eight frequencies from kLowestCycles
/// to kReach below the highest have all their neighbours, and no neighbour is its own mirror image.
constexpr int kSmallestSide = 32;
static_assert(kSmallestSide / 2 - kReach - kLowestCycles + 1 == 8);

/// Power at the integer frequencies of the full plane, and of some beyond each border of the half
/// spectrum.
class PowerPlane {
public:
  explicit PowerPlane(const HalfSpectrum& spectrum)
      : width_(spectrum.width), height_(spectrum.height), columns_(spectrum.columns()) {
    power_.reserve(spectrum.values.size());
    for (const std::complex<float>& value : spectrum.values)
      power_.push_back(std::norm(value));
  }
  [[nodiscard]] bool contains(int u, int v) const {
    return 2 * std::abs(u) <= width_ && 2 * std::abs(v) <= height_;
  }
  [[nodiscard]] float at(int u, int v) const {
    v += v < 0 ? height_ : v >= height_ ? -height_ : 0;
    // A frequency outside the stored half is the mirror image of one inside.
    if (u < 0 || u >= columns_) {
      u = u < 0 ? -u : width_ - u;
      v = v == 0 ? 0 : height_ - v;
    }
    return power_[std::size_t(v) * std::size_t(columns_) + std::size_t(u)];
  }

private:
  int width_;
  int height_;
  int columns_;
  std::vector<float> power_;
};

/// Whether the power exceeds the given multiple of the median around it: whether most powers there
/// are smaller by that factor.
bool isLine(const PowerPlane& power, int u, int v) {
  const float most = power.at(u, v) / kLineOverMedian;
  int below = 0;
  for (int dv = -kReach; dv <= kReach; ++dv)
    for (int du = -kReach; du <= kReach; ++du)
      below += power.at(u + du, v + dv) < most ? 1 : 0;
  return 2 * below > kNeighbours;
}

/// Whether the power also stands out among the powers of its own direction, on both sides of it: it
/// exceeds three eighths of the frequencies on either side by the same factor. Streaks that are
/// longer than the image have all their power in one direction, where no frequency stands out from
/// the others; stripes have few frequencies of it.
bool isLineOfItsDirection(const PowerPlane& power, int u, int v) {
  const float most = power.at(u, v) / kLineOverMedian;
  const double radius = std::hypot(double(u), double(v));
  const auto quietSide = [&](double step) {
    int below = 0;
    for (int k = 1; k <= kReachAlong; ++k) {
      const double scale = (radius + step * k) / radius;
      const int across = int(std::lround(scale * u)), down = int(std::lround(scale * v));
      // The mean has no meaning, and there is nothing beyond the highest frequency.
      below +=
          scale * radius < 1.0 || !power.contains(across, down) || power.at(across, down) < most
              ? 1
              : 0;
    }
    return 8 * below >= 3 * kReachAlong;
  };
  return quietSide(-1.0) && quietSide(1.0);
}

} // namespace

double latticeShare(const HalfSpectrum& spectrum) {
  if (std::min(spectrum.width, spectrum.height) < kSmallestSide)
    return 0.0;
  const PowerPlane power(spectrum);
  std::vector<std::array<double, 2>> rows(std::size_t(spectrum.height)); // in lines, and in total
  tbb::parallel_for(0, spectrum.height, [&](int v) {
    const int signedV = spectrum.signedRow(v);
    auto& [lines, all] = rows[std::size_t(v)];
    for (int u = 0; u < spectrum.columns(); ++u) {
      if (u == 0 && v == 0)
        continue;
      const double weighted = spectrum.multiplicity(u) * double(power.at(u, v));
      all += weighted;
      if (u * u + signedV * signedV >= kLowestCycles * kLowestCycles && isLine(power, u, v) &&
          isLineOfItsDirection(power, u, signedV))
        lines += weighted;
    }
  });
  double lines = 0.0, all = 0.0;
  for (const auto& row : rows) {
    lines += row[0];
    all += row[1];
  }
  return all > 0.0 ? lines / all : 0.0;
}

} // namespace lichen::suitability
