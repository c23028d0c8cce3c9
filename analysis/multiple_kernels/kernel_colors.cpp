// SPDX-License-Identifier: MIT
// Cross-spectra, each frequency shared among the kernels as their powers there are -> factors.
//
// [MKN12] gives each kernel a colour. Here a kernel has the covariance of its frequencies, and
// signs of its own for each of that covariance's axes: docs/decisions/010-multiple-kernels.md.
#include "kernel_colors.h"

#include "gaussian/gaussian_distribution.h"
#include "transport/covariance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::multiple_kernels {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using random_phase::MapSpectrum;

/// The real part of the sum over frequencies of crossPower() times the kernel's share of the power
/// there.
std::vector<MatrixXd> sharedSpectra(const std::vector<MapSpectrum>& maps,
                                    const WindowSpectrum& spectrum,
                                    const std::vector<Kernel>& kernels, Index channels) {
  const random_phase::PowerPlane plane = random_phase::powerPlane(maps);
  const int half = plane.rows / 2;
  // Rows by themselves and then summed in order, so that threads do not change the result.
  std::vector<std::vector<MatrixXd>> ofRows(std::size_t(plane.rows));
  // Powers change slowly: rings are looked up at whole frequencies.
  std::vector<std::vector<double>> rings(kernels.size());
  for (std::size_t k = 0; k < kernels.size(); ++k)
    if (kernels[k].isRing)
      for (int f = 0; f <= int(std::hypot(plane.columns, half)) + 1; ++f)
        rings[k].push_back(ringDensityAt(spectrum, kernels[k], f));
  tbb::parallel_for(-half, half + 1, [&](int v) {
    std::vector<MatrixXd> sums(kernels.size(), MatrixXd::Zero(channels, channels));
    std::vector<double> powers(kernels.size());
    for (int u = 0; u < plane.columns; ++u) {
      if (u == 0 && v == 0)
        continue;
      double all = 0.0;
      for (std::size_t k = 0; k < kernels.size(); ++k) {
        powers[k] = kernels[k].isRing ? rings[k][std::size_t(std::lround(std::hypot(u, v)))]
                                      : sampledDensityAt(spectrum, kernels[k],
                                                         random_phase::texelsOf(plane), u, v);
        all += powers[k];
      }
      if (!(all > 0.0))
        continue;
      const MatrixXd own = (u == 0 ? 1.0 : 2.0) * random_phase::crossPower(maps, u, v).real();
      for (std::size_t k = 0; k < kernels.size(); ++k)
        sums[k] += powers[k] / all * own;
    }
    ofRows[std::size_t(v + half)] = std::move(sums);
  });
  std::vector<MatrixXd> result(kernels.size(), MatrixXd::Zero(channels, channels));
  for (const std::vector<MatrixXd>& row : ofRows)
    for (std::size_t k = 0; k < kernels.size(); ++k)
      result[k] += row[k];
  return result;
}

/// The strongest axes of a covariance, as columns whose products with their transposes sum to it.
MatrixXd strongestAxes(const MatrixXd& covariance) {
  const auto axes = transport::principalAxes(covariance);
  const Index channels = covariance.rows();
  MatrixXd columns = MatrixXd::Zero(channels, kWaves);
  for (Index k = 0; k < std::min<Index>(kWaves, channels); ++k) {
    const Index axis = channels - 1 - k; // in ascending order
    columns.col(k) =
        std::sqrt(std::max(0.0, axes.eigenvalues()[axis])) * axes.eigenvectors().col(axis);
  }
  return columns;
}

} // namespace

std::vector<MatrixXd> kernelColors(const std::vector<MapSpectrum>& maps,
                                   const WindowSpectrum& spectrum,
                                   const std::vector<Kernel>& kernels) {
  const std::vector<Index> first = random_phase::firstChannels(maps);
  const Index channels = first.back();
  if (channels == 0)
    return std::vector<MatrixXd>(kernels.size(), MatrixXd(0, kWaves));
  const double deviation = gaussian::kGaussianDeviation;
  const MatrixXd weights = random_phase::powerWeights(maps);
  std::vector<MatrixXd> matrices = sharedSpectra(maps, spectrum, kernels, channels);
  MatrixXd whole = MatrixXd::Zero(channels, channels), fitted = whole;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    whole += matrices[k];
    if (const double energy = weights.cwiseProduct(matrices[k]).sum(); energy > 0.0)
      matrices[k] *= kernels[k].energy / energy;
    fitted += matrices[k];
  }
  random_phase::setMapCovariances(whole, maps);
  const MatrixXd correction = transport::covarianceMap(fitted, whole);
  std::vector<MatrixXd> colors;
  for (const MatrixXd& matrix : matrices)
    colors.push_back(deviation * strongestAxes(correction * matrix * correction));
  // What weaker combinations had is given to the others, map by map.
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Index count = first[m + 1] - first[m];
    if (count == 0)
      continue;
    MatrixXd kept = MatrixXd::Zero(count, count);
    for (const MatrixXd& color : colors)
      kept += color.middleRows(first[m], count) * color.middleRows(first[m], count).transpose();
    const MatrixXd wanted = deviation * deviation * whole.block(first[m], first[m], count, count);
    const MatrixXd map = transport::covarianceMap(kept, wanted);
    for (MatrixXd& color : colors)
      color.middleRows(first[m], count) = (map * color.middleRows(first[m], count)).eval();
  }
  return colors;
}

} // namespace lichen::multiple_kernels
