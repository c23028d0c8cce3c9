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

/// Coefficients are floats, and the first map is as near as their rounding and the eigenvalues'
/// allow; the second, which is almost the identity, removes most of what is left.
constexpr int kRounds = 2;
/// Of the two deviations of a covariance: what the coefficients may miss of what they can have, the
/// target of TARGETS.md.
constexpr double kTolerance = 1e-6;
/// Likewise: what may be missing since the texton does not vary so. A thousandth is far below what
/// an eye sees, and above what a slope of light in one colour of a grey photograph leaves.
constexpr double kUnreachable = 1e-3;

/// One plane filtered with the kernel's autocorrelation along both axes.
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

/// The coefficients as a matrix, a column for each channel.
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
  // Channels in deviations of the target, so that faint ones are held to the same tolerance.
  const Eigen::VectorXd deviations = target.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd units = (deviations.array() > 0.0).select(deviations, 1.0);
  const auto inUnits = [&](const MatrixXd& covariance) -> MatrixXd {
    return units.cwiseInverse().asDiagonal() * covariance * units.cwiseInverse().asDiagonal();
  };
  const MatrixXd whole = inUnits(target);
  // The projection on the sums of channels that vary at all.
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
        columns.col(c).setZero(); // not rounding, which its scale would make visible
  }
  const MatrixXd left = inUnits(noiseCovariance(coefficients, order)) - wanted;
  if (left.cwiseAbs().maxCoeff() <= kTolerance)
    return true;
  coefficients.values = before;
  return false;
}

} // namespace lichen::texton
