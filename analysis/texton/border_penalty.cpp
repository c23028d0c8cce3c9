// SPDX-License-Identifier: MIT
// Texton coefficients (channels, height, width) -> the same with a smooth border.
//
// Let p be the coefficients of one channel, P p their projection on the first cosines of both axes,
// which varies slowly, and V the weights of the coefficients near the border. The result is the q
// that minimizes (q - p)^T B (q - p) + weight (P q)^T V (P q), where B = B_y (x) B_x is the normal
// matrix. This is a correction with as many dimensions as there are cosines:
// q = p - B^-1 C^T A (weight L / (1 + weight L)) A^T C p, where C are the cosines, and A and L the
// modes and eigenvalues of the border's quadratic form over C B^-1 C^T.
// Reasons and measurements: docs/decisions/008-textons.md.
#include "border_penalty.h"

#include "transport/covariance.h"

#include <Eigen/SparseCholesky>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/KroneckerProduct>
#include <vector>

namespace lichen::texton {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

// Measured on six photographs with supports of 16, 32 and 64 (decision 8).
constexpr Index kSlowCosines = 8;     // per side: up to three and a half waves
constexpr double kBorderWidth = 0.25; // of the side, at each end
constexpr double kMostWeight = 0.1;   // also the first weight
constexpr double kLeastWeight = 1e-3; // reflections can still raise it to kMostWeight
/// Above this visibility the square outline of a texton shows. The height map of a rock wall has 10
/// without a higher weight. Only there may the weight exceed kMostWeight, which trades closeness to
/// the model for an even border.
constexpr double kSeenVisibility = 4.0;
constexpr double kMostSeenWeight = 1.0;
/// One reflection multiplies the weight by this power of the visibility: slower than the fit moves.
constexpr double kAdaption = 0.25;

constexpr double kRunOfSide = 0.25;

/// Returns the mean square of the averages of `steps` over runs of `length`.
double runEnergy(const Eigen::VectorXf& steps, Index length) {
  double energy = 0.0, run = 0.0;
  for (Index i = 0; i < steps.size(); ++i) {
    run += double(steps[i]) - (i >= length ? double(steps[i - length]) : 0.0);
    energy += i + 1 >= length ? run * run : 0.0;
  }
  return energy / (double(steps.size() - length + 1) * double(length) * double(length));
}

struct StepEnergies {
  double border = 0.0;
  double inside = 0.0;
};

/// Returns the energies of the steps between columns, and of those to the zeros outside.
StepEnergies stepsBetweenColumns(const MatrixXf& plane) {
  const Index lines = plane.cols();
  const Index length = std::max(Index(1), Index(std::lround(kRunOfSide * double(plane.rows()))));
  StepEnergies energies;
  for (Index line = 1; line < lines; ++line)
    energies.inside += runEnergy(plane.col(line) - plane.col(line - 1), length) / double(lines - 1);
  energies.border =
      0.5 * (runEnergy(plane.col(0), length) + runEnergy(plane.col(lines - 1), length));
  return energies;
}

/// Row k is the cosine of k half waves, scaled to unit length.
MatrixXd cosines(Index size) {
  MatrixXd rows(std::min(kSlowCosines, (size + 1) / 2), size);
  for (Index k = 0; k < rows.rows(); ++k)
    for (Index i = 0; i < size; ++i)
      rows(k, i) = std::sqrt((k == 0 ? 1.0 : 2.0) / double(size)) *
                   std::cos(std::numbers::pi * (double(i) + 0.5) * double(k) / double(size));
  return rows;
}

/// 1 inside, falling to 0 at both ends.
Eigen::VectorXd window(Index size) {
  Eigen::VectorXd weights(size);
  for (Index i = 0; i < size; ++i) {
    const double fromEnd = std::min(double(i) + 0.5, double(size - i) - 0.5);
    const double part = std::min(1.0, fromEnd / (kBorderWidth * double(size)));
    const double root = std::sin(0.5 * std::numbers::pi * part);
    weights[i] = root * root;
  }
  return weights;
}

} // namespace

double borderVisibility(const TextonCoefficients& coefficients) {
  const Index texels = Index(coefficients.width) * coefficients.height;
  std::vector<double> visibilities(std::size_t(coefficients.channels));
  tbb::parallel_for(Index(0), Index(coefficients.channels), [&](Index c) {
    const Eigen::Map<const MatrixXf> plane(coefficients.values.data() + c * texels,
                                           coefficients.width, coefficients.height);
    const StepEnergies rows = stepsBetweenColumns(plane);
    const StepEnergies columns = stepsBetweenColumns(plane.transpose());
    if (const double border = rows.border + columns.border; border > 0.0)
      visibilities[std::size_t(c)] = std::sqrt(border / (rows.inside + columns.inside));
  });
  return *std::max_element(visibilities.begin(), visibilities.end());
}

BorderPenalty::BorderPenalty(const Eigen::SparseMatrix<double>& normalX,
                             const Eigen::SparseMatrix<double>& normalY) {
  using Solver = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>;
  const MatrixXd x = cosines(normalX.rows()), y = cosines(normalY.rows());
  const MatrixXd smoothX = Solver(normalX).solve(MatrixXd(x.transpose()));
  const MatrixXd smoothY = Solver(normalY).solve(MatrixXd(y.transpose()));
  // A patch is column-major and its columns are rows of the texton: x is the faster index.
  const MatrixXd power = Eigen::kroneckerProduct(MatrixXd(y * smoothY), MatrixXd(x * smoothX));
  const MatrixXd insideX = x * window(x.cols()).asDiagonal() * x.transpose();
  const MatrixXd insideY = y * window(y.cols()).asDiagonal() * y.transpose();
  const MatrixXd border = MatrixXd::Identity(power.rows(), power.cols()) -
                          MatrixXd(Eigen::kroneckerProduct(insideY, insideX));
  const Eigen::LLT<MatrixXd> root(power);
  const MatrixXd lower = root.matrixL();
  const auto axes = transport::principalAxes(MatrixXd(lower.transpose() * border * lower));
  modes_ = MatrixXd(root.matrixU().solve(axes.eigenvectors())).cast<float>();
  costs_ = axes.eigenvalues().cwiseMax(0.0);
  analysisX_ = x.cast<float>();
  analysisY_ = y.cast<float>();
  synthesisX_ = smoothX.cast<float>();
  synthesisY_ = smoothY.cast<float>();
  setWeight(kMostWeight);
}

void BorderPenalty::setWeight(double weight) {
  weight_ = weight;
  removed_ = (weight * costs_.array() / (1.0 + weight * costs_.array())).matrix().cast<float>();
}

void BorderPenalty::adapt(const TextonCoefficients& coefficients) {
  const double visibility = borderVisibility(coefficients);
  double weight = weight_ * std::pow(visibility, kAdaption);
  if (weight > kMostWeight)
    weight = std::max(kMostWeight, weight_ * std::pow(visibility / kSeenVisibility, kAdaption));
  setWeight(std::clamp(weight, kLeastWeight, kMostSeenWeight));
}

void BorderPenalty::apply(TextonCoefficients& coefficients) const {
  const Index texels = Index(coefficients.width) * coefficients.height;
  tbb::parallel_for(Index(0), Index(coefficients.channels), [&](Index c) {
    Eigen::Map<MatrixXf> patch(coefficients.values.data() + c * texels, coefficients.width,
                               coefficients.height);
    const MatrixXf slow = analysisX_ * patch * analysisY_.transpose();
    const Eigen::VectorXf modes = removed_.cwiseProduct(modes_.transpose() * slow.reshaped());
    const Eigen::VectorXf removed = modes_ * modes;
    patch -= synthesisX_ * removed.reshaped(slow.rows(), slow.cols()) * synthesisY_.transpose();
  });
}

} // namespace lichen::texton
