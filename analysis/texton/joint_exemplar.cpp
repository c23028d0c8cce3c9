// SPDX-License-Identifier: MIT
// Maps of different sizes -> one image of all their channels; see joint_exemplar.h.
#include "joint_exemplar.h"

#include "exemplar/resample.h"

#include <algorithm>
#include <cmath>

namespace lichen::texton {
namespace {

using Eigen::MatrixXd;

MatrixXd covarianceOf(std::span<const float> values, std::size_t channels, Eigen::VectorXd& mean) {
  const Eigen::Map<const Eigen::MatrixXf> all(values.data(), Eigen::Index(channels),
                                              Eigen::Index(values.size() / channels));
  mean = all.cast<double>().rowwise().mean();
  MatrixXd sum = MatrixXd::Zero(all.rows(), all.rows());
  constexpr Eigen::Index kBlock = 4096; // pixels, so that the copy in double stays small
  for (Eigen::Index begin = 0; begin < all.cols(); begin += kBlock) {
    const Eigen::Index count = std::min(kBlock, all.cols() - begin);
    const MatrixXd centred = all.middleCols(begin, count).cast<double>().colwise() - mean;
    sum.noalias() += centred * centred.transpose();
  }
  return sum / double(all.cols());
}

} // namespace

JointExemplar joined(std::span<const MapExemplar> maps) {
  JointExemplar joint;
  for (const MapExemplar& map : maps) {
    joint.width = std::max(joint.width, map.width);
    joint.height = std::max(joint.height, map.height);
    joint.channels += map.channels.size();
  }
  joint.values.resize(std::size_t(joint.width) * std::size_t(joint.height) * joint.channels);
  joint.mean.resize(Eigen::Index(joint.channels));
  Eigen::VectorXd gains = Eigen::VectorXd::Ones(Eigen::Index(joint.channels));
  std::size_t first = 0;
  for (const MapExemplar& map : maps) {
    const std::size_t n = map.channels.size();
    const bool fits = map.width == joint.width && map.height == joint.height;
    const MapExemplar sized =
        fits ? map : exemplar::resampled(map, joint.width, joint.height, false);
    for (std::size_t i = 0; i < sized.values.size(); ++i)
      joint.values[i / n * joint.channels + first + i % n] = sized.values[i];
    Eigen::VectorXd mean, ignored;
    const MatrixXd own = covarianceOf(map.values, n, mean);
    const MatrixXd resized = covarianceOf(sized.values, n, ignored);
    for (Eigen::Index c = 0; c < Eigen::Index(n); ++c) {
      joint.mean[Eigen::Index(first) + c] = mean[c];
      if (resized(c, c) > 0.0)
        gains[Eigen::Index(first) + c] = std::sqrt(own(c, c) / resized(c, c));
    }
    first += n;
  }
  Eigen::VectorXd ignored;
  joint.covariance =
      gains.asDiagonal() * covarianceOf(joint.values, joint.channels, ignored) * gains.asDiagonal();
  return joint;
}

} // namespace lichen::texton
