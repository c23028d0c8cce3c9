// SPDX-License-Identifier: MIT
// Gaussian image of a map (width * height points), Gaussian images and values of the earlier maps
// -> the Gaussian image with values exchanged.
//
// Below, z is G with mean 0 and variance 1; y is a value minus its mean on the D axes of its map,
// in units of the map's standard deviation; B = E[y z^T]. The P coordinates of all settled maps are
// stacked. The difference between E[y_settled y^T] and the covariances of decoded blends is P x D.
// Adding a share K (P x D) of the settled coordinates to z increases the linear part of the blends'
// covariances, B_settled E[z_settled z^T] B^T, by B_settled E[z_settled z_settled^T] K B^T. The
// points are then matched again.
// Source: docs/theory.md, "Maps that belong together".
#include "cross_covariance.h"

#include "exemplar/value_encoding.h"
#include "table_lookup.h"
#include "transport/covariance.h"
#include "transport/rank_matching.h"

#include <lichen/lattice.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace lichen::gaussian {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

/// In correlations: about the standard error of the correlations of blends.
constexpr double kNegligible = 3e-4;

/// Exchanging values inside ties has less effect than in a continuum; a gain compensates. With six
/// of these passes the plaster wall's bias is 2.2 %, with three (and fewer blends) 4.2 %.
constexpr int kMostPassesOnLine = 6;
constexpr double kMostGain = 4.0;

/// A pass that reduces the error by a smaller share has reached the limit of exchanging.
constexpr double kLeastReduction = 0.1;

/// Root mean square, in standard deviations: a pixel's Gaussian value then still gets 99 % of its
/// variance from the pixel's own value. Photographs need 0.01 to 0.03.
constexpr double kLargestMove = 0.1;

/// Relative to the product of the shares that two axes have in their maps' variances. An axis below
/// it cannot change covariances without too large moves. With a tenth of it the moves of the
/// photographed sets' slopes grow by 9 and 23 %.
constexpr double kDamping = 1e-3;

/// A few exchanges suffice to match points that moved less than the distance to their neighbours.
constexpr transport::TransportOptions kExchanges{.swapRounds = 1, .exactRounds = 1};

/// Columns of a field per summed block.
constexpr Index kColumnsOfBlock = 4096;

DecodedBlends decodedBlends(const Gaussianized& gaussian, const InverseTable& table);

MatrixXf standardized(const std::vector<Point>& points, int dimensions) {
  MatrixXf z(dimensions, Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<float, 3> p{points[i].x, points[i].y, points[i].z};
    for (int d = 0; d < dimensions; ++d)
      z(d, Index(i)) = (p[std::size_t(d)] - float(gaussian::kGaussianMean)) /
                       float(gaussian::kGaussianDeviation);
  }
  return z;
}

/// E[a b^T] over `count` columns. left(begin, n) returns n columns of a, one row per coordinate.
/// Blocks are added in order, whichever thread sums them, so the result is deterministic.
template <class Left, class Right>
MatrixXd meanProduct(Index count, const Left& left, const Right& right) {
  std::vector<MatrixXd> sums(std::size_t((count + kColumnsOfBlock - 1) / kColumnsOfBlock));
  tbb::parallel_for(std::size_t(0), sums.size(), [&](std::size_t block) {
    const Index begin = Index(block) * kColumnsOfBlock;
    const Index n = std::min(kColumnsOfBlock, count - begin);
    sums[block].noalias() = left(begin, n) * right(begin, n).transpose();
  });
  for (std::size_t block = 1; block < sums.size(); ++block)
    sums[0] += sums[block];
  return sums[0] / double(count);
}

/// Values of some pixels minus the mean, on the axes of `space`: D x columns.
MatrixXd valuesOf(const MapExemplar& map, const exemplar::ColorSpace& space,
                  const std::vector<Index>& pixels) {
  const auto channels = Index(map.channels.size());
  MatrixXd values(channels, Index(pixels.size()));
  for (Index column = 0; column < values.cols(); ++column)
    for (Index c = 0; c < channels; ++c)
      values(c, column) =
          double(map.values[std::size_t(pixels[std::size_t(column)] * channels + c)]) -
          space.moments.mean[c];
  return space.basis * values;
}

/// The table's values minus the mean, on the axes of `space`, as valuesOf() returns for pixels.
InverseTable onAxes(const InverseTable& table, const MapExemplar& map,
                    const exemplar::ColorSpace& space) {
  InverseTable projected{table.dimensions, table.side, space.dimensions(), {}};
  exemplar::ChannelVector d(table.channels);
  for (std::size_t cell = 0; cell < table.cellCount(); ++cell) {
    for (int c = 0; c < table.channels; ++c)
      d[c] = double(exemplar::storedOfTable(
                 table.values[cell * std::size_t(table.channels) + std::size_t(c)], map.encoding)) -
             space.moments.mean[c];
    const exemplar::ChannelVector p = space.basis * d;
    for (Index k = 0; k < p.size(); ++k)
      projected.values.push_back(float(p[k]));
  }
  return projected;
}

/// The pixels of `other` at the same relative positions as `n` pixels of `map`.
std::vector<Index> samePlaces(const MapExemplar& other, const MapExemplar& map, Index begin,
                              Index n) {
  std::vector<Index> pixels(std::size_t(n), 0);
  for (Index k = 0; k < n; ++k) {
    const Index column = (begin + k) % map.width, row = (begin + k) / map.width;
    const Index x = (2 * column + 1) * other.width / (2 * map.width);
    const Index y = (2 * row + 1) * other.height / (2 * map.height);
    pixels[std::size_t(k)] = y * other.width + x;
  }
  return pixels;
}

/// The columns of a matrix, as meanProduct() takes them.
auto columnsOf(const MatrixXf& matrix) {
  return [&](Index begin, Index n) { return MatrixXd(matrix.middleCols(begin, n).cast<double>()); };
}

/// B of a map: the change of the decoded values per step of z, averaged over the Gaussian (Stein's
/// lemma).
MatrixXd decoderOf(const MapExemplar& map, const exemplar::ColorSpace& space,
                   const MatrixXf& matched) {
  const auto values = [&](Index begin, Index n) {
    return valuesOf(map, space, samePlaces(map, map, begin, n));
  };
  return meanProduct(matched.cols(), values, columnsOf(matched)) / space.deviation();
}

/// Settled maps with stacked coordinates, sampled at the pixels of another map.
class SettledMaps {
public:
  SettledMaps(const MapExemplar& map, std::span<const SettledMap> settled)
      : map_(map), settled_(settled) {
    for (const SettledMap& other : settled_)
      coordinates_ += other.space.dimensions();
    decoders_ = MatrixXd::Zero(coordinates_, coordinates_);
    eachMap([&](const SettledMap& other, Index row, Index n) {
      decoders_.block(row, row, n, n) = decoderOf(*other.map, other.space, other.matched);
    });
  }

  /// B of all maps, as diagonal blocks.
  [[nodiscard]] const MatrixXd& decoders() const { return decoders_; }

  /// One field of all maps at `n` pixels.
  [[nodiscard]] MatrixXd fieldAt(MatrixXf SettledMap::*field, Index begin, Index n) const {
    return stacked(n, [&](const SettledMap& other) {
      return MatrixXd((other.*field)(Eigen::all, samePlaces(*other.map, map_, begin, n))
                          .template cast<double>());
    });
  }

  [[nodiscard]] MatrixXd valuesAt(Index begin, Index n) const {
    return stacked(n, [&](const SettledMap& other) {
      return MatrixXd(valuesOf(*other.map, other.space, samePlaces(*other.map, map_, begin, n)) /
                      other.space.deviation());
    });
  }

  [[nodiscard]] MatrixXd blendsAt(Index begin, Index n) const {
    return stacked(
        n, [&](const SettledMap& other) { return columnsOf(other.blends.gaussian)(begin, n); });
  }

  [[nodiscard]] MatrixXd decodedBlendsAt(Index begin, Index n) const {
    return stacked(n, [&](const SettledMap& other) {
      return MatrixXd(columnsOf(other.blends.values)(begin, n) / other.space.deviation());
    });
  }

private:
  void eachMap(const auto& visit) const {
    Index row = 0;
    for (const SettledMap& other : settled_) {
      visit(other, row, Index(other.space.dimensions()));
      row += other.space.dimensions();
    }
  }

  /// `n` columns of all maps, one row per coordinate.
  [[nodiscard]] MatrixXd stacked(Index n, const auto& columnsOfMap) const {
    MatrixXd all(coordinates_, n);
    eachMap([&](const SettledMap& other, Index row, Index rows) {
      all.middleRows(row, rows) = columnsOfMap(other);
    });
    return all;
  }

  const MapExemplar& map_;
  std::span<const SettledMap> settled_;
  Index coordinates_ = 0;
  MatrixXd decoders_; ///< P x P
};

/// Covariances of a map with the settled ones: of their values and of decoded blends.
class CrossCovariances {
public:
  CrossCovariances(const MapExemplar& map, const exemplar::ColorSpace& space,
                   std::span<const SettledMap> settled, const InverseTable& table)
      : map_(map), space_(space), settled_(map, settled), deviation_(space.deviation()),
        table_(onAxes(table, map, space)) {
    const Index count = Index(map.width) * map.height;
    const auto own = [&](Index begin, Index n) {
      return valuesOf(map_, space_, samePlaces(map_, map_, begin, n));
    };
    const auto others = [&](Index begin, Index n) { return settled_.valuesAt(begin, n); };
    const auto gaussian = [&](Index begin, Index n) {
      return settled_.fieldAt(&SettledMap::matched, begin, n);
    };
    wanted_ = meanProduct(count, others, own) / deviation_;
    response_ = settled_.decoders() * meanProduct(count, gaussian, gaussian);
  }

  /// P x D, in units of the maps' standard deviations: covariances of the values minus covariances
  /// of blends. The linear part of the latter, B_m E[z_m z^T] B^T at every weight, is known
  /// exactly; only the rest is estimated from random blends.
  [[nodiscard]] MatrixXd missingIn(const Gaussianized& gaussian) const {
    const MatrixXf image = standardized(gaussian.image, gaussian.dimensions);
    const MatrixXd decoder =
        decoderOf(map_, space_, standardized(gaussian.matched, gaussian.dimensions));
    const auto others = [&](Index begin, Index n) {
      return settled_.fieldAt(&SettledMap::image, begin, n);
    };
    return wanted_ - nonlinearPart(decodedBlends(gaussian, table_), decoder) -
           settled_.decoders() * meanProduct(image.cols(), others, columnsOf(image)) *
               decoder.transpose();
  }

  /// P x D: how much of each settled coordinate to add to z so that the linear part grows by
  /// `missing`; least squares with kDamping. The normal equations are diagonal on the axes of
  /// response^T response and B^T B, whose eigenvalues are squares of gains.
  [[nodiscard]] MatrixXd slopeFor(const MatrixXd& missing, const Gaussianized& gaussian) const {
    const MatrixXd decoder =
        decoderOf(map_, space_, standardized(gaussian.matched, gaussian.dimensions));
    const auto left = transport::principalAxes(MatrixXd(response_.transpose() * response_));
    const auto right = transport::principalAxes(MatrixXd(decoder.transpose() * decoder));
    MatrixXd part = left.eigenvectors().transpose() * response_.transpose() * missing * decoder *
                    right.eigenvectors();
    for (Index r = 0; r < part.rows(); ++r)
      for (Index c = 0; c < part.cols(); ++c)
        part(r, c) /= left.eigenvalues()[r] * right.eigenvalues()[c] + kDamping;
    return left.eigenvectors() * part * right.eigenvectors().transpose();
  }

  /// z + slope^T z_settled of the pixels, D x pixels. In two and three dimensions moves are at most
  /// kLargestMove.
  [[nodiscard]] MatrixXf moved(const MatrixXf& z, const MatrixXd& slope) const {
    MatrixXf moves(z.rows(), z.cols());
    for (Index begin = 0; begin < z.cols(); begin += kColumnsOfBlock) {
      const Index n = std::min(kColumnsOfBlock, z.cols() - begin);
      moves.middleCols(begin, n) =
          (slope.transpose() * settled_.fieldAt(&SettledMap::matched, begin, n)).cast<float>();
    }
    if (moves.rows() > 1) {
      const double size = std::sqrt(moves.cast<double>().squaredNorm() / double(moves.size()));
      moves *= float(kLargestMove / std::max(size, kLargestMove));
    }
    return z + moves;
  }

private:
  /// Covariances of the decoded values of blends minus covariances of their linear parts.
  [[nodiscard]] MatrixXd nonlinearPart(const DecodedBlends& blends, const MatrixXd& decoder) const {
    const Index count = blends.values.cols();
    const auto decodedOthers = [&](Index begin, Index n) {
      return settled_.decodedBlendsAt(begin, n);
    };
    const auto decodedOwn = [&](Index begin, Index n) {
      return MatrixXd(blends.values.middleCols(begin, n).cast<double>() / deviation_);
    };
    const auto others = [&](Index begin, Index n) { return settled_.blendsAt(begin, n); };
    const auto one = [](Index, Index n) { return MatrixXd(MatrixXd::Ones(1, n)); };
    return meanProduct(count, decodedOthers, decodedOwn) -
           meanProduct(count, decodedOthers, one) * meanProduct(count, one, decodedOwn) -
           settled_.decoders() * meanProduct(count, others, columnsOf(blends.gaussian)) *
               decoder.transpose();
  }

  const MapExemplar& map_;
  const exemplar::ColorSpace& space_;
  SettledMaps settled_;
  double deviation_;
  InverseTable table_; ///< the map's table, on its axes
  MatrixXd wanted_;    ///< P x D: covariances of the values
  MatrixXd response_;  ///< P x P: response of `wanted_` to the settled coordinates' shares in z
};

std::vector<Point> pointsOf(const MatrixXf& columns) {
  std::vector<Point> points(std::size_t(columns.cols()));
  for (Index i = 0; i < columns.cols(); ++i)
    points[std::size_t(i)] = {columns(0, i), columns.rows() > 1 ? columns(1, i) : 0.0f,
                              columns.rows() > 2 ? columns(2, i) : 0.0f};
  return points;
}

/// The order of the values of a map with one dimension.
transport::TieOrder tieOrderOf(const MapExemplar& map, const exemplar::ColorSpace& space) {
  std::vector<float> values(std::size_t(map.width) * std::size_t(map.height));
  const auto count = Index(values.size());
  for (Index begin = 0; begin < count; begin += kColumnsOfBlock) {
    const Index n = std::min(kColumnsOfBlock, count - begin);
    const MatrixXd block = valuesOf(map, space, samePlaces(map, map, begin, n));
    for (Index k = 0; k < n; ++k)
      values[std::size_t(begin + k)] = float(block(0, k));
  }
  return transport::TieOrder(values);
}

} // namespace

SettledMap::SettledMap(const MapExemplar& exemplar, exemplar::ColorSpace colorSpace,
                       const Gaussianized& gaussian, const InverseTable& table)
    : map(&exemplar), space(std::move(colorSpace)),
      matched(standardized(gaussian.matched, gaussian.dimensions)),
      image(standardized(gaussian.image, gaussian.dimensions)),
      blends(decodedBlends(gaussian, onAxes(table, exemplar, space))) {}

bool isNegligible(const MatrixXd& missing) {
  return missing.norm() <= kNegligible * std::sqrt(double(missing.size()));
}

Gaussianized withCrossCovariances(const MapExemplar& map, const exemplar::ColorSpace& space,
                                  std::span<const SettledMap> settled, Gaussianized alone,
                                  const InverseTable& table, gaussian::BorderTreatment borders,
                                  ProgressPart progress) {
  const CrossCovariances covariances(map, space, settled, table);
  const bool onLine = space.dimensions() == 1;
  const int passes = onLine ? kMostPassesOnLine : 1;
  const transport::TieOrder ties = onLine ? tieOrderOf(map, space) : transport::TieOrder({});
  const MatrixXf start = standardized(alone.matched, alone.dimensions);
  Gaussianized best = std::move(alone);
  MatrixXd missing = covariances.missingIn(best);
  MatrixXd slope = MatrixXd::Zero(missing.rows(), missing.cols());
  double gain = 1.0;
  for (int pass = 0; pass < passes && !isNegligible(missing); ++pass) {
    progress.reach(double(pass) / passes);
    slope += gain * covariances.slopeFor(missing, best);
    const MatrixXf moved = covariances.moved(start, slope);
    transport::TransportOptions exchanges = kExchanges;
    exchanges.progress = progress.part(double(pass) / passes, double(pass + 1) / passes);
    Gaussianized next =
        onLine
            ? gaussianizeInOrder(best, ties.by({moved.data(), std::size_t(moved.size())}), borders)
            : gaussianizeNear(best, pointsOf(moved), borders, exchanges);
    const MatrixXd left = covariances.missingIn(next);
    if (left.norm() >= missing.norm())
      break;
    const double reduction = 1.0 - left.cwiseProduct(missing).sum() / missing.squaredNorm();
    best = std::move(next);
    missing = left;
    if (reduction < kLeastReduction)
      break;
    gain = std::min(gain / reduction, kMostGain);
  }
  return best;
}

// Gaussian image (width * height points) and table -> blends (D, and channels, by 2^18).
namespace {

/// The quantity measured on blends has about a fifth of the values' standard deviation on
/// photographs, so the correlations found have standard errors of 4e-4.
constexpr std::uint32_t kBlends = 1u << 18u;
constexpr std::uint32_t kBlendsOfBlock = 1u << 12u;

/// The pixel at a position with coordinates in [0, 2^32).
const Point& pixelAt(const Gaussianized& gaussian, std::uint32_t x, std::uint32_t y) {
  const auto column = std::size_t((std::uint64_t(x) * std::uint64_t(gaussian.width)) >> 32u);
  const auto row = std::size_t((std::uint64_t(y) * std::uint64_t(gaussian.height)) >> 32u);
  return gaussian.image[row * std::size_t(gaussian.width) + column];
}

std::array<float, 3> randomBlend(const Gaussianized& gaussian, std::uint32_t sample) {
  constexpr auto kMean = float(gaussian::kGaussianMean);
  const std::array<std::uint32_t, 3> x = pcg3d({sample, 0u, 0u});
  const std::array<std::uint32_t, 3> y = pcg3d({sample, 1u, 0u});
  const std::array<std::uint32_t, 3> place = pcg3d({sample, 2u, 0u});
  const std::array<float, 3> weights = randomBlendWeights(place[0], place[1]);
  std::array<float, 3> g{kMean, kMean, kMean};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& p = pixelAt(gaussian, x[k], y[k]);
    g[0] += weights[k] * (p.x - kMean);
    g[1] += weights[k] * (p.y - kMean);
    g[2] += weights[k] * (p.z - kMean);
  }
  return g;
}

template <std::size_t kDimensions>
DecodedBlends blendsThrough(const Gaussianized& gaussian, const InverseTable& table) {
  const TableLookup<kDimensions> lookup(table);
  DecodedBlends blends{Eigen::MatrixXf(gaussian.dimensions, kBlends),
                       Eigen::MatrixXf(table.channels, kBlends)};
  tbb::parallel_for(0u, kBlends / kBlendsOfBlock, [&](std::uint32_t block) {
    for (std::uint32_t k = 0; k < kBlendsOfBlock; ++k) {
      const std::uint32_t sample = block * kBlendsOfBlock + k;
      const std::array<float, 3> g = randomBlend(gaussian, sample);
      const auto value = lookup(g);
      for (Eigen::Index d = 0; d < blends.gaussian.rows(); ++d)
        blends.gaussian(d, sample) = (g[std::size_t(d)] - float(gaussian::kGaussianMean)) /
                                     float(gaussian::kGaussianDeviation);
      for (Eigen::Index c = 0; c < blends.values.rows(); ++c)
        blends.values(c, sample) = value[std::size_t(c)];
    }
  });
  return blends;
}

DecodedBlends decodedBlends(const Gaussianized& gaussian, const InverseTable& table) {
  if (table.dimensions == 1)
    return blendsThrough<1>(gaussian, table);
  if (table.dimensions == 2)
    return blendsThrough<2>(gaussian, table);
  return blendsThrough<3>(gaussian, table);
}

} // namespace

} // namespace lichen::gaussian
