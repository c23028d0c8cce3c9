// SPDX-License-Identifier: MIT
// Model (channels, height, width / 2 + 1) -> covariance (channels x channels).
#include "model_covariance.h"

#include "transport/covariance_map.h"

namespace lichen::gaussian {

Eigen::MatrixXd modelCovariance(const GaussianModel& model) {
  const auto channels = Eigen::Index(model.channels.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(channels, channels);
  const HalfSpectrum& shape = model.channels[0];
  const auto columns = std::size_t(shape.columns());
  for (std::size_t i = 0; i < shape.values.size(); ++i) {
    const double multiplicity = shape.multiplicity(int(i % columns));
    for (Eigen::Index a = 0; a < channels; ++a) {
      const std::complex<double> first = model.channels[std::size_t(a)].values[i];
      for (Eigen::Index b = 0; b <= a; ++b) {
        const std::complex<double> second = model.channels[std::size_t(b)].values[i];
        sum(a, b) += multiplicity * (first * std::conj(second)).real();
      }
    }
  }
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  return sum / (double(model.width()) * double(model.height()));
}

bool isModelled(const Eigen::MatrixXd& model, const Eigen::MatrixXd& wanted) {
  constexpr double kNegligible = 1e-3;    // of the largest variance
  constexpr double kLeastModelled = 0.01; // of the wanted variance: a gain of ten
  const auto axes = transport::principalAxes(wanted);
  for (Eigen::Index k = 0; k < axes.eigenvalues().size(); ++k) {
    const double variance = axes.eigenvalues()[k];
    const auto axis = axes.eigenvectors().col(k);
    if (variance > kNegligible * axes.eigenvalues().maxCoeff() &&
        axis.dot(model * axis) < kLeastModelled * variance)
      return false;
  }
  return true;
}

} // namespace lichen::gaussian
