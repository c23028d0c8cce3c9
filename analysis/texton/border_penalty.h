// SPDX-License-Identifier: MIT
// The part of a texton that ends abruptly at the border of its support, where its square outline
// would be visible.
#pragma once

#include "fit.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

namespace lichen::texton {

/// Ratio of the steps between coefficients across a texton's border to those inside it. Both are
/// root mean squares of steps averaged along runs of a quarter of the side, because the eye joins
/// straight edges. Returns the largest value over the channels: 1 where the border is like any
/// other line, infinite where only the border has steps.
[[nodiscard]] double borderVisibility(const TextonCoefficients& coefficients);

/// Moves coefficients to minimize the sum of two squares: the change that their noise sees, and
/// `weight` times their slowly varying part near the border.
class BorderPenalty {
public:
  /// Takes the normal matrices of the coefficients along a row and along a column.
  BorderPenalty(const Eigen::SparseMatrix<double>& normalX,
                const Eigen::SparseMatrix<double>& normalY);

  /// Raises the weight where the border is visible and lowers it where it is not.
  void adapt(const TextonCoefficients& coefficients);
  void apply(TextonCoefficients& coefficients) const;

private:
  void setWeight(double weight);

  double weight_ = 0.0;
  Eigen::MatrixXf analysisX_, analysisY_;   ///< cosines x coefficients
  Eigen::MatrixXf synthesisX_, synthesisY_; ///< coefficients x cosines
  Eigen::MatrixXf modes_;                   ///< cosines of both axes x modes
  Eigen::VectorXd costs_;                   ///< cost of each mode over the power of its noise
  Eigen::VectorXf removed_;                 ///< share of each mode that apply() removes
};

} // namespace lichen::texton
