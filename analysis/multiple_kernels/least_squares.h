// SPDX-License-Identifier: MIT
// Levenberg and Marquardt's method.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen::multiple_kernels {

/// The usual share of the sum of squares that a step has to take away.
inline constexpr double kLeastGain = 1e-3;

/// Residuals, and their derivatives by the values: a row for each residual.
struct Residuals {
  Eigen::VectorXd values;
  Eigen::MatrixXd derivatives;
};

/// Minimises the sum of squares of `residualsAt(values)` from `values` on, until a step takes less
/// than `leastGain` of it away, by Levenberg and Marquardt's method with steps that
/// `limited(values, step)` shortens. The damping follows how well the last step was foreseen
/// [MNT04].
template <class ResidualsAt, class Limited>
Eigen::VectorXd minimized(Eigen::VectorXd values, double leastGain, const ResidualsAt& residualsAt,
                          const Limited& limited) {
  constexpr int kMostTrials = 100;
  Residuals here = residualsAt(values);
  double damping = 1e-2, growth = 2.0;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    const double before = here.values.squaredNorm();
    const Eigen::VectorXd gradient = here.derivatives.transpose() * here.values;
    Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(values.size(), values.size());
    curvature.selfadjointView<Eigen::Lower>().rankUpdate(here.derivatives.transpose());
    const Eigen::VectorXd diagonal = curvature.diagonal().array() + 1e-9;
    Eigen::MatrixXd damped = curvature;
    damped.diagonal() += damping * diagonal;
    const Eigen::VectorXd step =
        limited(values, damped.selfadjointView<Eigen::Lower>().ldlt().solve(gradient).eval());
    Residuals there = residualsAt(values - step);
    const double after = there.values.squaredNorm();
    const double foreseen = (here.values - here.derivatives * step).squaredNorm();
    if (after < before) {
      const double ratio = (before - after) / std::max(before - foreseen, 1e-300);
      damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3.0));
      growth = 2.0;
      values -= step;
      here = std::move(there);
      if (1.0 - after / before < leastGain)
        break;
    } else {
      damping *= growth;
      growth *= 2.0;
      constexpr double kMostGrowth = 2048.0; // eleven steps in a row that gain nothing
      if (growth > kMostGrowth)
        break;
    }
  }
  return values;
}

} // namespace lichen::multiple_kernels
