// SPDX-License-Identifier: MIT
// A table of N^D cells -> one of n^D. Lookups are linear in the cells and the Gaussian's axes are
// independent, so the fit is a product of fits along the axes: n x N matrices (M + r I)^-1 (B + r
// S) with M = E[w w^T], B = E[w v^T], w and v the interpolation weights of a coarse and a fine
// lookup at the same Gaussian value, and S the weights of the fine lookup at the coarse cells'
// centres.
#include "coarse_table.h"

#include <Eigen/Dense>

#include <algorithm>

namespace lichen::gaussianization {
namespace {

/// Quantiles of the Gaussian that the moments are averaged over.
constexpr int kQuantiles = 2048;

/// Weight r of a cell's own centre, for cells that hardly any Gaussian value reaches: a thousandth
/// of the weight of a cell in the middle of a table of uniform weights.
constexpr double kCentreShare = 1e-3;

/// The interpolation weights of a lookup: of the cell `first` and the one after it.
struct LookupWeights {
  int first;
  Eigen::Vector2d weights;
};

LookupWeights lookupWeights(double u, int side) {
  const double place = std::clamp(side * u - 0.5, 0.0, double(side - 1));
  const int first = std::min(int(place), side - 2);
  return {first, {1.0 - (place - first), place - first}};
}

Eigen::MatrixXf axisFit(int fineSide, int side, double amplitude) {
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(side, side);
  Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(side, fineSide);
  for (int k = 0; k < kQuantiles; ++k) {
    const double quantile = gaussian::gaussianQuantile((k + 0.5) / kQuantiles);
    const double u = gaussian::gaussianCdf(gaussian::kGaussianMean +
                                           amplitude * (quantile - gaussian::kGaussianMean));
    const LookupWeights coarse = lookupWeights(u, side), fine = lookupWeights(u, fineSide);
    mass.block<2, 2>(coarse.first, coarse.first) +=
        coarse.weights * coarse.weights.transpose() / kQuantiles;
    mixed.block<2, 2>(coarse.first, fine.first) +=
        coarse.weights * fine.weights.transpose() / kQuantiles;
  }
  const double centre = kCentreShare / side;
  for (int cell = 0; cell < side; ++cell) {
    mass(cell, cell) += centre;
    const LookupWeights fine = lookupWeights((cell + 0.5) / side, fineSide);
    mixed.block<1, 2>(cell, fine.first) += centre * fine.weights.transpose();
  }
  return mass.ldlt().solve(mixed).cast<float>();
}

} // namespace

InverseTable coarser(const InverseTable& table, int side, double amplitude) {
  const Eigen::MatrixXf fit = axisFit(table.side, side, amplitude);
  const auto channels = std::size_t(table.channels);
  std::vector<float> from = table.values;
  // Axis by axis: `before` values lie between neighbours of the axis, `after` times as many lines.
  std::size_t before = channels;
  for (int axis = 0; axis < table.dimensions; ++axis) {
    const std::size_t line = before * std::size_t(table.side);
    const std::size_t after = from.size() / line;
    std::vector<float> to(after * before * std::size_t(side));
    for (std::size_t k = 0; k < after; ++k) {
      using Lines = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      const Eigen::Map<const Lines> source(&from[k * line], table.side, Eigen::Index(before));
      Eigen::Map<Lines>(&to[k * before * std::size_t(side)], side, Eigen::Index(before)) =
          fit * source;
    }
    from = std::move(to);
    before *= std::size_t(side);
  }
  return {table.dimensions, side, table.channels, std::move(from)};
}

} // namespace lichen::gaussianization
