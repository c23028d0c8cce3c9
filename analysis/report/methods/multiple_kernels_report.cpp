// SPDX-License-Identifier: MIT
// A multiple-kernels noise and its exemplar -> measures, and a picture of its spectrum.
#include "../method_report.h"
#include "../random_phases.h"
#include "multiple_kernels/kernel.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr GaussianTargets kTargets{0.5, 1.5, true};

/// The power spectral density of a map's kernels and its pattern, the zero frequency in the middle.
LinearImage kernelsPicture(const Table& table, const MultipleKernelsNoise& shared, int side) {
  using namespace multiple_kernels;
  const int width = std::min(side, shared.texelsPerTileX);
  const int height = std::min(side, shared.texelsPerTileY);
  const WindowSpectrum spectrum(shared.window);
  const std::vector<KernelRow> rows = kernelRows(table, shared);
  std::vector<double> density(std::size_t(width) * std::size_t(height), 0.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Kernel kernel = kernelOf(rows[k], int(k) >= shared.kernels - shared.rings);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double u = (x - width / 2) * double(shared.texelsPerTileX) / width;
        const double v = (y - height / 2) * double(shared.texelsPerTileY) / height;
        density[std::size_t(y) * std::size_t(width) + std::size_t(x)] +=
            kernel.isRing ? ringDensityAt(spectrum, kernel, std::hypot(u, v))
                          : densityAt(spectrum, kernel, u, v);
      }
  }
  for (const PatternCosine& cosine : patternCosines(table, shared)) {
    double power = 0.0;
    for (const std::array<float, 2>& wave : cosine.waves)
      power += 0.25 * (double(wave[0]) * double(wave[0]) + double(wave[1]) * double(wave[1]));
    for (const double mirror : {1.0, -1.0}) {
      const auto x =
          std::lround(mirror * double(cosine.frequency[0]) * width / shared.texelsPerTileX) +
          width / 2;
      const auto y =
          std::lround(mirror * double(cosine.frequency[1]) * height / shared.texelsPerTileY) +
          height / 2;
      if (x >= 0 && y >= 0 && x < width && y < height)
        density[std::size_t(y) * std::size_t(width) + std::size_t(x)] += power;
    }
  }
  return spectrumPicture(density, width, height);
}

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress& progress) {
  if (assessed.noise.as<MultipleKernelsNoise>().hasGivenSpectrum) // nobody expects outlines
    return std::vector<Risk>{};
  return outlineRisks(assessed.map(), {}, progress);
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  return judgeRandomPhase(result, noise.as<MultipleKernelsNoise>().hasGivenSpectrum, kTargets,
                          comparison);
}

Result<std::vector<Picture>> pictures(const DrawnMap& drawn) {
  return allOf({encodedPicture(
      kernelsPicture(drawn.bundle.tables[drawn.map.as<MultipleKernelsMap>().kernels],
                     drawn.noise.as<MultipleKernelsNoise>(), drawn.side),
      "Spectrum of the kernels",
      ". The power of each frequency of the noise, the zero frequency in the middle. Each spot and "
      "its "
      "mirror are a kernel, each dot a cosine of the pattern.")});
}

} // namespace

/// The same pictures as for local random phase.
extern const MethodReport kMultipleKernelsReport{
    .assess = assess, .measure = measure, .pictures = pictures, .picturePixels = 9.0};

} // namespace lichen
