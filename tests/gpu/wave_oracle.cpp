// SPDX-License-Identifier: MIT
// Solid local random phase, and multiple kernels on every mapping, on a device and in C++ against
// oracles in double precision that sum the cosines of all vertices, or the impacts of all cells,
// around a point. They share only the integer hashes with the code under test; other tests check
// those. (In the plane, tests/property/local_random_phase_oracle.cpp is the oracle.)
#include "baked_noises.h"
#include "device_noise.h"
#include "shared_device.h"

#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr double kAspect = double(kExemplarWidth) / kExemplarHeight;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Local random phase in space at points without a footprint: the windows of all vertices of seven
/// cells along each axis.
class SolidCosines {
public:
  explicit SolidCosines(const Bundle& bundle)
      : noise_(bundle.noises[0].as<LocalRandomPhaseNoise>()),
        texels_(cosineTexels(
            decodeLevel(bundle.tables[bundle.noises[0].maps[0].as<LocalRandomPhaseMap>().cosines],
                        0),
            CosineImageLayout(noise_))) {}

  /// The Gaussian value at a position in tiles, whose z is in widths.
  [[nodiscard]] Vec at(const Vec& tile, std::uint32_t seed) const {
    Vec value{0.5, 0.5, 0.5};
    std::size_t first = 0;
    for (std::size_t octave = 0; octave < noise_.cosines.size(); ++octave) {
      const std::size_t last = first + std::size_t(noise_.cosines[octave]);
      addOctave(value, tile, std::exp2(double(octave)), first, last,
                pcg(latticeSeed(seed, 4) + std::uint32_t(octave)));
      first = last;
    }
    return value;
  }

private:
  void addOctave(Vec& value, const Vec& tile, double scale, std::size_t first, std::size_t last,
                 std::uint32_t seed) const {
    const double across = scale * std::round(noise_.columns * 0.84) / 8.0;
    const double down = scale * std::round(noise_.rows * std::sqrt(0.75) * 0.84) / 8.0;
    const Vec cubes{tile[0] * across, tile[1] * down, tile[2] * across};
    // A vertex (i, j, k) lies where the body-centred cubic lattice turned to the diagonal has it.
    const double third = (cubes[0] + cubes[1] + cubes[2]) / 3.0;
    Vec sum{};
    double squares = 0.0;
    for (int n = 0; n < 7 * 7 * 7; ++n) {
      std::array<std::int64_t, 3> vertex{n % 7 - 3, n / 7 % 7 - 3, n / 49 - 3};
      for (std::size_t k = 0; k < 3; ++k)
        vertex[k] += std::int64_t(std::floor(cubes[k] + third));
      const double sixth = double(vertex[0] + vertex[1] + vertex[2]) / 6.0;
      Vec offset{};
      for (std::size_t k = 0; k < 3; ++k)
        offset[k] = cubes[k] - (double(vertex[k]) - sixth);
      const double window = std::pow(std::max(0.0, 1.0 - 2.0 * dot(offset, offset)), 3.0);
      squares += window * window;
      if (window > 0.0)
        addVertex(sum, window, {offset[0] / across, offset[1] / down, offset[2] / across}, first,
                  last,
                  vertexHash(std::uint32_t(vertex[0]), std::uint32_t(vertex[1]),
                             pcg(seed + std::uint32_t(vertex[2]))));
    }
    for (std::size_t c = 0; c < 3; ++c)
      value[c] += sum[c] / std::sqrt(squares);
  }

  /// The cosines of a vertex at an offset [tiles].
  void addVertex(Vec& sum, double window, const Vec& offset, std::size_t first, std::size_t last,
                 std::uint32_t state) const {
    const auto share = [](std::uint32_t bits) {
      return double(std::int32_t(bits)) / std::exp2(32.0);
    };
    std::uint32_t depth = state << 7;
    const std::size_t column = 1 + (state >> 27 & std::uint32_t(noise_.variants - 1));
    for (std::size_t k = first; k < last; ++k) {
      state = state * 747796405u + 2891336453u;
      const auto* row = &texels_[k / 2 * (1 + std::size_t(noise_.variants))];
      const CosineTexel &box = row[0][k % 2], &vector = row[column][k % 2];
      const double fx = double(box[0]) + double(box[2]) * share(state << 21);
      const double fy = double(box[1]) + double(box[3]) * share(state << 11);
      const double fz = 2.4 * std::hypot(fx, kAspect * fy) * share(depth);
      depth += 0x9E3779B9u;
      const double turns = dot({fx, fy, fz}, offset) + share(state) + double(vector[3]);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += window * double(vector[c]) * std::cos(kTurn * turns);
    }
  }

  const LocalRandomPhaseNoise noise_;
  const std::vector<std::array<CosineTexel, kRowCosines>> texels_;
};

/// Multiple kernels at points without a footprint: the impacts of all cells within reach.
class KernelReference {
public:
  explicit KernelReference(const Bundle& bundle)
      : noise_(bundle.noises[0].as<MultipleKernelsNoise>()),
        image_(bundle.tables[bundle.noises[0].maps[0].as<MultipleKernelsMap>().kernels]),
        rows_(kernelRows(image_, noise_)) {}

  /// The Gaussian value at a position in tiles, whose z is in widths; on a surface all are in
  /// widths. Only surfaces have a frame.
  [[nodiscard]] Vec at(Mapping mapping, const Vec& position, const SurfaceFrame& frame,
                       std::uint32_t seed) const {
    Vec value{0.5, 0.5, 0.5};
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const auto own = [&](std::uint32_t plane) {
        return pcg(latticeSeed(seed, plane) + std::uint32_t(k));
      };
      if (mapping == Mapping::surface)
        addSurface(value, k, position, frame, own(3));
      else if (mapping == Mapping::solid)
        addSpace(value, k, position, own(4));
      else
        addPlane(value, k, position, own(0));
    }
    for (const PatternCosine& cosine : patternCosines(image_, noise_)) {
      const double angle = kTurn * (double(cosine.frequency[0]) * position[0] +
                                    double(cosine.frequency[1]) * position[1]);
      for (std::size_t c = 0; c < 3; ++c)
        value[c] += double(cosine.waves[c][0]) * std::cos(angle) +
                    double(cosine.waves[c][1]) * std::sin(angle);
    }
    return value;
  }

private:
  using Cell = std::array<std::uint32_t, 3>;

  /// A kernel's frequency at an impact: rings turn it by an angle of the cell.
  [[nodiscard]] std::array<double, 2> frequencyOf(std::size_t k, const Cell& cell,
                                                  std::uint32_t own) const {
    const std::array<double, 2> f{double(rows_[k].frequency[0]), double(rows_[k].frequency[1])};
    if (int(k) < noise_.kernels - noise_.rings)
      return f;
    const std::uint32_t turn =
        cell[0] * 0xC13FA9A9u + cell[1] * 0x91E10DA5u + cell[2] * 0xABC98389u + own;
    const double angle = kTurn * double(turn) / std::exp2(32.0);
    return {f[0] * std::cos(angle), f[0] * std::sin(angle)};
  }

  /// Bits 0 to 3 are the signs of the four waves, and bit 4 the sign of their phase.
  void addWaves(Vec& value, std::size_t k, double window, double turns, std::uint32_t bits) const {
    const auto signOf = [&](std::size_t bit) { return (bits >> bit & 1u) != 0 ? -1.0 : 1.0; };
    const double wave = window * std::sqrt(2.0) * std::cos(kTurn * (turns - signOf(4) / 8.0));
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t w = 0; w < 4; ++w)
        value[c] += double(rows_[k].colors[c][w]) * signOf(w) * wave;
  }

  /// What the squared offset within a window leaves of 1, where p and q are the window's axes.
  [[nodiscard]] double leftOf(std::size_t k, double dx, double dy, double wider = 1.0,
                              double r = 0.0) const {
    const auto& q = rows_[k].toWindow;
    const double along = double(q[0]) * dx + double(q[1]) * dy;
    const double across = double(q[2]) * dx + double(q[3]) * dy;
    return std::max(0.0, 1.0 - (along * along + across * across + r * r) / (wider * wider));
  }

  /// Calls add(cell, offsetOf) for all cells within reach along the first axes; offsetOf(jitter) is
  /// the position less an impact's, so far [cells] within the cell, in tiles.
  template <class Add>
  static void forCells(const Vec& position, const Vec& cellsPerTile, std::size_t axes, int reach,
                       const Add& add) {
    const int across = 2 * reach + 1, layers = axes == 3 ? across : 1;
    for (int n = 0; n < across * across * layers; ++n) {
      Vec corner{double(n % across), double(n / across % across), double(n / across / across)};
      Cell cell{};
      for (std::size_t k = 0; k < axes; ++k) {
        corner[k] += std::floor(position[k] * cellsPerTile[k]) - reach;
        cell[k] = std::uint32_t(std::int64_t(corner[k]));
      }
      add(cell, [&](const Vec& jitter) {
        Vec offset{};
        for (std::size_t k = 0; k < axes; ++k)
          offset[k] = position[k] - (corner[k] + jitter[k]) / cellsPerTile[k];
        return offset;
      });
    }
  }
  static double jitter(std::uint32_t bits, int count) {
    return (double(bits & ((1u << count) - 1u)) + 0.5) / std::exp2(double(count));
  }

  void addPlane(Vec& value, std::size_t k, const Vec& tile, std::uint32_t own) const {
    const KernelRow& row = rows_[k];
    forCells(tile, {row.columns / 8.0, row.rows / 8.0, 0.0}, 2, 30,
             [&](const Cell& cell, const auto& offsetOf) {
               const std::uint32_t word = vertexHash(cell[0], cell[1], own);
               const Vec d = offsetOf({jitter(word >> 21, 11), jitter(word >> 10, 11), 0.0});
               const double window = double(row.amplitude) * std::pow(leftOf(k, d[0], d[1]), 3.0);
               const auto [fx, fy] = frequencyOf(k, cell, own);
               if (window > 0.0)
                 addWaves(value, k, window, dot({fx, fy, 0.0}, d), word);
             });
  }

  void addSpace(Vec& value, std::size_t k, const Vec& tile, std::uint32_t own) const {
    const KernelRow& row = rows_[k];
    // Planes of the window in space, 15 / 14 times as wide, have the spread of that in the plane.
    // Integrals of squared windows (1 - r^2)^3: pi / 7 in the plane, and in space
    // 2 pi B(3 / 2, 7).
    const double wider = std::sqrt(15.0 / 14.0);
    const double amplitude =
        double(row.amplitude) / std::sqrt(row.layers / 8.0 * 14.0 * std::beta(1.5, 7.0) *
                                          std::pow(wider, 3.0) / double(row.toWindowZ));
    forCells(tile, {row.columns / 8.0, row.rows / 8.0, row.layers / 8.0}, 3, 20,
             [&](const Cell& cell, const auto& offsetOf) {
               const std::uint32_t word = vertexHash(cell[0], cell[1], pcg(own + cell[2]));
               const std::uint32_t other = pcg(~word);
               const Vec d = offsetOf(
                   {jitter(word >> 21, 11), jitter(word >> 10, 11), jitter(other >> 16, 16)});
               const double left = leftOf(k, d[0], d[1], wider, double(row.toWindowZ) * d[2]);
               if (left == 0.0)
                 return;
               const auto [fx, fy] = frequencyOf(k, cell, own);
               const double fz = 1.2 * std::hypot(fx, kAspect * fy) *
                                 double(std::int16_t(other & 0xFFFFu)) / 32768.0;
               addWaves(value, k, amplitude * std::pow(left, 3.0), dot({fx, fy, fz}, d), word);
             });
  }

  void addSurface(Vec& value, std::size_t k, const Vec& position, const SurfaceFrame& frame,
                  std::uint32_t own) const {
    const double cubes = rows_[k].cubes / 8.0;
    const auto& q = rows_[k].toWindow;
    const double determinant = double(q[0]) * double(q[3]) - double(q[1]) * double(q[2]);
    const double area = std::numbers::pi / (std::abs(determinant) * kAspect);
    const double thickness = std::sqrt(area);
    // The integral of the squared window (1 - r^2)^3 over the disk is 1 / 7 of the area.
    const double amplitude = std::sqrt(3.0 * 7.0 / (cubes * cubes * cubes * thickness * area));
    forCells(position, {cubes, cubes, cubes}, 3, 8, [&](const Cell& cell, const auto& offsetOf) {
      const std::uint32_t word = pcg(pcg3d({cell[0], cell[1], own})[0] + cell[2]);
      const Vec d =
          offsetOf({jitter(word >> 21, 10), jitter(word >> 11, 10), jitter(word >> 1, 10)});
      const double weight = 1.0 - 2.0 * std::abs(dot(d, frame.outward)) / thickness;
      const double x = dot(d, frame.right), y = kAspect * dot(d, frame.down);
      const double window = amplitude * std::max(0.0, weight) * std::pow(leftOf(k, x, y), 3.0);
      const auto [fx, fy] = frequencyOf(k, cell, own);
      if (window > 0.0)
        addWaves(value, k, (word >> 31) != 0 ? -window : window, fx * x + fy * y, pcg(~word));
    });
  }

  const MultipleKernelsNoise noise_;
  const Table image_;
  const std::vector<KernelRow> rows_;
};

/// The largest difference from `expectedAt(position, frame, seed)` on the device and in C++, at
/// points without a footprint and from several tile origins. Positions are in tiles of the plane
/// and of solids, and on surfaces in metres.
template <class ExpectedAt>
double largestError(DeviceNoise& noise, Mapping mapping, std::size_t count, ExpectedAt expectedAt) {
  double largest = 0.0;
  std::vector<SamplePoint> points = samplePoints(count);
  for (SamplePoint& point : points) {
    point.plane.gradientX = point.plane.gradientY = {};
    point.dx = point.dy = {};
  }
  for (const std::int64_t origin : {0, 21, -8}) {
    MaterialUse use = noise.host.use();
    use.parameters.rotation = mapping == Mapping::surface ? 0.4 : 0.0;
    use.parameters.seed = 7;
    // Whole tiles of the exemplar, whose aspect is 4 / 3.
    std::ranges::copy(std::array{origin, 3 * origin, -origin}, use.placement.tileOrigin);
    const auto values = noise.drawn(kGaussian, use, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& p = points[k].position;
      Vec position{double(p[0]), double(p[1]), double(p[2])};
      if (mapping == Mapping::uv)
        position = {double(points[k].plane.uv[0]), double(points[k].plane.uv[1]), 0.0};
      for (std::size_t axis = 0; axis < 3; ++axis)
        position[axis] += double(use.placement.tileOrigin[axis]);
      if (mapping == Mapping::solid)
        position[1] *= -kAspect;
      const Vec expected =
          expectedAt(position, frameOf(points[k], use.parameters.rotation), use.parameters.seed);
      const auto computed = noise.gaussian(points[k]).value;
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max({largest, std::abs(double(values[k][c]) - expected[c]),
                            std::abs(double(computed[c]) - expected[c])});
    }
  }
  return largest;
}

} // namespace

TEST_CASE(
    "solid local random phase is the sum of the cosines of all vertices under their windows") {
  DeviceNoise noise(baked({Method::localRandomPhase}), Mapping::solid);
  const SolidCosines reference(noise.bundle);
  // The polynomial of the cosine is within 1.1e-4 of it, and 24 cosines of four vertices have
  // amplitudes of 0.05 on average; the rest are roundings of the position.
  CHECK(largestError(noise, Mapping::solid, 200,
                     [&](const Vec& position, const SurfaceFrame&, std::uint32_t seed) {
                       return reference.at(position, seed);
                     }) < 6e-4);
}

TEST_CASE("multiple-kernels noise is the sum of its kernels over the impacts of all cells") {
  for (const auto& [mapping, count, tolerance] :
       {std::tuple{Mapping::uv, 60u, 2e-3},
        {Mapping::solid, 20u, 2e-3},
        // Places of 8 tiles are rounded to 2^-21 tiles, waves of 30 cycles to 1e-4 turns.
        {Mapping::surface, 30u, 1e-3}})
    for (const int rings : {0, 2}) {
      DeviceNoise noise(baked({.method = Method::multipleKernels,
                               .rings = rings,
                               .patternCosines = mapping == Mapping::uv ? 4 : 0}),
                        mapping);
      const KernelReference reference(noise.bundle);
      INFO(nameOf(mapping) << ", rings " << rings);
      CHECK(largestError(noise, mapping, count,
                         [&](const Vec& position, const SurfaceFrame& frame, std::uint32_t seed) {
                           return reference.at(mapping, position, frame, seed);
                         }) < tolerance);
    }
}
