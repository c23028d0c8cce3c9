// SPDX-License-Identifier: MIT
// The triangle around a point, by what barycentric coordinates and periods are.
#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sampling/lattice_vertices.h>
#include <vector>

using namespace lichen;

namespace {

using TilePosition = std::array<float, 2>;

shader::LichenMaterial materialWith(const Lattice& lattice) {
  shader::LichenMaterial material{};
  material.columnsPerTile = float(lattice.columnsPerTile);
  material.rowsPerTile = float(lattice.rowsPerTile);
  material.periodColumns = lattice.periodColumns;
  material.periodRows = lattice.periodRows;
  material.periodTilesX = float(lattice.periodColumns / lattice.columnsPerTile);
  material.periodTilesY = float(lattice.periodRows / lattice.rowsPerTile);
  return material;
}

/// lattice.h: vertex (i, j) is at x = (i + j / 2) / columnsPerTile, y = j / rowsPerTile.
std::array<double, 2> vertexPosition(const Lattice& lattice, double i, double j) {
  return {(i + 0.5 * j) / lattice.columnsPerTile, j / lattice.rowsPerTile};
}

std::vector<TilePosition> tilePositions() {
  std::mt19937 generator(17);
  std::uniform_real_distribution<float> uniform(-20.0f, 20.0f);
  std::vector<TilePosition> positions{{0.0f, 0.0f}, {1.0f, 0.5f}, {-2.0f, -0.25f}}; // at vertices
  for (int k = 0; k < 500; ++k)
    positions.push_back({uniform(generator), uniform(generator)});
  return positions;
}

constexpr Grain kVertexGrains[] = {Grain::none, Grain::x, Grain::y};
constexpr double kRounding = 2e-5; // of positions of up to 160 cells, in floats

} // namespace

TEST_CASE("the vertices around a point are neighbours, and their weights average them to it") {
  for (const Grain grain : kVertexGrains) {
    const Lattice lattice = infiniteLattice(grain);
    const shader::LichenMaterial material = materialWith(lattice);
    for (const TilePosition& position : tilePositions()) {
      const auto vertices = latticeVertices(material, position);
      INFO("grain " << int(grain) << ", " << position[0] << ", " << position[1]);
      double sum = 0.0;
      std::array<double, 2> mean{};
      for (const LatticeVertex& vertex : vertices) {
        const double i = double(std::int32_t(vertex.i)), j = double(std::int32_t(vertex.j));
        const std::array<double, 2> at = vertexPosition(lattice, i, j);
        CHECK(double(vertex.weight) > -kRounding);
        CHECK(vertex.period == std::array{0.0f, 0.0f});
        sum += double(vertex.weight);
        for (std::size_t axis = 0; axis < 2; ++axis)
          mean[axis] += double(vertex.weight) * at[axis];
        // From the vertex to the point, in cells along both skewed axes.
        const std::array<double, 2> to =
            vertexPosition(lattice, double(vertex.cells[0]), double(vertex.cells[1]));
        CHECK(std::abs(at[0] + to[0] - double(position[0])) < kRounding);
        CHECK(std::abs(at[1] + to[1] - double(position[1])) < kRounding);
      }
      CHECK(std::abs(sum - 1.0) < kRounding);
      CHECK(std::abs(mean[0] - double(position[0])) < kRounding);
      CHECK(std::abs(mean[1] - double(position[1])) < kRounding);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < a; ++b) {
          const auto di = std::int32_t(vertices[a].i - vertices[b].i);
          const auto dj = std::int32_t(vertices[a].j - vertices[b].j);
          CHECK(di * di + di * dj + dj * dj == 1); // a side of a triangle, in skewed coordinates
        }
    }
  }
}

TEST_CASE("the cell of the tile origin is added to vertices modulo 2^32") {
  const Lattice lattice = infiniteLattice(Grain::none);
  shader::LichenMaterial material = materialWith(lattice);
  for (const TilePosition& position : tilePositions()) {
    material.cellI = material.cellJ = 0;
    const auto here = latticeVertices(material, position);
    material.cellI = std::numeric_limits<std::int32_t>::max();
    material.cellJ = -7;
    const auto there = latticeVertices(material, position);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(there[k].i == here[k].i + 0x7fffffffu);
      CHECK(there[k].j == here[k].j - 7u);
      CHECK(there[k].weight == here[k].weight);
      CHECK(there[k].cells == here[k].cells);
    }
  }
}

TEST_CASE("vertices of a periodic lattice lie in one period, whole periods from where they are") {
  for (const double side : {1.0, 1.37, 4.0})
    for (const Grain grain : kVertexGrains) {
      const Lattice lattice = periodicLattice(side, side, grain);
      const shader::LichenMaterial material = materialWith(lattice);
      shader::LichenMaterial endless = material;
      endless.periodColumns = endless.periodRows = 0;
      for (const TilePosition& position : tilePositions()) {
        const auto vertices = latticeVertices(material, position);
        const auto unreduced = latticeVertices(endless, position);
        INFO("side " << side << ", grain " << int(grain) << ", " << position[0] << ", "
                     << position[1]);
        for (std::size_t k = 0; k < 3; ++k) {
          const LatticeVertex& vertex = vertices[k];
          CHECK(vertex.i < std::uint32_t(lattice.periodColumns));
          CHECK(vertex.j < std::uint32_t(lattice.periodRows));
          CHECK(vertex.weight == unreduced[k].weight);
          CHECK(vertex.cells == unreduced[k].cells);
          const auto within = vertexPosition(lattice, double(vertex.i), double(vertex.j));
          const auto at = vertexPosition(lattice, double(std::int32_t(unreduced[k].i)),
                                         double(std::int32_t(unreduced[k].j)));
          const std::array<double, 2> length{lattice.periodColumns / lattice.columnsPerTile,
                                             lattice.periodRows / lattice.rowsPerTile};
          for (std::size_t axis = 0; axis < 2; ++axis) {
            CHECK(std::abs(within[axis] + double(vertex.period[axis]) - at[axis]) < kRounding);
            const double periods = double(vertex.period[axis]) / length[axis];
            CHECK(std::abs(periods - std::round(periods)) < kRounding);
          }
        }
      }
    }
}
