// SPDX-License-Identifier: MIT
// Cross-spectra, summed over the box of each cosine -> vectors.
//
// [LRP14] leaves colour to its supplement. Here one phase serves all channels, which preserves
// their cross-spectra. For the matrix of a box, with the eigenvectors e_k and eigenvalues l_k, a
// vector is sum_k (+-1) sqrt(l_k) e_k, or of any unitary combination of these columns. The signs of
// variant v are row v of a Hadamard matrix, so the mean of (vector vector^H) over the variants is
// the matrix itself: docs/decisions/009-local-random-phase.md.
#include "cosine_vectors.h"

#include "gaussian/gaussian_distribution.h"
#include "transport/covariance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lichen::local_random_phase {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Sums crossPower() over the frequencies of a box, column 0 half.
MatrixXcd crossSpectra(const std::vector<MapSpectrum>& maps, const FrequencyBox& box,
                       Index channels) {
  MatrixXcd sum = MatrixXcd::Zero(channels, channels);
  for (int v = box.top; v < box.bottom; ++v)
    for (int u = box.left; u < box.right; ++u) {
      if (u == 0 && v == 0)
        continue;
      sum += (u == 0 ? 0.5 : 1.0) * random_phase::crossPower(maps, u, v);
    }
  return sum;
}

/// The factor on a vector that makes the sum of its squares real and positive: it is then as real
/// as a factor can make it.
Complex towardsReal(const Complex& sumOfSquares) {
  const double length = std::abs(sumOfSquares);
  return length > 0.0 ? std::sqrt(std::conj(sumOfSquares) / length) : Complex(1.0, 0.0);
}

/// sqrt(l_k) e_k as columns.
MatrixXcd rootColumns(const MatrixXcd& hermitian) {
  const auto axes = transport::principalAxes(hermitian);
  MatrixXcd columns = axes.eigenvectors();
  for (Index k = 0; k < columns.cols(); ++k) {
    columns.col(k) *= std::sqrt(std::max(0.0, axes.eigenvalues()[k]));
    columns.col(k) *= towardsReal(columns.col(k).array().square().sum());
  }
  return columns;
}

/// The columns rotated among each other so that luminance follows the first one only; the product
/// with their adjoint is the same.
MatrixXcd withLuminanceFirst(MatrixXcd columns, const VectorXd& luminance) {
  VectorXcd along = columns.adjoint() * luminance.cast<Complex>();
  if (!(along.squaredNorm() > 0.0))
    return columns;
  Complex factor;
  double length = 0.0;
  VectorXcd normal(along.size() - 1), workspace(columns.rows());
  along.makeHouseholder(normal, factor, length);
  columns.applyHouseholderOnTheRight(normal, std::conj(factor), workspace.data());
  for (Index k = 0; k < columns.cols(); ++k)
    columns.col(k) *= towardsReal(columns.col(k).array().square().sum());
  return columns;
}

double hadamardSign(Index row, Index column) {
  return std::popcount(std::uint64_t(row) & std::uint64_t(column)) % 2 == 0 ? 1.0 : -1.0;
}

/// The covariance of the noise in the channels of one map: half the mean over the variants.
MatrixXd covarianceOf(const CosineVectors& vectors, Index first, Index channels) {
  MatrixXd sum = MatrixXd::Zero(channels, channels);
  for (const MatrixXd& own : vectors.vectors) {
    const auto rows = own.middleRows(first, channels);
    sum += rows * rows.transpose();
  }
  return sum / (2.0 * vectors.variants);
}

} // namespace

CosineVectors cosineVectors(const std::vector<MapSpectrum>& maps,
                            const std::vector<Cosine>& cosines) {
  const std::vector<Index> first = random_phase::firstChannels(maps);
  const Index channels = first.back();
  CosineVectors result;
  result.variants = int(std::bit_ceil(std::uint64_t(std::max<Index>(1, channels))));
  result.vectors.assign(cosines.size(), MatrixXd::Zero(channels, result.variants));
  result.phases.assign(cosines.size(), MatrixXd::Zero(Index(maps.size()), result.variants));
  if (channels == 0)
    return result;

  const MatrixXd weights = random_phase::powerWeights(maps);
  // The matrix of each box has the energy of its cosine, and together they have the covariance.
  std::vector<MatrixXcd> matrices(cosines.size());
  MatrixXd whole = MatrixXd::Zero(channels, channels); // of the exemplar
  MatrixXd fitted = whole;
  tbb::parallel_for(std::size_t(0), cosines.size(), [&](std::size_t j) {
    matrices[j] = crossSpectra(maps, cosines[j].box, channels);
  });
  for (std::size_t j = 0; j < cosines.size(); ++j) {
    whole += 2.0 * matrices[j].real();
    if (const double energy = weights.cwiseProduct(matrices[j].real()).sum(); energy > 0.0)
      matrices[j] *= cosines[j].energy / energy;
    fitted += matrices[j].real();
  }
  VectorXd luminance = VectorXd::Zero(channels);
  for (std::size_t m = 0; m < maps.size(); ++m)
    for (std::size_t c = 0; c < maps[m].luminance.size(); ++c)
      luminance[first[m] + Index(c)] = maps[m].luminance[c];
  random_phase::setMapCovariances(whole, maps);
  const MatrixXd correction = transport::covarianceMap(fitted, whole);
  const double deviation = gaussian::kGaussianDeviation;
  tbb::parallel_for(std::size_t(0), cosines.size(), [&](std::size_t j) {
    const MatrixXcd roots =
        withLuminanceFirst(rootColumns(correction * matrices[j] * correction), luminance);
    for (Index v = 0; v < result.variants; ++v) {
      VectorXcd vector = VectorXcd::Zero(channels);
      for (Index k = 0; k < channels; ++k)
        vector += hadamardSign(v, k) * roots.col(k);
      // A cosine of amplitude a has the variance a^2 / 2.
      vector *= std::numbers::sqrt2 * deviation;
      for (std::size_t m = 0; m < maps.size(); ++m) {
        const auto own = vector.segment(first[m], first[m + 1] - first[m]);
        const Complex factor = towardsReal(own.array().square().sum());
        result.vectors[j].block(first[m], v, own.size(), 1) = (own * factor).real();
        result.phases[j](Index(m), v) = -std::arg(factor) / (2.0 * std::numbers::pi);
      }
    }
  });
  // What of a map does not follow one phase is lost: its covariance is restored.
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Index count = first[m + 1] - first[m];
    if (count == 0)
      continue;
    const MatrixXd wanted = deviation * deviation * whole.block(first[m], first[m], count, count);
    const MatrixXd map = transport::covarianceMap(covarianceOf(result, first[m], count), wanted);
    for (MatrixXd& vectors : result.vectors)
      vectors.middleRows(first[m], count) = (map * vectors.middleRows(first[m], count)).eval();
  }
  return result;
}

} // namespace lichen::local_random_phase
