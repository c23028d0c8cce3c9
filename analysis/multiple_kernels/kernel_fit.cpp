// SPDX-License-Identifier: MIT
// Power plane -> blocks of frequencies -> kernels, by the likelihood of the blocks' mean powers.
//
// Levenberg and Marquardt's method minimises the sum of their distances as a sum of squares:
// docs/decisions/010-multiple-kernels.md.
#include "kernel_fit.h"

#include "frequency_blocks.h"

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace lichen::multiple_kernels {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using random_phase::FrequencyBox;
using random_phase::PowerPlane;

/// The usual share of the sum of squares that a step has to take away.
constexpr double kLeastGain = 1e-3;

/// Residuals, and their derivatives by the values: a row for each residual.
struct Residuals {
  Eigen::VectorXd values;
  Eigen::MatrixXd derivatives;
};

/// Minimises the sum of squares of `residualsAt(values)` from `values` on, until a step takes less
/// than `leastGain` of it away, by Levenberg and Marquardt's method with steps that
/// `limited(values, step)` shortens. The damping follows how well the last step was foreseen
/// [MNT04].
template <class ResidualsAt, class Limited>
Eigen::VectorXd minimized(Eigen::VectorXd values, double leastGain, const ResidualsAt& residualsAt,
                          const Limited& limited) {
  constexpr int kMostTrials = 100;
  Residuals here = residualsAt(values);
  double damping = 1e-2, growth = 2.0;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    const double before = here.values.squaredNorm();
    const Eigen::VectorXd gradient = here.derivatives.transpose() * here.values;
    Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(values.size(), values.size());
    curvature.selfadjointView<Eigen::Lower>().rankUpdate(here.derivatives.transpose());
    const Eigen::VectorXd diagonal = curvature.diagonal().array() + 1e-9;
    Eigen::MatrixXd damped = curvature;
    damped.diagonal() += damping * diagonal;
    const Eigen::VectorXd step =
        limited(values, damped.selfadjointView<Eigen::Lower>().ldlt().solve(gradient).eval());
    Residuals there = residualsAt(values - step);
    const double after = there.values.squaredNorm();
    const double foreseen = (here.values - here.derivatives * step).squaredNorm();
    if (after < before) {
      const double ratio = (before - after) / std::max(before - foreseen, 1e-300);
      damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3.0));
      growth = 2.0;
      values -= step;
      here = std::move(there);
      if (1.0 - after / before < leastGain)
        break;
    } else {
      damping *= growth;
      growth *= 2.0;
      constexpr double kMostGrowth = 2048.0; // eleven steps in a row that gain nothing
      if (growth > kMostGrowth)
        break;
    }
  }
  return values;
}

/// Times the width of its rectangle, the stretch of a window on the square: its sinc has two zeros
/// on each side.
constexpr double kStretchTimesWidth = 2.0;

/// What kernels are fitted to.
struct Target {
  FrequencyBlocks blocks;
  std::array<double, 2> texels{}; ///< of the tile
  const WindowSpectrum& spectrum;
  random_phase::PowerPlane numbers; ///< at each frequency the number of the block
  double energy = 0.0;              ///< of all powers
  double energyWeight = 0.0;        ///< of its logarithm, in the unit of weightOf()

  [[nodiscard]] const FrequencyBlock& blockAt(std::array<double, 2> frequency) const {
    if (frequency[0] < 0.0)
      frequency = {-frequency[0], -frequency[1]};
    const int half = numbers.rows / 2;
    const int u = std::min(int(std::lround(frequency[0])), numbers.columns - 1);
    const int v = std::clamp(int(std::lround(frequency[1])), -half, half);
    return blocks[std::size_t(numbers.at(u, v))];
  }

  /// The stretches of a kernel at a frequency whose spectrum is about as wide and high as the block
  /// there: the power of narrower ones would hide between the middles of blocks.
  [[nodiscard]] std::array<double, 2> longestStretches(std::array<double, 2> frequency) const {
    constexpr double kDeviationOfSide = 0.5;
    static const double deviation = std::sqrt(windowSpread(Window::gabor));
    const double perSide =
        spectrum.window() == Window::gabor ? deviation / kDeviationOfSide : kStretchTimesWidth;
    const FrequencyBlock& block = blockAt(frequency);
    return {perSide / block.width, perSide / block.height};
  }
};

/// The power of kernels at each block.
std::vector<double> modelOf(const Target& target, const std::vector<Kernel>& kernels) {
  std::vector<double> modelled(target.blocks.size(), 0.0);
  tbb::parallel_for(std::size_t(0), target.blocks.size(), [&](std::size_t b) {
    const FrequencyBlock& block = target.blocks[b];
    for (const Kernel& kernel : kernels)
      modelled[b] += sampledDensityAt(target.spectrum, kernel, target.texels, block.u, block.v);
  });
  return modelled;
}

/// The parameters of kernels, six for each in the order of KernelSlopes.
struct Parameters {
  std::vector<Kernel> kernels;     ///< at the start
  std::array<double, 2> highest{}; ///< frequencies of the plane
  double finest = 0.0;             ///< logarithm of the least stretch
  const Target& target;

  [[nodiscard]] VectorXd values() const {
    VectorXd all(Index(kernels.size() * kKernelParameters));
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      const Kernel& kernel = kernels[k];
      const std::array own{std::log(kernel.energy),     kernel.frequency[0],
                           kernel.frequency[1],         std::log(kernel.stretch[0]),
                           std::log(kernel.stretch[1]), kernel.shear};
      for (std::size_t p = 0; p < kKernelParameters; ++p)
        all[Index(k * kKernelParameters + p)] = own[p];
    }
    return all;
  }

  /// A step, shortened for each kernel by itself until it changes by no more than its own width, or
  /// by a factor.
  [[nodiscard]] VectorXd limited(const VectorXd& values, VectorXd step) const {
    constexpr double kMost = 0.7;
    const std::vector<Kernel> here = with(values);
    for (std::size_t k = 0; k < here.size(); ++k) {
      auto own = step.segment<Index(kKernelParameters)>(Index(k * kKernelParameters));
      double longest = std::abs(own[0]);
      const auto [across, down] = here[k].stretch;
      for (const double part : {across * own[1], down * own[2], own[3], own[4], own[5] / across})
        longest = std::max(longest, std::abs(part));
      own *= std::min(1.0, kMost / std::max(longest, 1e-300));
    }
    return step;
  }

  [[nodiscard]] std::vector<Kernel> with(const VectorXd& values) const {
    std::vector<Kernel> result = kernels;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const double* own = values.data() + k * kKernelParameters;
      // A step of the solver may go anywhere.
      constexpr double kMostLog = 30.0;
      result[k].energy = std::exp(std::clamp(own[0], -kMostLog, kMostLog));
      result[k].frequency = {std::clamp(own[1], -highest[0], highest[0]),
                             std::clamp(own[2], -highest[1], highest[1])};
      const auto [across, down] = target.longestStretches(result[k].frequency);
      const auto stretch = [&](double log, double most) {
        return std::exp(std::clamp(log, finest, std::log(most)));
      };
      result[k].stretch = {stretch(own[3], across), stretch(own[4], down)};
      // Nor much wider along u.
      const double sheared = result[k].stretch[0] * result[k].stretch[1] * std::exp(-finest);
      const double most = std::min(down, sheared);
      result[k].shear = std::clamp(own[5], -most, most);
    }
    return result;
  }
};

double energyOf(const std::vector<Kernel>& kernels) {
  double energy = 0.0;
  for (const Kernel& kernel : kernels)
    energy += kernel.energy;
  return energy;
}

/// The residuals of all blocks, and of the sum of the energies, which has to be the sum of the
/// powers: energy in the far tails of a spectrum would count for nothing, but show.
Residuals residualsOf(const Target& target, double least, const std::vector<Kernel>& kernels) {
  const auto blocks = Index(target.blocks.size());
  Residuals residuals{VectorXd(blocks + 1),
                      MatrixXd::Zero(blocks + 1, Index(kernels.size() * kKernelParameters))};
  const double energy = energyOf(kernels), weight = std::sqrt(target.energyWeight);
  residuals.values[blocks] = weight * std::log(energy / target.energy);
  for (std::size_t k = 0; k < kernels.size(); ++k)
    residuals.derivatives(blocks, Index(k * kKernelParameters)) =
        weight * kernels[k].energy / energy;
  tbb::parallel_for(std::size_t(0), target.blocks.size(), [&](std::size_t b) {
    const FrequencyBlock& block = target.blocks[b];
    double modelled = 0.0;
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      KernelSlopes slopes{};
      modelled +=
          sampledDensityAt(target.spectrum, kernels[k], target.texels, block.u, block.v, &slopes);
      for (std::size_t p = 0; p < kKernelParameters; ++p)
        residuals.derivatives(Index(b), Index(k * kKernelParameters + p)) = slopes[p];
    }
    const auto [residual, slope] = residualOf(block, least, modelled);
    residuals.values[Index(b)] = residual;
    residuals.derivatives.row(Index(b)) *= slope;
  });
  return residuals;
}

/// Deviation of the spectrum that stands for a box, over the box's width. Measured: 0.30 to 0.35
/// come closest.
constexpr double kDeviationOfWidth = 0.32;

/// A kernel for each box, with the energy that `power` has there.
std::vector<Kernel> kernelsOfBoxes(const PowerPlane& power, const Target& target,
                                   const std::vector<FrequencyBox>& boxes) {
  const Window window = target.spectrum.window();
  const double deviation = std::sqrt(windowSpread(window));
  const auto stretchOf = [&](double width) {
    return window == Window::gabor ? deviation / (kDeviationOfWidth * width)
                                   : kStretchTimesWidth / width;
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
    const auto [across, down] = target.longestStretches(kernel.frequency);
    kernel.stretch = {std::min(stretchOf(box.width()), across),
                      std::min(stretchOf(box.height()), down)};
    kernels.push_back(kernel);
  }
  return kernels;
}

/// Minimises the distance over all parameters of Gabors. Others stay as they are: with energies
/// that are free, the far tails of a few stand for much that is not near them.
std::vector<Kernel> fitted(const Target& target, std::vector<Kernel> kernels) {
  if (kernels.empty() || target.spectrum.window() != Window::gabor)
    return kernels;
  constexpr double kFinestTexels = 0.75; // the radius of a support
  const auto [across, down] = target.texels;
  const Parameters parameters{std::move(kernels),
                              {0.5 * across, 0.5 * down},
                              std::log(kFinestTexels / std::max(across, down)),
                              target};
  // First what is strong, then more and more of what is weak, and only then closely.
  VectorXd values = parameters.values();
  for (const double share : {1.0, 0.1, 0.01, kLeastPower})
    values = minimized(
        values, share > kLeastPower ? 10.0 * kLeastGain : kLeastGain,
        [&, least = leastPower(target.blocks, share)](const VectorXd& at) {
          return residualsOf(target, least, parameters.with(at));
        },
        [&](const VectorXd& at, const VectorXd& step) { return parameters.limited(at, step); });
  return parameters.with(values);
}

/// The sum that fitted() minimises, of at least one kernel.
double distanceOf(const Target& target, const std::vector<Kernel>& kernels) {
  const std::vector<double> modelled = modelOf(target, kernels);
  const double least = leastPower(target.blocks);
  double sum = target.energyWeight * std::pow(std::log(energyOf(kernels) / target.energy), 2.0);
  for (std::size_t b = 0; b < modelled.size(); ++b) {
    const double residual = residualOf(target.blocks[b], least, modelled[b])[0];
    sum += residual * residual;
  }
  return sum;
}

Target targetOf(const PowerPlane& power, const WindowSpectrum& spectrum) {
  Target target{blocksOf(power), texelsOf(power), spectrum, power, 0.0, 0.0};
  // A share of the weights of all blocks. With 0.05 and with 0.3 kernels were farther from 24
  // spectra.
  constexpr double kEnergyShare = 0.1;
  for (std::size_t b = 0; b < target.blocks.size(); ++b) {
    const FrequencyBlock& block = target.blocks[b];
    target.energy += 2.0 * block.count * block.power;
    target.energyWeight += kEnergyShare * weightOf(block);
    const int left = int(std::lround(block.u - 0.5 * (block.width - 1.0)));
    const int top = int(std::lround(block.v - 0.5 * (block.height - 1.0))) + power.rows / 2;
    for (int y = top; y < top + int(block.height); ++y)
      for (int x = left; x < left + int(block.width); ++x)
        target.numbers.values[std::size_t(y * power.columns + x)] = double(b);
  }
  // The frequency (0, 0) belongs to no block; take one beside it.
  const auto zero = std::size_t(power.rows / 2 * power.columns);
  const std::size_t beside = zero + (power.columns > 1 ? 1u : std::size_t(power.columns));
  target.numbers.values[zero] =
      beside < target.numbers.values.size() ? target.numbers.values[beside] : 0.0;
  return target;
}

std::vector<Kernel> fittedRings(const FrequencyBlocks& blocks, const PowerPlane& power,
                                const WindowSpectrum& spectrum, std::size_t count);

/// The fits of 1, 2, 3 and 4 rings to a spectrum, each when it is first asked for.
class RingFits {
public:
  RingFits(const Target& target, const PowerPlane& power)
      : target_(target), power_(power), least_(distanceOfRadialMeans(target.blocks)) {}

  /// Rings that follow the spectrum nearly as closely as `gabors`, as few as do; empty if none do.
  /// Fewer cells are visited for them.
  std::vector<Kernel> sufficientFor(const std::vector<Kernel>& gabors, std::size_t most) {
    // By the root of the mean square a third of a decibel more; or as close as the middles of
    // blocks are to their means, where no chance hides that.
    constexpr double kMoreDb = 0.35, kCloseDb = 0.6, kDbOfLogarithm = 4.343;
    double weights = 0.0;
    for (const FrequencyBlock& block : target_.blocks)
      weights += weightOf(block);
    const auto distanceOfDb = [&](double db) {
      return weights * std::pow(db / kDbOfLogarithm, 2.0);
    };
    const double limit =
        std::max(distanceOf(target_, gabors) + distanceOfDb(kMoreDb), distanceOfDb(kCloseDb));
    constexpr double kCertain = 1.5; // a margin, as the means are over rings of 1/24 octave
    for (std::size_t count = 1; count <= std::min(most, kMost) && least_ < kCertain * limit;
         ++count) {
      if (fits_.size() < count)
        fits_.push_back(fittedRings(target_.blocks, power_, target_.spectrum, count));
      const std::vector<Kernel>& rings = fits_[count - 1];
      if (!rings.empty() && distanceOf(target_, rings) < limit)
        return rings;
    }
    return {};
  }

private:
  static constexpr std::size_t kMost = 4;

  const Target& target_;
  const PowerPlane& power_;
  double least_; ///< rings hardly come nearer
  std::vector<std::vector<Kernel>> fits_;
};

/// What the kernels leave of the power, by blocks.
PowerPlane remainderOf(const Target& target, const std::vector<Kernel>& kernels) {
  const std::vector<double> modelled = modelOf(target, kernels);
  PowerPlane left = target.numbers;
  for (double& value : left.values) {
    const auto block = std::size_t(value);
    value = std::max(0.0, target.blocks[block].power - modelled[block]);
  }
  left.values[std::size_t(left.rows / 2 * left.columns)] = 0.0; // of frequency (0, 0)
  return left;
}

double decibelsOf(const Target& target, const std::vector<Kernel>& kernels) {
  const std::vector<double> modelled = modelOf(target, kernels);
  const double least = leastPower(target.blocks);
  double sum = 0.0, count = 0.0;
  for (std::size_t b = 0; b < modelled.size(); ++b) {
    const FrequencyBlock& block = target.blocks[b];
    const double decibels = 10.0 * std::log10((block.power + least) / (modelled[b] + least));
    sum += block.count * decibels * decibels;
    count += block.count;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

} // namespace

double spectrumErrorDb(const PowerPlane& power, const WindowSpectrum& spectrum,
                       const std::vector<Kernel>& kernels) {
  return decibelsOf(targetOf(power, spectrum), kernels);
}

std::vector<KernelFit> fitKernels(const PowerPlane& power, const WindowSpectrum& spectrum,
                                  const std::vector<std::size_t>& counts) {
  const Target target = targetOf(power, spectrum);
  const PowerPlane smooth = random_phase::smoothed(power);
  const bool isGabor = spectrum.window() == Window::gabor;
  RingFits rings(target, power);
  std::vector<KernelFit> fits;
  std::vector<Kernel> kernels;
  for (const std::size_t most : counts) {
    assert(most > kernels.size());
    // From rectangles of nearly constant power; and from the fewer kernels of before with more
    // where power is left. The one finds what is spread widely, the other lines and rings.
    std::vector<Kernel> start = isGabor ? std::move(kernels) : std::vector<Kernel>();
    const PowerPlane left = start.empty() ? power : remainderOf(target, start);
    for (const Kernel& more :
         kernelsOfBoxes(left, target, boxesAroundPower(left, most - start.size())))
      start.push_back(more);
    kernels = fitted(target, std::move(start));
    std::vector<Kernel> other = fitted(
        target, kernelsOfBoxes(power, target, random_phase::boxesOfEqualPower(smooth, most)));
    if (kernels.empty() || distanceOf(target, other) < distanceOf(target, kernels))
      kernels = std::move(other);
    std::vector<Kernel> sufficient;
    if (isGabor && !kernels.empty())
      sufficient = rings.sufficientFor(kernels, most);
    const std::vector<Kernel>& best = sufficient.empty() ? kernels : sufficient;
    fits.push_back({best, decibelsOf(target, best)});
  }
  return fits;
}

// Blocks of frequencies -> rings, by the distance of frequency_blocks.h.
namespace {

constexpr std::size_t kFree = 3; // parameters of a ring: logarithms of energy, length and width

/// The parameters of `count` rings of equal energy, no longer than `highest`; nothing if the blocks
/// have too little power, or are too few.
std::optional<VectorXd> firstRings(const FrequencyBlocks& radial, std::size_t count,
                                   double highest) {
  if (radial.size() < kFree * count)
    return std::nullopt;
  double energy = 0.0;
  for (const FrequencyBlock& block : radial)
    energy += 2.0 * block.count * block.power;
  if (!(energy > 0.0))
    return std::nullopt;
  // The first block of each part of the energy.
  VectorXd values(Index(kFree * count));
  double before = 0.0;
  std::size_t ring = 0;
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
  return ring < count ? std::nullopt : std::optional(values);
}

/// `count` rings of equal energy, whose lengths, widths and energies are then fitted to the power
/// of all directions together. Empty if firstRings() finds none.
std::vector<Kernel> fittedRings(const FrequencyBlocks& blocks, const PowerPlane& power,
                                const WindowSpectrum& spectrum, std::size_t count) {
  const FrequencyBlocks radial = radialBlocks(blocks);
  // A support of two texels: smaller rings would have aliases, which this fit does not model.
  const double finest = -std::log(double(std::max(power.columns, power.rows / 2)));
  const double highest = double(std::min(power.columns, power.rows / 2 + 1));
  const std::optional<VectorXd> first = firstRings(radial, count, highest);
  if (!first)
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
      minimized(*first, kLeastGain, residualsAt, [](const VectorXd&, const VectorXd& step) {
        constexpr double kMost = 0.7;
        return (std::min(1.0, kMost / std::max(step.cwiseAbs().maxCoeff(), 1e-300)) * step).eval();
      }));
}

} // namespace
} // namespace lichen::multiple_kernels
