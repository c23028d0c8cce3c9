// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a multiple-kernels noise and its tables.
#include "gaussianization/gaussianized_maps.h"
#include "kernel_colors.h"
#include "kernel_fit.h"
#include "spectra/given_spectrum.h"
#include "spectra/map_spectrum.h"

#include <lichen/multiple_kernels.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

using namespace multiple_kernels;

Result<void> checkOptions(const MultipleKernelsOptions& options) {
  if (options.kernels < int(kKernelsRange.least) || options.kernels > int(kKernelsRange.most))
    return Error{ErrorKind::usage, std::to_string(options.kernels) + " kernels; expected 1 to " +
                                       std::to_string(kMostKernels)};
  if (!(options.impacts >= kImpactsRange.least && options.impacts <= kImpactsRange.most))
    return Error{ErrorKind::usage, "impacts: expected 1 to 1000"};
  return {};
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
  constexpr int kSteps = 8, kStepsOfOctave = 4;
  for (int step = -kSteps; step <= kSteps; ++step)
    if (const double height = start * std::exp2(double(step) / kStepsOfOctave);
        cells(height) < cells(best))
      best = height;
  return best;
}

/// The grid of a kernel that `impacts` impacts reach.
KernelRow gridOf(const Kernel& kernel, Window window, double impacts) {
  const double area = kernel.area(window) / impacts;
  const double height = bestCellHeight(kernel, window, area);
  const auto cellsOf = [&](double side) {
    return int(std::clamp(std::round(kKernelTiles / side), 1.0, double(kMostKernelCells)));
  };
  KernelRow row;
  row.columns = cellsOf(area / height);
  row.rows = cellsOf(height);
  return row;
}

/// The rows of all maps but for their colours.
std::vector<KernelRow> rowsOf(const std::vector<Kernel>& kernels, Window window, double impacts) {
  // What most lowers the kurtosis at the cost of one impact: impacts as the energy.
  constexpr double kFewest = 0.3; // of a kernel, so that its impacts are not seen one by one
  double energy = 0.0;
  for (const Kernel& kernel : kernels)
    energy += kernel.energy;
  const auto spread = float(windowSpread(window));
  std::vector<KernelRow> rows;
  for (const Kernel& kernel : kernels) {
    KernelRow row = gridOf(kernel, window, std::max(kFewest, impacts * kernel.energy / energy));
    row.frequency = {float(kernel.frequency[0]), float(kernel.frequency[1])};
    const Eigen::Matrix2d toWindow = kernel.toWindow();
    row.toWindow = {float(toWindow(0, 0)), float(toWindow(0, 1)), float(toWindow(1, 0)),
                    float(toWindow(1, 1))};
    const double density = double(row.columns) * row.rows / (kKernelTiles * kKernelTiles);
    row.amplitude = float(1.0 / std::sqrt(density * squareIntegral(window, kernel)));
    row.spread = spread;
    rows.push_back(row);
  }
  return rows;
}

std::size_t appended(Table table, std::vector<Table>& tables) {
  tables.push_back(std::move(table));
  return tables.size() - 1;
}

/// As bakeMultipleKernels(), but throws std::bad_alloc.
Result<MultipleKernelsBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                                     const MultipleKernelsOptions& options) {
  if (Result<void> checked = checkOptions(options); !checked)
    return checked.error();
  MultipleKernelsBake bake;
  bake.noise.name = name;
  MultipleKernelsNoise shared;
  shared.window = options.window;
  shared.hasGivenSpectrum = options.spectrum.has_value();
  std::vector<spectra::MapSpectrum> spectra;
  std::vector<MultipleKernelsMap> data;
  const auto append = [&](gaussianization::GaussianizedMap map) {
    shared.texelsPerTileX = std::max(shared.texelsPerTileX, map.image.width);
    shared.texelsPerTileY = std::max(shared.texelsPerTileY, map.image.height);
    spectra.push_back(spectra::spectrumOf(map));
    MultipleKernelsMap own;
    own.dimensions = map.image.dimensions;
    if (map.inverse)
      own.inverseTable = appended(*std::move(map.inverse), bake.tables);
    data.push_back(own);
    bake.noise.maps.push_back(std::move(map.map));
  };
  const Result<bool> periodic = gaussianization::gaussianizeMaps(name, maps, options, append);
  if (!periodic)
    return periodic.error();
  bake.exemplarWasPeriodic = periodic.value();
  if (options.spectrum)
    if (Result<void> replaced = spectra::replaceSpectra(*options.spectrum, spectra); !replaced)
      return replaced.error();

  const WindowSpectrum window(options.window);
  const spectra::PowerPlane power = spectra::powerPlane(spectra);
  std::vector<Kernel> kernels = fitKernels(power, window, std::size_t(options.kernels));
  bake.spectrumErrorDb = spectrumErrorDb(power, window, kernels);
  if (kernels.empty()) // nothing varies
    kernels.push_back({1.0, {}, {1.0, 1.0}, 0.0, false});
  std::stable_sort(kernels.begin(), kernels.end(), [](const Kernel& a, const Kernel& b) {
    return std::pair(a.isRing, -a.energy) < std::pair(b.isRing, -b.energy);
  });
  shared.kernels = int(kernels.size());
  shared.rings = int(std::count_if(kernels.begin(), kernels.end(),
                                   [](const Kernel& kernel) { return kernel.isRing; }));
  const std::vector<Eigen::MatrixXd> colors = kernelColors(spectra, window, kernels);
  const std::vector<KernelRow> rows = rowsOf(kernels, options.window, options.impacts);
  Eigen::Index channel = 0;
  for (std::size_t m = 0; m < spectra.size(); ++m) {
    const std::size_t channels = spectra[m].channels.size();
    std::vector<KernelRow> own = rows;
    for (std::size_t k = 0; k < own.size(); ++k)
      for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t s = 0; s < std::size_t(kWaves); ++s)
          own[k].colors[c][s] = float(colors[k](channel + Eigen::Index(c), Eigen::Index(s)));
    channel += Eigen::Index(channels);
    Table table = kernelTable(own);
    table.name = name + "." + std::string(nameOf(bake.noise.maps[m].target)) + ".kernels";
    data[m].kernels = appended(std::move(table), bake.tables);
    bake.noise.maps[m].data = data[m];
  }
  bake.noise.data = shared;
  return bake;
}

} // namespace

Result<MultipleKernelsBake> bakeMultipleKernels(std::string name, std::span<const MapExemplar> maps,
                                                const MultipleKernelsOptions& options) {
  return withinMemory([&] { return gaussianization::noMemoryToBake(name, maps); },
                      [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
