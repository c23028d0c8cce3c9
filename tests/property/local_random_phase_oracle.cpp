// SPDX-License-Identifier: MIT
// Local random-phase noise against an oracle in double precision: steps 1 to 6 of
// docs/gltf_extension/README.md, "Local random-phase noise", over all vertices near a point.
#include "bundle_of.h"
#include "example_exemplar.h"
#include "gaussian_reader.h"
#include "oracle_footprints.h"

#include <lichen/lattice.h>
#include <lichen/local_random_phase.h>
#include <lichen/structure_texel.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::test;

namespace {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

std::int64_t modulo(std::int64_t value, std::int64_t by) { return (value % by + by) % by; }
double signedShare(std::uint32_t bits) { return double(std::int32_t(bits)) / std::exp2(32.0); }

/// C(t) of step 4.
double cosineOf(double turns) {
  const double z = 0.25 - std::abs(turns - std::round(turns));
  return z * (6.2812805 + z * z * (-41.0952 + 73.5855 * z * z));
}

class CosinesOracle {
public:
  CosinesOracle(const Bundle& bundle, const MaterialNoise& material, const Placement& placement)
      : shared_(bundle.noises[0].as<LocalRandomPhaseNoise>()),
        map_(bundle.noises[0].maps[0].as<LocalRandomPhaseMap>()), layout_(shared_),
        image_(decodeLevel(bundle.tables[map_.cosines], 0)), texels_(cosineTexels(image_, layout_)),
        material_(material), placement_(placement),
        cells_(shared_.columns / 8.0, shared_.rows / 8.0),
        period_(placement.periodTilesX, placement.periodTilesY),
        isGuided_(shared_.structure.offsets > 0 &&
                  (period_.array() == period_.array().floor()).all()) {
    if (!placement.periodic)
      return;
    const auto inPeriod = [&] {
      return Vec2(std::exp2(firstOctave_) * cells_.cwiseProduct(period_));
    };
    while (firstOctave_ < 11 && (inPeriod()[0] < 3.0 || inPeriod()[1] < 4.0))
      ++firstOctave_;
    periodColumns_ = std::max<std::int64_t>(3, std::llround(inPeriod()[0]));
    periodRows_ = 2 * std::max<std::int64_t>(2, std::llround(inPeriod()[1] / 2.0));
    cells_ = Vec2(double(periodColumns_), double(periodRows_)).cwiseQuotient(period_);
  }

  /// As GaussianReader::at().
  [[nodiscard]] GaussianReading at(const TileFootprint& at) const {
    const Vec2 p(double(placement_.tileOriginX) + material_.offset[0] + double(at.position[0]),
                 double(placement_.tileOriginY) + material_.offset[1] + double(at.position[1]));
    Sum sum;
    std::size_t cosine = 0;
    for (std::size_t octave = 0; octave < shared_.cosines.size(); ++octave)
      addOctave(sum, p, at, int(octave), cosine);
    if (shared_.structure.columns > 0)
      addStructure(sum, p, at);
    const double squaredContrast = material_.contrast * material_.contrast;
    return {6.0 * material_.contrast * sum.gaussian,
            Vec3::Constant(squaredContrast * sum.lost / sum.squares)};
  }

private:
  struct Sum {
    Vec3 gaussian{0.0, 0.0, 0.0};
    double squares = 0.0, lost = 0.0;
  };
  struct Vertex {
    std::uint32_t i, j; ///< in the period, if there is one
    Vec2 d;             ///< from the vertex to the point [tiles]
    double window;
    std::uint32_t state;
    std::size_t column; ///< of the image, for cosines
  };

  [[nodiscard]] int finerOctaves(int octave) const { return std::max(0, octave - firstOctave_); }

  [[nodiscard]] std::vector<Vertex> verticesAt(const Vec2& p, int octave, int seedOctave) const {
    const Vec2 cells = std::exp2(finerOctaves(octave)) * cells_;
    const auto nearJ = std::llround(p[1] * cells[1]);
    const auto nearI = std::llround(p[0] * cells[0] - double(nearJ) / 2.0);
    std::vector<Vertex> vertices;
    double squares = 0.0;
    for (std::int64_t row = nearJ - 3; row <= nearJ + 3; ++row)
      for (std::int64_t column = nearI - 3; column <= nearI + 3; ++column) {
        const Vec2 d =
            p - Vec2(double(column) + double(row) / 2.0, double(row)).cwiseQuotient(cells);
        // The triangles are equilateral on a plane of unit edges.
        const double square =
            std::pow(d[0] * cells[0], 2.0) + 0.75 * std::pow(d[1] * cells[1], 2.0);
        const double window = std::pow(std::max(0.0, 1.0 - square / 0.75), 3.0);
        if (window == 0.0)
          continue;
        squares += window * window;
        std::int64_t i = column, j = row;
        if (placement_.periodic) {
          const std::int64_t finer = 1LL << finerOctaves(octave);
          j = modulo(row, finer * periodRows_);
          i = modulo(column + (row - j) / 2, finer * periodColumns_);
        }
        const std::uint32_t seed = pcg(latticeSeed(material_.seed, 0) + std::uint32_t(seedOctave));
        const std::uint32_t state = vertexHash(std::uint32_t(i), std::uint32_t(j), seed);
        vertices.push_back({std::uint32_t(i), std::uint32_t(j), d, window, state,
                            1 + (state >> 27 & unsigned(shared_.variants - 1))});
      }
    for (Vertex& vertex : vertices)
      vertex.window /= std::sqrt(squares);
    return vertices;
  }

  /// Steps 1 to 5.
  void addOctave(Sum& sum, const Vec2& p, const TileFootprint& at, int octave,
                 std::size_t& cosine) const {
    const double W = shared_.texelsPerTileX, H = shared_.texelsPerTileY;
    const Vec2 X = W * Vec2(double(at.dx[0]), double(at.dy[0]));
    const Vec2 Y = H * Vec2(double(at.dx[1]), double(at.dy[1]));
    const double m = (X.squaredNorm() + Y.squaredNorm()) / 2.0;
    const double h = (X.squaredNorm() - Y.squaredNorm()) / 2.0, c = X.dot(Y), e = std::hypot(h, c);
    const auto b = [](double l) { return std::max(l, 1.0) - std::pow(std::max(l, 1.0), -3.0); };
    const double u = (b(m + e) + b(m - e)) / 2.0;
    const double w = (b(m + e) - b(m - e)) / (2.0 * std::max(e, 1e-20));
    const Vec2 perTexel = std::exp2(finerOctaves(octave)) * cells_.cwiseQuotient(Vec2(W, H));
    std::vector<Vertex> vertices = verticesAt(p, octave, octave);
    const std::size_t end = cosine + std::size_t(shared_.cosines[std::size_t(octave)]);
    for (; cosine < end; ++cosine)
      for (Vertex& vertex : vertices) {
        const auto* const row = &texels_[cosine / 2 * (1 + std::size_t(shared_.variants))];
        const auto& [middleX, middleY, width, height] = row[0][cosine % 2];
        const auto& vector = row[vertex.column][cosine % 2];
        std::uint32_t& state = vertex.state;
        state = state * 747796405u + 2891336453u;
        const Vec2 F(double(middleX) + double(width) * signedShare(state << 21),
                     double(middleY) + double(height) * signedShare(state << 11));
        const double x = F[0] / W, y = F[1] / H;
        const double q = (u + w * h) * (x * x + 0.1733 * std::pow(perTexel[0], 2.0)) +
                         (u - w * h) * (y * y + 0.75 * 0.1733 * std::pow(perTexel[1], 2.0)) +
                         2.0 * w * c * x * y;
        const double cycles = std::numbers::pi * std::numbers::pi / 18.0 * q;
        const double r = std::pow(std::clamp(1.0 - cycles, 0.0, 1.0), 3.0);
        const double t = F.dot(vertex.d) + signedShare(state) + double(vector[3]);
        const Vec3 A =
            vertex.window * Vec3(double(vector[0]), double(vector[1]), double(vector[2]));
        sum.gaussian += r * cosineOf(t) * A;
        sum.squares += A.squaredNorm();
        sum.lost += (1.0 - r * r) * A.squaredNorm();
      }
  }

  /// The B-splines of a level, summed at a place [tiles].
  [[nodiscard]] Vec3 splineAt(bool isMean, int level, const Vec2& place) const {
    const auto spline = [](double x) {
      x = std::abs(x);
      return x < 1.0 ? 2.0 / 3.0 - x * x + x * x * x / 2.0
                     : std::pow(std::max(0.0, 2.0 - x), 3.0) / 6.0;
    };
    const std::int64_t columns = shared_.structure.columns >> level;
    const std::int64_t rows = shared_.structure.rows >> level;
    const double x = place[0] * double(columns) - 0.5, y = place[1] * double(rows) - 0.5;
    Vec3 sum = Vec3::Zero();
    for (std::int64_t j = std::llround(y) - 3; j <= std::llround(y) + 3; ++j)
      for (std::int64_t i = std::llround(x) - 3; i <= std::llround(x) + 3; ++i) {
        const auto column = std::size_t(modulo(i, columns)), row = std::size_t(modulo(j, rows));
        const auto corner = layout_.levelCorner(level);
        const std::size_t texel = (corner[1] + row / 2) * layout_.width + corner[0] +
                                  (isMean ? layout_.meanColumn : 0) + column / 2;
        const auto integers = fromStructureTexel(image_[4 * texel + 2 * (row % 2) + column % 2]);
        for (std::size_t c = 0; c < 3; ++c)
          sum[Eigen::Index(c)] += spline(x - double(i)) * spline(y - double(j)) * integers[c] /
                                  511.0 * map_.structureAmplitudes[c];
      }
    return sum;
  }

  /// Step 6.
  void addStructure(Sum& sum, const Vec2& p, const TileFootprint& at) const {
    const CosineStructure& structure = shared_.structure;
    const Vec2 size(structure.columns, structure.rows);
    const Vec2 X = size.cwiseProduct(Vec2(double(at.dx[0]), double(at.dx[1])));
    const Vec2 Y = size.cwiseProduct(Vec2(double(at.dy[0]), double(at.dy[1])));
    const double M = std::max({1.0, X.squaredNorm(), Y.squaredNorm()});
    const double A = std::abs(X[0] * Y[1] - X[1] * Y[0]), L = std::log2(size.minCoeff());
    const double l = std::min(L, std::log2(M * std::max({A, std::sqrt(M), M / 16.0})) / 4.0);
    // Calls act(level, share) for the levels that the footprint takes.
    const auto forLevels = [&](const auto& act) {
      for (int k = int(l); k < std::min(int(l) + 2, int(L)); ++k)
        act(k, 1.0 - std::abs(l - k));
    };
    const std::vector<Vertex> vertices = verticesAt(p, 2, 12);
    Vec2 t = Vec2::Zero();
    double windows = 0.0;
    for (const Vertex& vertex : vertices) {
      const std::uint32_t next = vertex.state * 747796405u + 2891336453u;
      t += vertex.window * Vec2(signedShare(next << 11), signedShare(next));
      windows += vertex.window;
    }
    t *= std::round(structure.turbulence * 65535.0) / 65535.0 * std::sqrt(12.0);
    const auto add = [&](bool isMean, const Vec2& place, double weight) {
      forLevels([&](int level, double share) {
        sum.gaussian += weight * share * splineAt(isMean, level, place + t);
      });
    };
    for (const Vertex& vertex : vertices) {
      const std::uint32_t low = vertex.state & 0xFFFFu, high = vertex.state >> 16;
      if (!isGuided_) {
        add(false, vertex.d + Vec2(low, high) / 65536.0, vertex.window);
        continue;
      }
      const std::uint32_t c = (vertex.i - vertex.j + 0x80000000u) % 3u;
      const std::uint32_t n = (std::uint32_t(structure.offsets) - c + 2u) / 3u;
      const float* const offset =
          &image_[4 * layout_.offsetRow * layout_.width + 2 * (3 * (high * n >> 16) + c)];
      add(false, p + Vec2(double(offset[0]), double(offset[1])), vertex.window);
    }
    if (isGuided_)
      add(true, p, 1.0 - windows);
    const auto deviationOf = [&](int level) {
      return std::round(255.0 * map_.structureDeviations[std::size_t(level)]) / 255.0;
    };
    double left = 0.0;
    forLevels([&](int level, double share) { left += share * deviationOf(level); });
    const double whole = deviationOf(0), D = map_.dimensions;
    sum.squares += D * whole * whole / 18.0;
    sum.lost += D * (whole * whole - left * left) / 18.0;
  }

  const LocalRandomPhaseNoise shared_;
  const LocalRandomPhaseMap map_;
  const CosineImageLayout layout_;
  const std::vector<float> image_;
  const std::vector<std::array<CosineTexel, kRowCosines>> texels_;
  const MaterialNoise material_;
  const Placement placement_;
  Vec2 cells_; ///< columns and rows in a tile, of the first octave with a lattice of its own
  const Vec2 period_;
  int firstOctave_ = 0;
  std::int64_t periodColumns_ = 0, periodRows_ = 0;
  const bool isGuided_;
};

} // namespace

TEST_CASE("cosines and tiles of a structure match an oracle in double precision, at any level, "
          "origin and period") {
  const MapExemplar map = threeMaterials(64, 48, 5);
  MaterialNoise material;
  material.seed = 77;
  material.contrast = 1.3;
  material.offset = {0.25, -7.5};
  const std::vector<Placement> placements{
      {},
      {.tileOriginX = -(std::int64_t(1) << 30) + 21, .tileOriginY = 1000001},
      {.periodic = true, .periodTilesX = 2.0, .periodTilesY = 3.0},
      {.periodic = true, .periodTilesX = 1.375, .periodTilesY = 0.75}};
  for (const auto& [structure, guide] : {std::pair(0.0, 0.0), {0.6, 0.0}, {0.6, 1.0}}) {
    LocalRandomPhaseOptions options;
    options.bits = 16;
    options.cosines = 24;
    options.structure = structure;
    options.guide = guide;
    options.turbulence = 0.05;
    const Bundle bundle = bundleOf(bakeLocalRandomPhase("noise", {&map, 1}, options));
    REQUIRE((bundle.noises[0].as<LocalRandomPhaseNoise>().structure.offsets > 0) == (guide > 0.0));
    for (const Placement& placement : placements) {
      const GaussianReader reader(bundle, material, placement);
      const CosinesOracle oracle(bundle, material, placement);
      double most = 0.0, mostLost = 0.0;
      for (const TriplanarFootprint& at : oracleFootprints(150)) {
        const GaussianReading found = reader.at(onTiles(at)), expected = oracle.at(onTiles(at));
        most = std::max(most, (found.z - expected.z).cwiseAbs().maxCoeff());
        mostLost = std::max(mostLost, (found.lost - expected.lost).cwiseAbs().maxCoeff());
      }
      INFO("structure " << structure << ", guide " << guide << ", origin " << placement.tileOriginX
                        << ", period " << placement.periodTilesX);
      // Positions below 16 tiles are off by up to 2^-21 of a tile, and z has slopes below 300 a
      // tile, five deviations of waves of up to 10 cycles. Footprints are rounded by a few 2^-24.
      CHECK(most < 2e-4);
      CHECK(mostLost < 2e-5);
    }
  }
}
