// SPDX-License-Identifier: MIT
// A local random-phase noise and its exemplar -> measures, and a picture of its spectrum.
#include "../method_report.h"
#include "../random_phases.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr GaussianTargets kTargets{1.0, 1.5, true};

/// The power spectral density of a map's cosines without their windows, the zero frequency in the
/// middle.
LinearImage cosinesPicture(const Table& table, const LocalRandomPhaseNoise& shared, int side) {
  const int width = std::min(side, shared.texelsPerTileX);
  const int height = std::min(side, shared.texelsPerTileY);
  const CosineImageLayout layout(shared);
  const auto texels = cosineTexels(decodeLevel(table, 0), layout);
  std::vector<double> density(std::size_t(width) * std::size_t(height), 0.0);
  const auto fill = [&](double low, double high, double top, double bottom, double value) {
    const auto pixel = [](double frequency, int texels1, int pixels) {
      const double place = (frequency / texels1 + 0.5) * pixels;
      return std::clamp(int(std::lround(place)), 0, pixels);
    };
    for (int y = pixel(top, shared.texelsPerTileY, height);
         y < pixel(bottom, shared.texelsPerTileY, height); ++y)
      for (int x = pixel(low, shared.texelsPerTileX, width);
           x < pixel(high, shared.texelsPerTileX, width); ++x)
        density[std::size_t(y) * std::size_t(width) + std::size_t(x)] = value;
  };
  for (std::size_t j = 0; j < kRowCosines * std::size_t(layout.cosineRows); ++j) {
    const auto* row = &texels[j / kRowCosines * layout.cosineColumns];
    const CosineTexel& box = row[0][j % kRowCosines];
    const double sizeX = box[2], sizeY = box[3];
    const double low = box[0] - 0.5 * sizeX, top = box[1] - 0.5 * sizeY;
    double squares = 0.0; // of the amplitudes, over all variants
    for (std::uint32_t column = kCosineColumns; column < layout.cosineColumns; ++column)
      for (std::size_t c = 0; c < 3; ++c)
        squares += std::pow(double(row[column][j % kRowCosines][c]), 2.0);
    const double value = squares / std::max(sizeX * sizeY, 1e-12);
    fill(low, low + sizeX, top, top + sizeY, value);
    fill(-low - sizeX, -low, -top - sizeY, -top, value);
  }
  return spectrumPicture(density, width, height);
}

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress& progress) {
  const auto& shared = assessed.noise.as<LocalRandomPhaseNoise>();
  if (shared.hasGivenSpectrum) // nobody expects outlines
    return std::vector<Risk>{};
  constexpr double kMost = 0.7; // of the power: a structure of so much keeps outlines
  const std::optional<std::size_t> place = findMap(assessed.noise, assessed.map().target);
  const auto& deviations =
      assessed.noise.maps[place.value_or(0)].as<LocalRandomPhaseMap>().structureDeviations;
  if (!deviations.empty() && deviations[0] * deviations[0] >= kMost)
    return std::vector<Risk>{};
  return outlineRisks(assessed.map(), {{"structure", "1"}}, progress);
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  if (shared.structure.columns == 0)
    return judgeRandomPhase(result, shared.hasGivenSpectrum, kTargets, comparison);
  Result<std::vector<Measure>> measures = measureResult(comparison.exemplar, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  return {};
}

Result<std::vector<Picture>> pictures(const DrawnMap& drawn) {
  return allOf({encodedPicture(
      cosinesPicture(drawn.bundle.tables[drawn.map.as<LocalRandomPhaseMap>().cosines],
                     drawn.noise.as<LocalRandomPhaseNoise>(), drawn.side),
      "Spectrum of the cosines",
      ". The power of each frequency of the noise, the zero frequency in the middle. A rectangle "
      "is a "
      "cosine, which takes one frequency of it at each vertex of its lattice.")});
}

} // namespace

/// The same pictures as for tiling, with the spectrum in place of the Gaussian image, and a
/// Gaussian version as large as the exemplar.
extern const MethodReport kLocalRandomPhaseReport{
    .assess = assess, .measure = measure, .pictures = pictures, .picturePixels = 9.0};

} // namespace lichen
