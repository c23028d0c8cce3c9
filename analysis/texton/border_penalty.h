// SPDX-License-Identifier: MIT
// What of a texton ends at the border of its support, where a square of its size would be seen.
#pragma once

#include "fit.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

namespace lichen::texton {

/// The steps from coefficient to coefficient across a texton's border over those inside it, root
/// mean squares of steps averaged along runs of a quarter of the side: straight edges that an eye
/// joins up. Of the channel where it is greatest. 1 where the border is like any other line,
/// infinite where only the border has steps.
[[nodiscard]] double borderVisibility(const TextonCoefficients& coefficients);

/// Moves coefficients as far as lowers the sum of two squares most: how far they move, as their
/// noise does, and `weight` times what of them is slow and near the border.
class BorderPenalty {
public:
  /// The normal matrices of the coefficients along a row and along a column.
  BorderPenalty(const Eigen::SparseMatrix<double>& normalX,
                const Eigen::SparseMatrix<double>& normalY);

  /// Raises the weight where the border is visible, lowers it where it is not.
  void adapt(const TextonCoefficients& coefficients);
  void apply(TextonCoefficients& coefficients) const;

private:
  void setWeight(double weight);

  double weight_ = 0.0;
  Eigen::MatrixXf analysisX_, analysisY_;   ///< cosines x coefficients
  Eigen::MatrixXf synthesisX_, synthesisY_; ///< coefficients x cosines
  Eigen::MatrixXf modes_;                   ///< cosines of both axes x modes
  Eigen::VectorXd costs_;                   ///< of each mode, over its noise's power
  Eigen::VectorXf removed_;                 ///< share of each mode
};

} // namespace lichen::texton
