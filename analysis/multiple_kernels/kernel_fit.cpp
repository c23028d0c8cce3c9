// SPDX-License-Identifier: MIT
// Power plane -> blocks of frequencies -> kernels, by the likelihood of the blocks' mean powers.
//
// The sum over blocks of n (P / S - 1 - log(P / S)), the Itakura-Saito distance, is the likelihood
// of the powers P of a Gaussian field of spectrum S [W53]. Levenberg and Marquardt's
// method minimises it as a sum of squares: docs/decisions/031-kernels.md.
#include "kernel_fit.h"

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace lichen::multiple_kernels {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using spectra::FrequencyBox;
using spectra::PowerPlane;

/// Frequencies around (u, v) with a common mean power.
struct Block {
  double u = 0.0, v = 0.0;
  double count = 0.0; ///< those of column 0 count half
  double power = 0.0; ///< mean
};

/// This share of the mean power is added to all powers: nobody sees less.
constexpr double kLeastPower = 1e-3;

double leastPower(const std::vector<Block>& blocks, double share = kLeastPower) {
  double sum = 0.0, count = 0.0;
  for (const Block& block : blocks) {
    sum += block.count * block.power;
    count += block.count;
  }
  return std::max(share * sum / std::max(count, 1.0), 1e-300);
}

/// Blocks whose sides are an eighth of their distance from the frequency 0.
std::vector<Block> blocksOf(const PowerPlane& power) {
  constexpr int kSidesToZero = 8, kMostSide = 16;
  std::vector<Block> blocks;
  const int half = power.rows / 2;
  // Squares of 16, cut in four until they are small enough.
  const std::function<void(int, int, int)> add = [&](int left, int corner, int side) {
    const int top = std::max(corner, -half);
    const int right = std::min(left + side, power.columns);
    const int bottom = std::min(corner + side, half + 1);
    if (left >= right || top >= bottom)
      return;
    const int nearV = top > 0 ? top : std::max(1 - bottom, 0);
    if (side > 1 && side * side * kSidesToZero * kSidesToZero > left * left + nearV * nearV) {
      for (const int y : {corner, corner + side / 2})
        for (const int x : {left, left + side / 2})
          add(x, y, side / 2);
      return;
    }
    Block block;
    double sum = 0.0;
    for (int v = top; v < bottom; ++v)
      for (int u = left; u < right; ++u) {
        const double weight = u == 0 && v == 0 ? 0.0 : u == 0 ? 0.5 : 1.0;
        block.count += weight;
        sum += weight * power.at(u, v);
      }
    if (!(block.count > 0.0))
      return;
    block.u = 0.5 * (left + right - 1);
    block.v = 0.5 * (top + bottom - 1);
    block.power = sum / block.count;
    blocks.push_back(block);
  };
  const int first = -(half + kMostSide) / kMostSide * kMostSide;
  for (int top = first; top <= half; top += kMostSide)
    for (int left = 0; left < power.columns; left += kMostSide)
      add(left, top, kMostSide);
  return blocks;
}

/// The signed root of the distance of one block, whose square is the distance, and its derivative
/// by the modelled power.
std::array<double, 2> residualOf(const Block& block, double least, double modelled) {
  const double ratio = (block.power + least) / (modelled + least);
  const double distance = std::max(0.0, ratio - 1.0 - std::log(ratio));
  const double root = std::copysign(std::sqrt(2.0 * block.count * distance), ratio - 1.0);
  constexpr double kNear = 1e-6; // where the quotient is 0 / 0
  const double slope =
      std::abs(ratio - 1.0) < kNear ? -std::sqrt(block.count) : block.count * (1.0 - ratio) / root;
  return {root, slope / (modelled + least)};
}

/// The power of kernels at each block.
std::vector<double> modelOf(const std::vector<Block>& blocks, const WindowSpectrum& spectrum,
                            const std::vector<Kernel>& kernels) {
  std::vector<double> modelled(blocks.size(), 0.0);
  tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
    const Block& block = blocks[b];
    for (const Kernel& kernel : kernels)
      modelled[b] += kernel.isRing ? ringDensityAt(spectrum, kernel, std::hypot(block.u, block.v))
                                   : densityAt(spectrum, kernel, block.u, block.v);
  });
  return modelled;
}

/// The parameters that are fitted: the first `free` of each kernel, in the order of KernelSlopes.
struct Parameters {
  std::vector<Kernel> kernels; ///< those of the others
  std::size_t free = kKernelParameters;
  std::array<double, 2> highest{}; ///< frequencies of the plane
  double finest = 0.0;             ///< logarithm of the least stretch

  [[nodiscard]] VectorXd values() const {
    VectorXd all(Index(kernels.size() * free));
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      const Kernel& kernel = kernels[k];
      const std::array own{std::log(kernel.energy),     kernel.frequency[0],
                           kernel.frequency[1],         std::log(kernel.stretch[0]),
                           std::log(kernel.stretch[1]), kernel.shear};
      for (std::size_t p = 0; p < free; ++p)
        all[Index(k * free + p)] = own[p];
    }
    return all;
  }

  /// A step shortened until no kernel changes much: by its own width, or by a factor.
  [[nodiscard]] VectorXd limited(const VectorXd& values, VectorXd step) const {
    constexpr double kMost = 0.7;
    double longest = 0.0;
    const std::vector<Kernel> here = with(values);
    for (std::size_t k = 0; k < here.size(); ++k) {
      const double* own = step.data() + k * free;
      longest = std::max(longest, std::abs(own[0]));
      if (free < kKernelParameters)
        continue;
      const auto [across, down] = here[k].stretch;
      for (const double part : {across * own[1], down * own[2], own[3], own[4], own[5] / across})
        longest = std::max(longest, std::abs(part));
    }
    return std::min(1.0, kMost / std::max(longest, 1e-300)) * step;
  }

  [[nodiscard]] std::vector<Kernel> with(const VectorXd& values) const {
    std::vector<Kernel> result = kernels;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const double* own = values.data() + k * free;
      // A step of the solver may go anywhere.
      constexpr double kMostLog = 30.0;
      result[k].energy = std::exp(std::clamp(own[0], -kMostLog, kMostLog));
      if (free < kKernelParameters)
        continue;
      result[k].frequency = {std::clamp(own[1], -highest[0], highest[0]),
                             std::clamp(own[2], -highest[1], highest[1])};
      // Nothing is slower than the tile, nor much finer than its texels.
      const auto stretch = [&](double log) { return std::exp(std::clamp(log, finest, 0.0)); };
      result[k].stretch = {stretch(own[3]), stretch(own[4])};
      result[k].shear = std::clamp(own[5], -1.0, 1.0);
    }
    return result;
  }
};

/// The residuals of all blocks, and in `derivatives`, unless null, theirs by the parameters.
VectorXd residualsOf(const std::vector<Block>& blocks, double least, const WindowSpectrum& spectrum,
                     const std::vector<Kernel>& kernels, std::size_t free, MatrixXd* derivatives) {
  VectorXd residuals(Index(blocks.size()));
  tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
    const Block& block = blocks[b];
    double modelled = 0.0;
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      KernelSlopes slopes{};
      modelled += densityAt(spectrum, kernels[k], block.u, block.v,
                            derivatives == nullptr ? nullptr : &slopes);
      if (derivatives != nullptr)
        for (std::size_t p = 0; p < free; ++p)
          (*derivatives)(Index(b), Index(k * free + p)) = slopes[p];
    }
    const auto [residual, slope] = residualOf(block, least, modelled);
    residuals[Index(b)] = residual;
    if (derivatives != nullptr)
      derivatives->row(Index(b)) *= slope;
  });
  return residuals;
}

/// Deviation of the spectrum that stands for a box, over the box's width. Measured: 0.30 to 0.35
/// come closest.
constexpr double kDeviationOfWidth = 0.32;

std::vector<Kernel> kernelsOfBoxes(const PowerPlane& power, const WindowSpectrum& spectrum,
                                   const std::vector<FrequencyBox>& boxes) {
  // The support at which the window's spectrum has the deviation 1, or the first zero of a sinc's
  // rectangle.
  const double deviation = std::sqrt(windowSpread(spectrum.window()));
  const auto stretchOf = [&](double width) {
    return spectrum.window() == Window::gabor ? deviation / (kDeviationOfWidth * width)
                                              : 2.0 / width; // sinc(width p)
  };
  std::vector<Kernel> kernels;
  for (const FrequencyBox& box : boxes) {
    Kernel kernel;
    for (int v = box.top; v < box.bottom; ++v)
      for (int u = box.left; u < box.right; ++u)
        kernel.energy += (u == 0 && v == 0 ? 0.0 : u == 0 ? 1.0 : 2.0) * power.at(u, v);
    if (!(kernel.energy > 0.0))
      continue;
    kernel.frequency = {0.5 * (box.low() + box.high()), 0.5 * (box.lowRow() + box.highRow())};
    kernel.stretch = {stretchOf(box.width()), stretchOf(box.height())};
    kernels.push_back(kernel);
  }
  return kernels;
}

/// Minimises the sum of squares of `residualsAt(values, derivatives or null)` from `values` on, by
/// Levenberg and Marquardt's method with steps that `limited(values, step)` shortens.
template <class ResidualsAt, class Limited>
VectorXd minimized(VectorXd values, Index count, const ResidualsAt& residualsAt,
                   const Limited& limited) {
  constexpr int kMostSteps = 60, kMostTrials = 10;
  constexpr double kLeastGain = 1e-3; // of the sum
  MatrixXd derivatives(count, values.size());
  VectorXd residuals = residualsAt(values, &derivatives);
  double damping = 1e-2;
  for (int step = 0; step < kMostSteps; ++step) {
    const VectorXd gradient = derivatives.transpose() * residuals;
    MatrixXd curvature = MatrixXd::Zero(values.size(), values.size());
    curvature.selfadjointView<Eigen::Lower>().rankUpdate(derivatives.transpose());
    const VectorXd diagonal = curvature.diagonal().array() + 1e-9;
    const double before = residuals.squaredNorm();
    double gain = 0.0;
    for (int trial = 0; trial < kMostTrials && !(gain > 0.0); ++trial) {
      MatrixXd damped = curvature;
      damped.diagonal() += damping * diagonal;
      const VectorXd moved =
          values -
          limited(values, damped.selfadjointView<Eigen::Lower>().ldlt().solve(gradient).eval());
      if (const double after = residualsAt(moved, nullptr).squaredNorm(); after < before) {
        gain = 1.0 - after / before;
        values = moved;
        damping *= 0.3;
      } else {
        damping *= 4.0;
      }
    }
    if (gain < kLeastGain)
      break;
    residuals = residualsAt(values, &derivatives);
  }
  return values;
}

/// Minimises the distance over all parameters of Gabors, and over the energies of others, whose
/// rectangles stay as they are.
std::vector<Kernel> fitted(const std::vector<Block>& blocks, const PowerPlane& power,
                           const WindowSpectrum& spectrum, std::vector<Kernel> kernels) {
  const std::size_t free = spectrum.window() == Window::gabor ? kKernelParameters : 1;
  const Parameters parameters{std::move(kernels),
                              free,
                              {double(power.columns), 0.5 * double(power.rows)},
                              std::log(0.25 / double(std::max(power.columns, power.rows / 2)))};
  if (parameters.kernels.empty())
    return {};
  // First what is strong, then more and more of what is weak.
  VectorXd values = parameters.values();
  for (const double share : {1.0, 0.1, 0.01, kLeastPower})
    values = minimized(
        values, Index(blocks.size()),
        [&, least = leastPower(blocks, share)](const VectorXd& at, MatrixXd* derivatives) {
          return residualsOf(blocks, least, spectrum, parameters.with(at), free, derivatives);
        },
        [&](const VectorXd& at, const VectorXd& step) { return parameters.limited(at, step); });
  return parameters.with(values);
}

/// Blocks of all directions: `u` is the length of their frequencies.
std::vector<Block> radialBlocks(const std::vector<Block>& blocks) {
  constexpr double kPerOctave = 8.0;
  std::vector<Block> rings;
  for (const Block& block : blocks) {
    const double length = std::max(1.0, std::hypot(block.u, block.v));
    const auto ring = std::size_t(std::floor(kPerOctave * std::log2(length)));
    if (rings.size() <= ring)
      rings.resize(ring + 1);
    Block& own = rings[ring];
    own.u += block.count * length;
    own.power += block.count * block.power;
    own.count += block.count;
  }
  std::vector<Block> kept;
  for (Block& ring : rings)
    if (ring.count > 0.0) {
      ring.u /= ring.count;
      ring.power /= ring.count;
      kept.push_back(ring);
    }
  return kept;
}

/// Rings of equal energy, whose lengths, widths and energies are then fitted to the power of all
/// directions together.
std::vector<Kernel> fittedRings(const std::vector<Block>& blocks, const PowerPlane& power,
                                const WindowSpectrum& spectrum, std::size_t count) {
  const std::vector<Block> radial = radialBlocks(blocks);
  constexpr std::size_t kFree = 3;
  if (radial.size() < kFree * count)
    return {};
  double energy = 0.0;
  for (const Block& block : radial)
    energy += 2.0 * block.count * block.power;
  if (!(energy > 0.0))
    return {};
  // The first block of each part of the energy.
  VectorXd values(Index(kFree * count));
  double before = 0.0;
  std::size_t ring = 0;
  const double highest = double(std::min(power.columns, power.rows / 2 + 1));
  for (const Block& block : radial) {
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
      kernels[k].stretch[0] = kernels[k].stretch[1] = std::exp(std::clamp(own[2], -12.0, 0.0));
      kernels[k].isRing = true;
    }
    return kernels;
  };
  const auto residualsAt = [&](const VectorXd& from) {
    const std::vector<Kernel> kernels = kernelsOf(from);
    const double least = leastPower(radial);
    VectorXd residuals(Index(radial.size()));
    tbb::parallel_for(std::size_t(0), radial.size(), [&](std::size_t b) {
      double modelled = 0.0;
      for (const Kernel& kernel : kernels)
        modelled += ringDensityAt(spectrum, kernel, radial[b].u);
      residuals[Index(b)] = residualOf(radial[b], least, modelled)[0];
    });
    return residuals;
  };
  return kernelsOf(minimized(
      values, Index(radial.size()),
      [&](const VectorXd& from, MatrixXd* derivatives) {
        const VectorXd residuals = residualsAt(from);
        constexpr double kStep = 1e-4;
        if (derivatives != nullptr)
          for (Index p = 0; p < from.size(); ++p) {
            VectorXd moved = from;
            moved[p] += kStep;
            derivatives->col(p) = (residualsAt(moved) - residuals) / kStep;
          }
        return residuals;
      },
      [](const VectorXd&, const VectorXd& step) {
        constexpr double kMost = 0.7;
        return (std::min(1.0, kMost / std::max(step.cwiseAbs().maxCoeff(), 1e-300)) * step).eval();
      }));
}

/// The sum that fitted() minimises.
double distanceOf(const std::vector<Block>& blocks, const WindowSpectrum& spectrum,
                  const std::vector<Kernel>& kernels) {
  return residualsOf(blocks, leastPower(blocks), spectrum, kernels, 0, nullptr).squaredNorm();
}

double errorOf(const std::vector<Block>& blocks, const WindowSpectrum& spectrum,
               const std::vector<Kernel>& kernels) {
  const std::vector<double> modelled = modelOf(blocks, spectrum, kernels);
  const double least = leastPower(blocks);
  double sum = 0.0, count = 0.0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double decibels = 10.0 * std::log10((blocks[b].power + least) / (modelled[b] + least));
    sum += blocks[b].count * decibels * decibels;
    count += blocks[b].count;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

} // namespace

double spectrumErrorDb(const PowerPlane& power, const WindowSpectrum& spectrum,
                       const std::vector<Kernel>& kernels) {
  return errorOf(blocksOf(power), spectrum, kernels);
}

std::vector<Kernel> fitKernels(const PowerPlane& power, const WindowSpectrum& spectrum,
                               std::size_t most) {
  const std::vector<Block> blocks = blocksOf(power);
  // From rectangles of nearly constant power, and from those around half of the power and half of
  // that: the one finds what is spread widely, the other lines and rings.
  std::vector<Kernel> kernels;
  for (const auto& boxes : {spectra::boxesOfEqualPower(spectra::smoothed(power), most),
                            boxesAroundPower(power, most)}) {
    std::vector<Kernel> own =
        fitted(blocks, power, spectrum, kernelsOfBoxes(power, spectrum, boxes));
    if (kernels.empty() ||
        distanceOf(blocks, spectrum, own) < distanceOf(blocks, spectrum, kernels))
      kernels = std::move(own);
  }
  if (kernels.empty())
    return kernels;
  if (spectrum.window() == Window::gabor) {
    // A spectrum without a direction needs few rings, and fewer cells are visited for them.
    constexpr double kNearlyFactor = 1.3, kNearlyDb = 0.1;
    const double error = errorOf(blocks, spectrum, kernels);
    for (std::size_t count = 1; count <= std::min<std::size_t>(most, 4); ++count)
      if (std::vector<Kernel> rings = fittedRings(blocks, power, spectrum, count);
          !rings.empty() && errorOf(blocks, spectrum, rings) < kNearlyFactor * error + kNearlyDb) {
        kernels = std::move(rings);
        break;
      }
  }
  return kernels;
}

} // namespace lichen::multiple_kernels
