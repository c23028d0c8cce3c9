// SPDX-License-Identifier: MIT
// Blocks of frequencies -> rings, by the distance of frequency_blocks.h.
#include "ring_fit.h"

#include "least_squares.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::multiple_kernels {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<Kernel> fittedRings(const FrequencyBlocks& blocks, const spectra::PowerPlane& power,
                                const WindowSpectrum& spectrum, std::size_t count) {
  const FrequencyBlocks radial = radialBlocks(blocks);
  constexpr std::size_t kFree = 3;
  if (radial.size() < kFree * count)
    return {};
  double energy = 0.0;
  for (const FrequencyBlock& block : radial)
    energy += 2.0 * block.count * block.power;
  if (!(energy > 0.0))
    return {};
  // The first block of each part of the energy.
  VectorXd values(Index(kFree * count));
  double before = 0.0;
  std::size_t ring = 0;
  // A support of two texels: smaller rings would have aliases, which this fit does not model.
  const double finest = -std::log(double(std::max(power.columns, power.rows / 2)));
  const double highest = double(std::min(power.columns, power.rows / 2 + 1));
  for (const FrequencyBlock& block : radial) {
    before += 2.0 * block.count * block.power;
    if (ring < count && before >= energy * (double(ring) + 0.5) / double(count)) {
      const double length = std::clamp(block.u, 1.0, highest);
      values.segment<Index(kFree)>(Index(kFree * ring)) =
          Eigen::Vector3d(std::log(energy / double(count)), std::log(length),
                          -std::log(length)); // about as wide as they are far away
      ++ring;
    }
  }
  if (ring < count)
    return {};
  const auto kernelsOf = [&](const VectorXd& from) {
    std::vector<Kernel> kernels(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double* own = from.data() + kFree * k;
      kernels[k].energy = std::exp(std::clamp(own[0], -30.0, 30.0));
      kernels[k].frequency = {std::clamp(std::exp(own[1]), 1e-3, highest), 0.0};
      kernels[k].stretch[0] = kernels[k].stretch[1] = std::exp(std::clamp(own[2], finest, 0.0));
      kernels[k].isRing = true;
    }
    return kernels;
  };
  const double least = leastPower(radial);
  const auto residualsAt = [&](const VectorXd& from) {
    constexpr double kStep = 1e-4;
    const std::vector<Kernel> kernels = kernelsOf(from);
    std::array<std::vector<Kernel>, kFree> moved; // along one parameter of each
    for (std::size_t p = 0; p < kFree; ++p) {
      VectorXd others = from;
      for (std::size_t k = 0; k < count; ++k)
        others[Index(k * kFree + p)] += kStep;
      moved[p] = kernelsOf(others);
    }
    Residuals residuals{VectorXd(Index(radial.size())),
                        MatrixXd(Index(radial.size()), from.size())};
    tbb::parallel_for(std::size_t(0), radial.size(), [&](std::size_t b) {
      const auto densityOf = [&](const Kernel& kernel) {
        return ringDensityAt(spectrum, kernel, radial[b].u);
      };
      double modelled = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        const double own = densityOf(kernels[k]);
        modelled += own;
        for (std::size_t p = 0; p < kFree; ++p)
          residuals.derivatives(Index(b), Index(k * kFree + p)) =
              (densityOf(moved[p][k]) - own) / kStep;
      }
      const auto [residual, slope] = residualOf(radial[b], least, modelled);
      residuals.values[Index(b)] = residual;
      residuals.derivatives.row(Index(b)) *= slope;
    });
    return residuals;
  };
  return kernelsOf(
      minimized(values, kLeastGain, residualsAt, [](const VectorXd&, const VectorXd& step) {
        constexpr double kMost = 0.7;
        return (std::min(1.0, kMost / std::max(step.cwiseAbs().maxCoeff(), 1e-300)) * step).eval();
      }));
}

} // namespace lichen::multiple_kernels
