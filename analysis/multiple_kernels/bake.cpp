// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a multiple-kernels noise and its tables.
#include "gaussian/gaussian_distribution.h"
#include "gaussian/gaussianized_maps.h"
#include "kernel_colors.h"
#include "kernel_fit.h"
#include "perturbation.h"
#include "random_phase/map_spectrum.h"

#include <lichen/multiple_kernels.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

using namespace multiple_kernels;

Result<void> checkPerturbation(const Perturbation& perturbation) {
  const auto& [amount, pattern, cosines] = perturbation;
  if (!(amount >= kPerturbationRange.least && amount <= kPerturbationRange.most))
    return Error{ErrorKind::usage,
                 "a perturbation of " + std::to_string(amount) + "; expected 0 to 16"};
  if (cosines < 1 || cosines > kMostPatternCosines)
    return Error{ErrorKind::usage, std::to_string(cosines) + " cosines; expected 1 to " +
                                       std::to_string(kMostPatternCosines)};
  for (const PatternWave& wave : pattern) {
    if (!std::isfinite(wave.amplitude) || !std::isfinite(wave.phase))
      return Error{ErrorKind::badInput, "a pattern with a number that is not finite"};
    if (wave.u == 0 && wave.v == 0)
      return Error{ErrorKind::badInput, "a pattern with the frequency 0; expected waves"};
    for (const int cycles : {wave.u, wave.v})
      if (cycles < -int(kMostKernelFrequency) || cycles > int(kMostKernelFrequency))
        return Error{ErrorKind::badInput, "a pattern with " + std::to_string(cycles) +
                                              " cycles per tile; expected at most " +
                                              std::to_string(int(kMostKernelFrequency))};
  }
  constexpr double kLeast = 1e-4; // of a picture's codes, beyond its rounding
  if (!pattern.empty() && strongestWaves(pattern, 1).front().amplitude < kLeast)
    return Error{ErrorKind::badInput, "the pattern does not vary"};
  return {};
}

Result<void> checkOptions(const MultipleKernelsOptions& options) {
  if (options.kernels < int(kKernelsRange.least) || options.kernels > int(kKernelsRange.most))
    return Error{ErrorKind::usage, std::to_string(options.kernels) + " kernels; expected 1 to " +
                                       std::to_string(kMostKernels)};
  if (!(options.impacts >= kImpactsRange.least && options.impacts <= kImpactsRange.most))
    return Error{ErrorKind::usage, "impacts: expected 1 to 1000"};
  return options.perturbation ? checkPerturbation(*options.perturbation) : Result<void>();
}

/// The height of a cell of this area for which the fewest cells are visited.
double bestCellHeight(const Kernel& kernel, Window window, double cellArea) {
  const Eigen::Matrix2d form = kernel.toWindow().transpose() * kernel.toWindow();
  const auto [reachX, reachY] = kernel.reach(window);
  const bool isDisk = window == Window::gabor;
  const double shear = isDisk ? std::abs(form(0, 1) / form(0, 0)) : 0.0;
  const double chord = isDisk ? 2.0 / std::sqrt(form(0, 0)) : 2.0 * reachX;
  // The expected number of cells, less what does not depend on the height. Each row of cells is
  // visited over its widest chord, and over the shift of the chord's middle within the row.
  const auto cells = [&](double height) {
    const double perWidth = height / cellArea;
    return perWidth * (chord + shear * (2.0 * reachY + height)) + 2.0 * reachY / height;
  };
  const double start = std::sqrt(cellArea * reachY / reachX); // as the support is
  double best = start;
  constexpr int kSteps = 32, kStepsOfOctave = 16;
  for (int step = -kSteps; step <= kSteps; ++step)
    if (const double height = start * std::exp2(double(step) / kStepsOfOctave);
        cells(height) < cells(best))
      best = height;
  return best;
}

/// The grid of a kernel that `impacts` impacts reach.
KernelRow gridOf(const Kernel& kernel, Window window, double impacts, double tileAspect) {
  const double area = kernel.area(window) / impacts;
  const double height = bestCellHeight(kernel, window, area);
  const auto cellsOf = [&](double side) {
    return int(std::clamp(std::round(kKernelTiles / side), 1.0, double(kMostKernelCells)));
  };
  KernelRow row;
  row.columns = cellsOf(area / height);
  row.rows = cellsOf(height);
  // In a solid windows are as wide along z as along the ellipse's narrow axis. As many impacts
  // reach a point: an ellipsoid has 4 / 3 of an ellipse's area times its reach.
  const Eigen::Vector2d perWidth(1.0, tileAspect); // tile heights, and the frequencies of these
  const Eigen::Matrix2d inSpace = kernel.toWindow() * perWidth.asDiagonal();
  row.toWindowZ = float(std::sqrt((inSpace.transpose() * inSpace).eigenvalues().real().maxCoeff()));
  // On surfaces in cubes, as textons. [GLM17] section 6
  const double inWidths = kernel.area(window) / tileAspect;
  row.cubes = cellsOf(std::cbrt(std::pow(inWidths, 1.5) / (kSurfaceImpacts * impacts)));
  // Windows in a solid are wider, so that its planes have the spread of the window in the plane:
  // by a ratio of Beta functions.
  const double kSolidWider = std::sqrt(15.0 / 14.0);
  row.layers = cellsOf(4.0 / 3.0 * std::pow(kSolidWider, 3.0) / double(row.toWindowZ));
  return row;
}

/// The rows of all maps but for their colours.
std::vector<KernelRow> rowsOf(const std::vector<Kernel>& kernels, Window window, double impacts,
                              double tileAspect) {
  // What most lowers the kurtosis at the cost of one impact: impacts as the energy.
  constexpr double kFewest = 0.3; // of a kernel, so that single impacts do not show
  double energy = 0.0;
  for (const Kernel& kernel : kernels)
    energy += kernel.energy;
  std::vector<KernelRow> rows;
  for (const Kernel& kernel : kernels) {
    // A ring has waves in all directions. With few impacts, single directions show.
    const double own = (kernel.isRing ? 2.0 : 1.0) * impacts * kernel.energy / energy;
    KernelRow row = gridOf(kernel, window, std::max(kFewest, own), tileAspect);
    row.frequency = {float(kernel.frequency[0]), float(kernel.frequency[1])};
    const Eigen::Matrix2d toWindow = kernel.toWindow();
    row.toWindow = {float(toWindow(0, 0)), float(toWindow(0, 1)), float(toWindow(1, 0)),
                    float(toWindow(1, 1))};
    const double density = double(row.columns) * row.rows / (kKernelTiles * kKernelTiles);
    row.amplitude = float(1.0 / std::sqrt(density * squareIntegral(window, kernel)));
    rows.push_back(row);
  }
  return rows;
}

/// The pattern of each map, and its noise: both scaled so that together they have the covariance of
/// the exemplar.
std::vector<std::vector<PatternCosine>> scalePattern(const TakenPattern& pattern, double amount,
                                                     const std::vector<Eigen::Index>& first,
                                                     std::vector<Eigen::MatrixXd>& colors) {
  const double deviation = gaussian::kGaussianDeviation;
  Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(first.back(), first.back());
  for (const Eigen::MatrixXd& color : colors)
    noise += color * color.transpose() / (deviation * deviation);
  const std::vector<PerturbedScale> scales = perturbedScales(pattern, noise, first, amount);
  std::vector<std::vector<PatternCosine>> patterns(first.size() - 1);
  for (std::size_t m = 0; m < patterns.size(); ++m) {
    const Eigen::Index count = first[m + 1] - first[m];
    for (Eigen::MatrixXd& color : colors)
      color.middleRows(first[m], count) =
          (scales[m].noise * color.middleRows(first[m], count)).eval();
    for (const PatternTerm& term : pattern.terms) {
      const Eigen::MatrixX2d waves =
          deviation * scales[m].pattern * term.waves.middleRows(first[m], count);
      PatternCosine cosine;
      cosine.frequency = {float(term.u), float(term.v)};
      for (Eigen::Index c = 0; c < count; ++c)
        cosine.waves[std::size_t(c)] = {float(waves(c, 0)), float(waves(c, 1))};
      patterns[m].push_back(cosine);
    }
  }
  return patterns;
}

/// At most `most` kernels, those without direction last, then by energy. Adds the errors of the fit
/// and of fits with a half and a quarter of them.
std::vector<Kernel> kernelsFor(const random_phase::PowerPlane& power, const WindowSpectrum& window,
                               int most, std::vector<SpectrumError>& errors) {
  std::vector<std::size_t> counts;
  for (const int count : {most / 4, most / 2, most})
    if (count > 0)
      counts.push_back(std::size_t(count));
  std::vector<Kernel> kernels;
  for (const KernelFit& fit : fitKernels(power, window, counts)) {
    if (!errors.empty() && fit.kernels.size() == kernels.size())
      errors.pop_back();
    errors.push_back({int(fit.kernels.size()), fit.decibels});
    kernels = fit.kernels;
  }
  if (kernels.empty()) // nothing varies
    kernels.push_back({1.0, {}, {1.0, 1.0}, 0.0, false});
  std::stable_sort(kernels.begin(), kernels.end(), [](const Kernel& a, const Kernel& b) {
    return std::pair(a.isRing, -a.energy) < std::pair(b.isRing, -b.energy);
  });
  return kernels;
}

/// As bakeMultipleKernels(), but throws std::bad_alloc.
Result<MethodBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                            const MultipleKernelsOptions& options) {
  if (Result<void> checked = checkOptions(options); !checked)
    return checked.error();
  MethodBake bake;
  bake.noise.name = name;
  MultipleKernelsNoise shared;
  shared.window = options.window;
  shared.hasGivenSpectrum = options.spectrum.has_value();
  std::vector<random_phase::MapSpectrum> spectra;
  std::vector<MultipleKernelsMap> data;
  if (Result<void> begun =
          random_phase::beginBake(name, maps, options, bake, shared, spectra, data);
      !begun)
    return begun.error();
  if (options.spectrum)
    if (Result<void> replaced = random_phase::replaceSpectra(*options.spectrum, spectra); !replaced)
      return replaced.error();

  TakenPattern pattern;
  if (options.perturbation)
    pattern = takePattern(*options.perturbation, spectra);
  shared.cosines = int(pattern.terms.size());
  shared.hasGivenSpectrum |= options.perturbation && !options.perturbation->pattern.empty();
  const WindowSpectrum window(options.window);
  const random_phase::PowerPlane power = random_phase::powerPlane(spectra);
  const std::vector<Kernel> kernels =
      kernelsFor(power, window, options.kernels, bake.figures.spectrumErrors);
  shared.kernels = int(kernels.size());
  shared.rings = int(std::count_if(kernels.begin(), kernels.end(),
                                   [](const Kernel& kernel) { return kernel.isRing; }));
  std::vector<Eigen::MatrixXd> colors = kernelColors(spectra, window, kernels);
  std::vector<std::vector<PatternCosine>> patterns(spectra.size());
  if (!pattern.terms.empty())
    patterns = scalePattern(pattern, options.perturbation->amount,
                            random_phase::firstChannels(spectra), colors);
  const std::vector<KernelRow> rows = rowsOf(kernels, options.window, options.impacts,
                                             double(shared.texelsPerTileX) / shared.texelsPerTileY);
  Eigen::Index channel = 0;
  for (std::size_t m = 0; m < spectra.size(); ++m) {
    const std::size_t channels = spectra[m].channels.size();
    std::vector<KernelRow> own = rows;
    for (std::size_t k = 0; k < own.size(); ++k)
      for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t s = 0; s < std::size_t(kWaves); ++s)
          own[k].colors[c][s] = float(colors[k](channel + Eigen::Index(c), Eigen::Index(s)));
    channel += Eigen::Index(channels);
    Table table = kernelTable(own, patterns[m]);
    table.name = name + "." + std::string(nameOf(bake.noise.maps[m].target)) + ".kernels";
    data[m].kernels = gaussian::appended(std::move(table), bake.tables);
    bake.noise.maps[m].data = data[m];
  }
  bake.noise.data = shared;
  return bake;
}

} // namespace

Result<MethodBake> bakeMultipleKernels(std::string name, std::span<const MapExemplar> maps,
                                       const MultipleKernelsOptions& options) {
  return withinMemory([&] { return gaussian::noMemoryToBake(name, maps); },
                      [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
