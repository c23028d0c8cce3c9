// SPDX-License-Identifier: MIT
// Gaussian image of a map (width * height points), Gaussian images and values of the maps before it
// -> the Gaussian image with values exchanged. z below is G with mean 0 and variance 1; the P
// coordinates of all settled maps are stacked.
#include "cross_covariance.h"

#include "random_blend.h"
#include "table_lookup.h"
#include "value_encoding.h"

#include <lichen/tiling_evaluate.h>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <variant>

namespace lichen::tiling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// In correlations, about the standard error below.
constexpr double kNegligible = 3e-4;

/// Exchanging values inside ties has less effect than in a continuum, which gain makes up for:
/// with six of these the plaster wall's bias is 2.2 %, with three (and fewer samples) 4.2 %.
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

/// Of blends. What is measured on them has about a fifth of the values' deviation on photographs:
/// the correlations found have standard errors of 4e-4.
constexpr std::uint32_t kSamples = 1u << 18u;
constexpr std::uint32_t kSamplesOfBlock = 1u << 12u;

void readStandardized(const Point& point, int dimensions, double* z) {
  const std::array<float, 3> p{point.x, point.y, point.z};
  for (int d = 0; d < dimensions; ++d)
    z[d] = (double(p[std::size_t(d)]) - kGaussianMean) / kGaussianDeviation;
}

ChannelVector readValue(const Point& point, int dimensions) {
  const std::array<float, 3> p{point.x, point.y, point.z};
  ChannelVector value(dimensions);
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

/// One map of the blends: image, table, and the linear part of the table.
class BlendedMap {
public:
  BlendedMap(const Gaussianized& gaussian, const InverseTable& table, ChannelMatrix decoder,
             double deviation)
      : gaussian_(gaussian), lookup_(lookupOf(table)), decoder_(std::move(decoder)),
        deviation_(deviation) {}

  [[nodiscard]] int dimensions() const { return gaussian_.dimensions; }

  /// Decoded values and their linear part at a blend of three places, in [0, 2^32) each way.
  void evaluate(const std::array<std::array<std::uint32_t, 2>, 3>& places,
                const std::array<float, 3>& weights, double* decodedValue, double* linear) const {
    constexpr auto kMean = float(kGaussianMean);
    std::array<float, 3> g{kMean, kMean, kMean};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto x =
          std::size_t((std::uint64_t(places[k][0]) * std::uint64_t(gaussian_.width)) >> 32u);
      const auto y =
          std::size_t((std::uint64_t(places[k][1]) * std::uint64_t(gaussian_.height)) >> 32u);
      const Point& p = gaussian_.image[y * std::size_t(gaussian_.width) + x];
      g[0] += weights[k] * (p.x - kMean);
      g[1] += weights[k] * (p.y - kMean);
      g[2] += weights[k] * (p.z - kMean);
    }
    const auto value = std::visit([&](const auto& lookup) { return lookup(g); }, lookup_);
    ChannelVector z(dimensions());
    readStandardized({g[0], g[1], g[2]}, dimensions(), z.data());
    const ChannelVector line = decoder_ * z;
    for (int d = 0; d < dimensions(); ++d) {
      decodedValue[d] = double(value[std::size_t(d)]) / deviation_;
      linear[d] = line[d];
    }
  }

private:
  using Lookup = std::variant<TableLookup<1>, TableLookup<2>, TableLookup<3>>;

  static Lookup lookupOf(const InverseTable& table) {
    if (table.dimensions == 1)
      return TableLookup<1>(table);
    if (table.dimensions == 2)
      return TableLookup<2>(table);
    return TableLookup<3>(table);
  }

  const Gaussianized& gaussian_;
  Lookup lookup_;
  ChannelMatrix decoder_;
  double deviation_;
};

/// Covariances of the decoded values of blends less those of their linear parts, of all maps but
/// the last with the last: a mean over the lattice, by random taps and weights.
MatrixXd nonlinearPart(const std::vector<BlendedMap>& maps) {
  Eigen::Index all = 0;
  for (const BlendedMap& map : maps)
    all += map.dimensions();
  const Eigen::Index last = maps.back().dimensions();
  struct Sums {
    MatrixXd products;
    VectorXd values;
  };
  std::vector<Sums> blocks(kSamples / kSamplesOfBlock);
  tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t block) {
    Sums sums{MatrixXd::Zero(all - last, last), VectorXd::Zero(all)};
    VectorXd value(all), linear(all);
    for (std::uint32_t k = 0; k < kSamplesOfBlock; ++k) {
      const std::uint32_t sample = std::uint32_t(block) * kSamplesOfBlock + k;
      const std::array<std::uint32_t, 3> x = pcg3d({sample, 0u, 0u});
      const std::array<std::uint32_t, 3> y = pcg3d({sample, 1u, 0u});
      const std::array<std::uint32_t, 3> place = pcg3d({sample, 2u, 0u});
      Eigen::Index row = 0;
      for (const BlendedMap& map : maps) {
        map.evaluate({{{x[0], y[0]}, {x[1], y[1]}, {x[2], y[2]}}},
                     randomBlendWeights(place[0], place[1]), value.data() + row,
                     linear.data() + row);
        row += map.dimensions();
      }
      sums.values += value;
      sums.products += value.head(all - last) * value.tail(last).transpose() -
                       linear.head(all - last) * linear.tail(last).transpose();
    }
    blocks[block] = std::move(sums);
  });
  Sums whole{MatrixXd::Zero(all - last, last), VectorXd::Zero(all)};
  for (const Sums& sums : blocks) {
    whole.products += sums.products / double(kSamples);
    whole.values += sums.values / double(kSamples);
  }
  return whole.products - whole.values.head(all - last) * whole.values.tail(last).transpose();
}

InverseTable projectedTable(const InverseTable& table, const MapExemplar& map,
                            const ColorSpace& space) {
  InverseTable projected{table.dimensions, table.side, space.dimensions(), {}};
  ChannelVector d(table.channels);
  for (std::size_t cell = 0; cell < table.cellCount(); ++cell) {
    for (int c = 0; c < table.channels; ++c)
      d[c] = double(encoded(table.values[cell * std::size_t(table.channels) + std::size_t(c)],
                            map.encoding)) -
             space.moments.mean[c];
    const ChannelVector p = space.basis * d;
    for (Eigen::Index k = 0; k < p.size(); ++k)
      projected.values.push_back(float(p[k]));
  }
  return projected;
}

/// (value - mean) of each pixel on the axes of `space`.
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

/// Covariances of a map with the settled ones: of their values, and of what blends decode to.
class CrossCovariances {
public:
  CrossCovariances(const MapExemplar& map, const ColorSpace& space,
                   std::span<const SettledMap> settled, const InverseTable& table)
      : map_(map), dimensions_(space.dimensions()), values_(projectedValues(map, space)),
        deviation_(deviationOf(values_, dimensions_)), settled_(settled),
        table_(projectedTable(table, map, space)) {
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
    row = 0;
    for (const SettledMap& other : settled_) {
      const int n = other.gaussian.dimensions;
      blended_.emplace_back(other.gaussian, other.table, decoders_.block(row, row, n, n),
                            deviationOf(other.values, n));
      row += n;
    }
  }

  /// P x D, in units of the maps' deviations: covariances of the values less those of blends. The
  /// linear part of the latter, B_m E[z_m z^T] B^T at every weight, is known exactly; only the rest
  /// is left to random blends.
  [[nodiscard]] MatrixXd lackOf(const Gaussianized& gaussian) const {
    MatrixXd sum = MatrixXd::Zero(coordinates_, dimensions_);
    VectorXd z(dimensions_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      readStandardized(gaussian.image[i], dimensions_, z.data());
      sum += settledAt(i, &Gaussianized::image) * z.transpose();
    }
    const MatrixXd own = decoder(gaussian.matched);
    std::vector<BlendedMap> blended = blended_;
    blended.emplace_back(gaussian, table_, own, deviation_);
    return wanted_ - nonlinearPart(blended) -
           decoders_ * (sum / double(values_.size())) * own.transpose();
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
  InverseTable table_;              ///< the map's, on its axes
  std::vector<BlendedMap> blended_; ///< the settled ones
  Eigen::Index coordinates_ = 0;
  MatrixXd decoders_; ///< P x P: B of each settled map
  MatrixXd wanted_;   ///< P x D: covariances of the values
  MatrixXd response_; ///< P x P: of `wanted_` to the settled coordinates' shares in z
};

} // namespace

SettledMap settledMap(const MapExemplar& map, const ColorSpace& space, Gaussianized gaussian,
                      const InverseTable& table) {
  return {std::move(gaussian), projectedValues(map, space), projectedTable(table, map, space)};
}

Gaussianized withCrossCovariances(const MapExemplar& map, const ColorSpace& space,
                                  std::span<const SettledMap> settled, Gaussianized first,
                                  const InverseTable& table, const Gaussianizer& again) {
  if (settled.empty())
    return first;
  const CrossCovariances covariances(map, space, settled, table);
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
