// SPDX-License-Identifier: MIT
// Gaussian image of a map (width * height points), Gaussian images and values of the maps before it
// -> the Gaussian image with values exchanged. z below is G with mean 0 and variance 1; the P
// coordinates of all settled maps are stacked.
#include "cross_covariance.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace lichen::tiling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// In correlations. The target of 3 % is a hundred times as large where maps go together at all.
constexpr double kNegligible = 3e-4;

/// Exchanging values inside ties has less effect than in a continuum, which gain makes up for:
/// after two or three of these the plaster wall's roughness lacks nothing.
constexpr int kMostPassesOnLine = 6;
constexpr double kMostGain = 4.0;

/// A pass that brings less has reached what exchange can.
constexpr double kLeastReduction = 0.1;

/// Root mean square, in deviations: the Gaussian value of a pixel then still has 99 % of its
/// variance from the pixel's own value. Photographs need 0.01 to 0.03.
constexpr double kLargestMove = 0.1;

/// Of the product of the shares that two axes have in their maps' variances: below it an axis is
/// no way to change covariances, since it would take too large moves. With a tenth of it those of
/// the photographed sets' slopes grow by 9 and 23 %.
constexpr double kDamping = 1e-3;

void readStandardized(const Point& point, int dimensions, double* z) {
  const std::array<float, 3> p{point.x, point.y, point.z};
  for (int d = 0; d < dimensions; ++d)
    z[d] = (double(p[std::size_t(d)]) - kGaussianMean) / kGaussianDeviation;
}

VectorXd readValue(const Point& point, int dimensions) {
  const std::array<float, 3> p{point.x, point.y, point.z};
  VectorXd value(dimensions);
  for (int d = 0; d < dimensions; ++d)
    value[d] = double(p[std::size_t(d)]);
  return value;
}

double deviationOf(const std::vector<Point>& values, int dimensions) {
  double sum = 0.0;
  for (const Point& value : values)
    sum += readValue(value, dimensions).squaredNorm();
  return std::sqrt(sum / double(values.size()));
}

/// E[y z^T] of a map, y its values in units of their deviation: what a step of z changes in the
/// decoded values, on average over the Gaussian (Stein's lemma).
MatrixXd decoderOf(const std::vector<Point>& values, const std::vector<Point>& matched,
                   int dimensions, double deviation) {
  MatrixXd sum = MatrixXd::Zero(dimensions, dimensions);
  VectorXd z(dimensions);
  for (std::size_t i = 0; i < values.size(); ++i) {
    readStandardized(matched[i], dimensions, z.data());
    sum += readValue(values[i], dimensions) * z.transpose();
  }
  return sum / (deviation * double(values.size()));
}

/// Covariances of a map with the settled ones: of their values, and of what blends decode to.
class CrossCovariances {
public:
  CrossCovariances(const MapExemplar& map, const ColorSpace& space,
                   std::span<const SettledMap> settled)
      : map_(map), dimensions_(space.dimensions()), values_(projectedValues(map, space)),
        deviation_(deviationOf(values_, dimensions_)), settled_(settled) {
    for (const SettledMap& other : settled_)
      coordinates_ += other.gaussian.dimensions;
    decoders_ = MatrixXd::Zero(coordinates_, coordinates_);
    VectorXd deviations(coordinates_);
    Eigen::Index row = 0;
    for (const SettledMap& other : settled_) {
      const int n = other.gaussian.dimensions;
      const double deviation = deviationOf(other.values, n);
      decoders_.block(row, row, n, n) =
          decoderOf(other.values, other.gaussian.matched, n, deviation);
      deviations.segment(row, n).setConstant(deviation * deviation_);
      row += n;
    }
    MatrixXd together = MatrixXd::Zero(coordinates_, coordinates_);
    wanted_ = MatrixXd::Zero(coordinates_, dimensions_);
    VectorXd y(coordinates_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const VectorXd z = settledAt(i, &Gaussianized::matched);
      together += z * z.transpose();
      row = 0;
      for (const SettledMap& other : settled_) {
        const int n = other.gaussian.dimensions;
        y.segment(row, n) = readValue(other.values[pixelAt(other, i)], n);
        row += n;
      }
      wanted_ += y * readValue(values_[i], dimensions_).transpose();
    }
    const double count = double(values_.size());
    wanted_ = (deviations.cwiseInverse().asDiagonal() * wanted_ / count).eval();
    response_ = decoders_ * together / count;
  }

  /// P x D, in units of the maps' deviations: the covariances of the values less the linear part
  /// of those of blends, B_m E[z_m z^T] B^T. Blending keeps that part at every weight; of the rest,
  /// which only the exemplar has, hardly anything is left inside a triangle.
  [[nodiscard]] MatrixXd lackOf(const Gaussianized& gaussian) const {
    MatrixXd sum = MatrixXd::Zero(coordinates_, dimensions_);
    VectorXd z(dimensions_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      readStandardized(gaussian.image[i], dimensions_, z.data());
      sum += settledAt(i, &Gaussianized::image) * z.transpose();
    }
    return wanted_ -
           decoders_ * (sum / double(values_.size())) * decoder(gaussian.matched).transpose();
  }

  /// P x D: how much of each settled coordinate to add to z so that the linear part grows by
  /// `lack`, least squares with kDamping.
  [[nodiscard]] MatrixXd slopeFor(const MatrixXd& lack, const Gaussianized& gaussian) const {
    constexpr unsigned kBoth = Eigen::ComputeFullU | Eigen::ComputeFullV;
    const Eigen::JacobiSVD<MatrixXd> left(response_, kBoth);
    const Eigen::JacobiSVD<MatrixXd> right(decoder(gaussian.matched), kBoth);
    MatrixXd part = left.matrixU().transpose() * lack * right.matrixU();
    for (Eigen::Index r = 0; r < part.rows(); ++r)
      for (Eigen::Index c = 0; c < part.cols(); ++c) {
        const double gain = left.singularValues()[r] * right.singularValues()[c];
        part(r, c) *= gain / (gain * gain + kDamping);
      }
    return left.matrixV() * part * right.matrixV().transpose();
  }

  /// Points whose order, or transport, puts z + slope^T z_settled in the place of z.
  [[nodiscard]] std::vector<Point> moved(const Gaussianized& gaussian,
                                         const MatrixXd& slope) const {
    std::vector<Point> points(values_.size());
    VectorXd z(dimensions_);
    MatrixXd moves(dimensions_, Eigen::Index(values_.size()));
    for (std::size_t i = 0; i < values_.size(); ++i)
      moves.col(Eigen::Index(i)) = slope.transpose() * settledAt(i, &Gaussianized::matched);
    if (dimensions_ > 1) {
      const double size = std::sqrt(moves.squaredNorm() / double(moves.size()));
      moves *= std::min(1.0, kLargestMove / std::max(size, kLargestMove));
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      readStandardized(gaussian.matched[i], dimensions_, z.data());
      z += moves.col(Eigen::Index(i));
      points[i] = {float(z[0]), dimensions_ > 1 ? float(z[1]) : 0.0f,
                   dimensions_ > 2 ? float(z[2]) : 0.0f};
    }
    return dimensions_ > 1 ? points : insideTies(points);
  }

private:
  [[nodiscard]] MatrixXd decoder(const std::vector<Point>& matched) const {
    return decoderOf(values_, matched, dimensions_, deviation_);
  }

  [[nodiscard]] std::size_t pixelAt(const SettledMap& other, std::size_t i) const {
    const auto width = std::size_t(map_.width), height = std::size_t(map_.height);
    const auto otherWidth = std::size_t(other.gaussian.width);
    const auto otherHeight = std::size_t(other.gaussian.height);
    const std::size_t x = (2 * (i % width) + 1) * otherWidth / (2 * width);
    const std::size_t y = (2 * (i / width) + 1) * otherHeight / (2 * height);
    return y * otherWidth + x;
  }

  [[nodiscard]] VectorXd settledAt(std::size_t i, std::vector<Point> Gaussianized::*points) const {
    VectorXd z(coordinates_);
    Eigen::Index row = 0;
    for (const SettledMap& other : settled_) {
      readStandardized((other.gaussian.*points)[pixelAt(other, i)], other.gaussian.dimensions,
                       z.data() + row);
      row += other.gaussian.dimensions;
    }
    return z;
  }

  /// Ranks by value and, where values are equal, by score.
  [[nodiscard]] std::vector<Point> insideTies(const std::vector<Point>& scores) const {
    std::vector<std::uint32_t> order(values_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      if (values_[a].x != values_[b].x)
        return values_[a].x < values_[b].x;
      return scores[a].x != scores[b].x ? scores[a].x < scores[b].x : a < b;
    });
    std::vector<Point> ranks(values_.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank)
      ranks[order[rank]].x = float(rank);
    return ranks;
  }

  const MapExemplar& map_;
  int dimensions_;
  std::vector<Point> values_;
  double deviation_;
  std::span<const SettledMap> settled_;
  Eigen::Index coordinates_ = 0;
  MatrixXd decoders_; ///< P x P: B of each settled map
  MatrixXd wanted_;   ///< P x D
  MatrixXd response_; ///< P x P: of `wanted_` to the settled coordinates' shares in z
};

} // namespace

std::vector<Point> projectedValues(const MapExemplar& map, const ColorSpace& space) {
  const std::size_t channels = map.channels.size();
  std::vector<Point> points(map.values.size() / channels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ChannelVector d(static_cast<Eigen::Index>(channels));
    for (std::size_t c = 0; c < channels; ++c)
      d[Eigen::Index(c)] =
          double(map.values[i * channels + c]) - space.moments.mean[Eigen::Index(c)];
    const ChannelVector p = space.basis * d;
    points[i] = {float(p[0]), p.size() > 1 ? float(p[1]) : 0.0f, p.size() > 2 ? float(p[2]) : 0.0f};
  }
  return points;
}

Gaussianized withCrossCovariances(const MapExemplar& map, const ColorSpace& space,
                                  std::span<const SettledMap> settled, Gaussianized first,
                                  const Gaussianizer& again) {
  if (settled.empty())
    return first;
  const CrossCovariances covariances(map, space, settled);
  const int passes = space.dimensions() == 1 ? kMostPassesOnLine : 1;
  MatrixXd lack = covariances.lackOf(first);
  MatrixXd slope = MatrixXd::Zero(lack.rows(), lack.cols());
  Gaussianized best = first;
  double gain = 1.0;
  for (int pass = 0; pass < passes && lack.norm() > kNegligible; ++pass) {
    slope += gain * covariances.slopeFor(lack, best);
    Gaussianized next = again(covariances.moved(first, slope));
    const MatrixXd left = covariances.lackOf(next);
    if (left.norm() >= lack.norm())
      break;
    const double reduction = 1.0 - left.cwiseProduct(lack).sum() / lack.squaredNorm();
    best = std::move(next);
    lack = left;
    if (reduction < kLeastReduction)
      break;
    gain = std::min(gain / reduction, kMostGain);
  }
  return best;
}

} // namespace lichen::tiling
