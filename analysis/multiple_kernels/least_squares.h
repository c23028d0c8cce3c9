// SPDX-License-Identifier: MIT
// Levenberg and Marquardt's method.
#pragma once

#include <Eigen/Dense>

namespace lichen::multiple_kernels {

/// Minimises the sum of squares of `residualsAt(values, derivatives or null)` from `values` on, by
/// Levenberg and Marquardt's method with steps that `limited(values, step)` shortens.
template <class ResidualsAt, class Limited>
Eigen::VectorXd minimized(Eigen::VectorXd values, Eigen::Index count,
                          const ResidualsAt& residualsAt, const Limited& limited) {
  constexpr int kMostSteps = 60, kMostTrials = 10;
  constexpr double kLeastGain = 1e-3; // of the sum
  Eigen::MatrixXd derivatives(count, values.size());
  Eigen::VectorXd residuals = residualsAt(values, &derivatives);
  double damping = 1e-2;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::VectorXd gradient = derivatives.transpose() * residuals;
    Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(values.size(), values.size());
    curvature.selfadjointView<Eigen::Lower>().rankUpdate(derivatives.transpose());
    const Eigen::VectorXd diagonal = curvature.diagonal().array() + 1e-9;
    const double before = residuals.squaredNorm();
    double gain = 0.0;
    for (int trial = 0; trial < kMostTrials && !(gain > 0.0); ++trial) {
      Eigen::MatrixXd damped = curvature;
      damped.diagonal() += damping * diagonal;
      const Eigen::VectorXd moved =
          values -
          limited(values, damped.selfadjointView<Eigen::Lower>().ldlt().solve(gradient).eval());
      if (const double after = residualsAt(moved, nullptr).squaredNorm(); after < before) {
        gain = 1.0 - after / before;
        values = moved;
        damping *= 0.3;
      } else {
        damping *= 4.0;
      }
    }
    if (gain < kLeastGain)
      break;
    residuals = residualsAt(values, &derivatives);
  }
  return values;
}

} // namespace lichen::multiple_kernels
