// SPDX-License-Identifier: MIT
// Tables of fewer cells against the table that they are fitted to, and against a least-squares
// solve over all cells at once.
#include "baked_exemplar.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <gaussian/prefilter.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

namespace {

/// Gaussian values of this amplitude on a grid of quantiles over all axes.
std::vector<std::array<double, 3>> gaussianGrid(int dimensions, double amplitude, int side) {
  std::vector<std::array<double, 3>> values;
  const auto count = std::size_t(std::lround(std::pow(side, dimensions)));
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, 3> value{0.5, 0.5, 0.5};
    std::size_t rest = k;
    for (int axis = 0; axis < dimensions; ++axis, rest /= std::size_t(side))
      value[std::size_t(axis)] +=
          amplitude *
          (gaussian::gaussianQuantile((double(rest % std::size_t(side)) + 0.5) / side) - 0.5);
    values.push_back(value);
  }
  return values;
}

InverseTable filledTable(int dimensions, int side, const auto& valueOf) {
  InverseTable table{dimensions, side, 1, {}};
  const auto cells = std::size_t(std::lround(std::pow(side, dimensions)));
  for (std::size_t cell = 0; cell < cells; ++cell) {
    std::array<double, 3> u{};
    std::size_t rest = cell;
    for (int axis = 0; axis < dimensions; ++axis, rest /= std::size_t(side))
      u[std::size_t(axis)] = (double(rest % std::size_t(side)) + 0.5) / side;
    table.values.push_back(float(valueOf(cell, u)));
  }
  return table;
}

double meanSquareError(const InverseTable& table, const InverseTable& fitted,
                       const std::vector<std::array<double, 3>>& at) {
  double sum = 0.0;
  for (const auto& value : at)
    sum += std::pow(slowLookup(table, value, 0) - slowLookup(fitted, value, 0), 2);
  return sum / double(at.size());
}

/// The best table of `side` cells: least squares over all cells and values, by an orthogonal
/// decomposition.
InverseTable bestTable(const InverseTable& table, int side,
                       const std::vector<std::array<double, 3>>& at) {
  InverseTable best = filledTable(table.dimensions, side, [](auto, auto) { return 0.0; });
  const auto cells = Eigen::Index(best.cellCount());
  Eigen::MatrixXd weights(Eigen::Index(at.size()), cells);
  Eigen::VectorXd wanted(Eigen::Index(at.size()));
  for (Eigen::Index cell = 0; cell < cells; ++cell) {
    InverseTable one = best;
    one.values[std::size_t(cell)] = 1.0f;
    for (std::size_t k = 0; k < at.size(); ++k)
      weights(Eigen::Index(k), cell) = slowLookup(one, at[k], 0);
  }
  for (std::size_t k = 0; k < at.size(); ++k)
    wanted[Eigen::Index(k)] = slowLookup(table, at[k], 0);
  const Eigen::VectorXd solved = weights.completeOrthogonalDecomposition().solve(wanted);
  for (Eigen::Index cell = 0; cell < cells; ++cell)
    best.values[std::size_t(cell)] = float(solved[cell]);
  return best;
}

} // namespace

TEST_CASE("a coarser table is the least-squares fit of a table, and better than sampling it") {
  const auto rough = [](std::size_t cell, const std::array<double, 3>& u) {
    return u[0] * u[0] + std::sin(5.0 * u[1]) + 0.3 * transport::randomUniform(3, cell);
  };
  for (const auto& [dimensions, fineSide, grid] :
       {std::array{1, 32, 2048}, std::array{2, 8, 150}, std::array{3, 4, 32}})
    for (const double amplitude : {0.8, 0.4}) {
      const InverseTable table = filledTable(dimensions, fineSide, rough);
      const int side = fineSide / 2;
      const std::vector<std::array<double, 3>> at = gaussianGrid(dimensions, amplitude, grid);
      const double fitted = meanSquareError(table, coarser(table, side, amplitude), at);
      const double best = meanSquareError(table, bestTable(table, side, at), at);
      const auto centre = [&](std::size_t, const std::array<double, 3>& u) {
        std::array<double, 3> value{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          value[axis] = u[axis] > 0.0 ? gaussian::gaussianQuantile(u[axis]) : 0.0;
        return slowLookup(table, value, 0);
      };
      const double sampled = meanSquareError(table, filledTable(dimensions, side, centre), at);
      INFO(dimensions << " dimensions, amplitude " << amplitude << ": fit " << fitted << ", best "
                      << best << ", sampled " << sampled);
      CHECK(fitted >= 0.999 * best);
      // The weight of cells' own centres, 1e-3, and the coarse grid of these values.
      CHECK(fitted < 1.03 * best);
      CHECK(fitted < sampled);
    }
}
