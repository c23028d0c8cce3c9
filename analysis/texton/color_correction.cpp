// SPDX-License-Identifier: MIT
// Coefficients (channels, height, width) and a covariance -> coefficients with that covariance.
//
// Sources: [GLM17] section 4.3; [PC19] eq. 2.40 for the map.
#include "color_correction.h"

#include "interpolation.h"
#include "transport/covariance_map.h"

#include <cmath>

namespace lichen::texton {
namespace {

using Eigen::MatrixXd;

/// Rounding of the float coefficients and of the eigenvalues limits the accuracy of the first map.
/// The second map is almost the identity and removes most of the remaining error.
constexpr int kRounds = 2;
/// Largest error of a covariance within what the coefficients can express, relative to its two
/// standard deviations: the target of TARGETS.md.
constexpr double kTolerance = 1e-6;
/// Largest part of a covariance, in the same measure, that may lie outside the texton's range. A
/// thousandth is far below what the eye sees, and above what a brightness gradient in one colour of
/// a grey photograph leaves.
constexpr double kUnreachable = 1e-3;

/// Filters one plane with the kernel's autocorrelation along both axes.
MatrixXd filtered(const MatrixXd& plane, const std::vector<double>& b) {
  const auto order = Eigen::Index(b.size()) - 1;
  const auto alongRows = [&](const MatrixXd& in) {
    MatrixXd out = b[0] * in;
    for (Eigen::Index lag = 1; lag <= std::min(order, in.rows() - 1); ++lag) {
      const Eigen::Index rest = in.rows() - lag;
      out.topRows(rest) += b[std::size_t(lag)] * in.bottomRows(rest);
      out.bottomRows(rest) += b[std::size_t(lag)] * in.topRows(rest);
    }
    return out;
  };
  return alongRows(alongRows(plane).transpose()).transpose();
}

/// Returns the coefficients as a matrix with one column per channel.
Eigen::Map<Eigen::MatrixXf> columnsOf(TextonCoefficients& coefficients) {
  return {coefficients.values.data(), Eigen::Index(coefficients.width) * coefficients.height,
          coefficients.channels};
}

} // namespace

MatrixXd noiseCovariance(const TextonCoefficients& coefficients, int order) {
  const std::vector<double> b = kernelAutocorrelation(order);
  const Eigen::Index texels = Eigen::Index(coefficients.width) * coefficients.height;
  const Eigen::Map<const Eigen::MatrixXf> all(coefficients.values.data(), texels,
                                              coefficients.channels);
  const MatrixXd values = all.cast<double>();
  MatrixXd smoothed(values.rows(), values.cols());
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const Eigen::Map<const MatrixXd> plane(values.col(c).data(), coefficients.width,
                                           coefficients.height);
    const MatrixXd result = filtered(plane, b);
    smoothed.col(c) = Eigen::Map<const Eigen::VectorXd>(result.data(), texels);
  }
  const MatrixXd product = values.transpose() * smoothed;
  return 0.5 * (product + product.transpose());
}

bool correctCovariance(TextonCoefficients& coefficients, int order, const MatrixXd& target) {
  // Measure channels in standard deviations of the target: faint channels get the same tolerance.
  const Eigen::VectorXd deviations = target.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd units = (deviations.array() > 0.0).select(deviations, 1.0);
  const auto inUnits = [&](const MatrixXd& covariance) -> MatrixXd {
    return units.cwiseInverse().asDiagonal() * covariance * units.cwiseInverse().asDiagonal();
  };
  const MatrixXd whole = inUnits(target);
  // Project on the combinations of channels in which the texton varies.
  const MatrixXd range = transport::power(inUnits(noiseCovariance(coefficients, order)), 0.0);
  const MatrixXd wanted = range * whole * range;
  if ((whole - wanted).cwiseAbs().maxCoeff() > kUnreachable)
    return false;
  const std::vector<float> before = coefficients.values;
  auto columns = columnsOf(coefficients);
  for (int round = 0; round < kRounds; ++round) {
    const MatrixXd now = inUnits(noiseCovariance(coefficients, order));
    const MatrixXd map = units.cwiseInverse().asDiagonal() * transport::covarianceMap(now, wanted) *
                         units.asDiagonal();
    columns = (columns.cast<double>() * map).cast<float>().eval();
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
      if (!(deviations[c] > 0.0))
        columns.col(c).setZero(); // clears rounding, which the channel's scale would amplify
  }
  const MatrixXd left = inUnits(noiseCovariance(coefficients, order)) - wanted;
  if (left.cwiseAbs().maxCoeff() <= kTolerance)
    return true;
  coefficients.values = before;
  return false;
}

} // namespace lichen::texton
