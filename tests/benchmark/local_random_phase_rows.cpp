// SPDX-License-Identifier: MIT
// Local random-phase noise: the time of a bake, and its results compared with the Gaussian version
// of each exemplar: its Gaussian values with random phases, decoded by the same table.
#include "exemplars.h"
#include "rows.h"

#include <lichen/gaussian_image.h>
#include <lichen/quality.h>
#include <lichen/spectrum.h>
#include <lichen/synthesize.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <gaussianization/value_decoder.h>

namespace lichen::bench {
namespace {

constexpr int kSide = 1024; // as the prototype in TARGETS.md: 256 x 256 -> 1024 x 1024
constexpr std::uint32_t kSeeds = 3;
constexpr std::uint32_t kReferences = 4;

template <class T>
T require(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "lichen-bench: %s\n", result.error().message.c_str());
    std::exit(int(result.error().kind));
  }
  return std::move(result).value();
}

SrgbImage synthesized(const Bundle& bundle, std::uint32_t seed, int side = kSide) {
  SynthesisOptions options;
  options.material.seed = seed;
  options.width = options.height = side;
  return toSrgb(require(synthesize(bundle, options)));
}

/// The Gaussian versions of the exemplar of a tiling of 16 bits.
std::vector<SrgbImage> gaussianVersions(const Bundle& tiling) {
  const auto& map = tiling.noises[0].maps[0].as<TilingMap>();
  const Table& image = tiling.tables[map.gaussian];
  const std::vector<float> texels = decodeLevel(image, 0);
  const auto stride = std::size_t(channelCount(image.format));
  const int width = int(image.width), height = int(image.height);
  std::vector<HalfSpectrum> spectra;
  for (std::size_t c = 0; c < std::size_t(map.dimensions); ++c) {
    std::vector<float> plane;
    for (std::size_t i = c; i < texels.size(); i += stride)
      plane.push_back(texels[i] + 0.5f - kStoredGaussianMean);
    spectra.push_back(forwardFft(plane, width, height));
  }
  const gaussianization::ValueDecoder decoder(tiling, shaderMap(tiling, tiling.noises[0], 0),
                                              map.inverseTable);
  std::vector<SrgbImage> versions;
  for (std::uint32_t seed = 1; seed <= kReferences; ++seed) {
    std::vector<std::vector<float>> planes;
    for (const HalfSpectrum& spectrum : spectra)
      planes.push_back(phaseRandomizedPlane(spectrum, seed));
    LinearImage result(width, height, 3);
    for (std::size_t i = 0; i < result.pixelCount(); ++i) {
      std::array<float, 4> gaussian{0.5f, 0.5f, 0.5f, 0.0f};
      for (std::size_t c = 0; c < planes.size(); ++c)
        gaussian[c] = planes[c][i];
      const std::array<float, 4> value = decoder.decode(gaussian, 1.0f);
      std::copy_n(value.begin(), 3, &result.values[3 * i]);
    }
    versions.push_back(toSrgb(result));
  }
  return versions;
}

/// A measure of each exemplar, and where the largest is.
struct Measured {
  std::vector<double> values;
  std::string worst;

  void note(double value, const std::string& name) {
    if (values.empty() || value > *std::max_element(values.begin(), values.end()))
      worst = name;
    values.push_back(value);
  }
  [[nodiscard]] double largest() const { return *std::max_element(values.begin(), values.end()); }
};

} // namespace

std::vector<Row> localRandomPhaseRows() {
  constexpr int kRuns = 3;
  constexpr int kStrokesSide = 512, kTrials = 12; // a standard error of 0.01
  Measured seconds, beyond, spectrum, color, covariance, strokes;
  for (const Exemplar& exemplar : exemplars256()) {
    const double whole =
        medianSeconds(kRuns, [&] { return localRandomPhaseBundle(exemplar.image); });
    const double tables = medianSeconds(kRuns, [&] { return bakedBundle(exemplar.image); });
    seconds.note(whole, exemplar.name);
    beyond.note(whole - tables, exemplar.name);
    const Bundle noise = localRandomPhaseBundle(exemplar.image);
    TilingOptions precise;
    precise.bits = 16;
    const Bundle tiling = bakedBundle(exemplar.image, precise);
    const std::vector<SrgbImage> versions = gaussianVersions(tiling);
    double db = 0.0, distance = 0.0, own = 0.0, ofTiling = 0.0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const SrgbImage result = synthesized(noise, seed), tiled = synthesized(tiling, seed);
      for (const SrgbImage& version : versions) {
        const double share = 1.0 / double(kSeeds * versions.size());
        db += share * require(spectrumDistanceDb(version, result));
        distance += share * require(colorDistance(version, result));
        own += share * require(autocovarianceError(version, result));
        ofTiling += share * require(autocovarianceError(version, tiled));
      }
    }
    spectrum.note(db, exemplar.name);
    color.note(distance, exemplar.name);
    covariance.note(own / ofTiling, exemplar.name);
    double excess = 0.0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
      excess += require(strokeExcess(synthesized(noise, seed, kStrokesSide), kTrials)).value;
    strokes.note(excess / kSeeds, exemplar.name);
  }
  const std::string of = "against the Gaussian version, 256 x 256 -> 1024 x 1024, 3 seeds";
  return {
      {"local random phase, bake of 256 x 256 with its table, median", median(seconds.values), 0.3,
       "s", "of which all but the next row is tiling's"},
      {"its part beyond tiling's bake, median", median(beyond.values), kNoTarget, "s", ""},
      {"spectrum_distance_db, median", median(spectrum.values), 0.4, "dB", of},
      {"the same, worst", spectrum.largest(), 1.0, "dB", spectrum.worst},
      {"color_distance, worst", color.largest(), 0.003, "", color.worst},
      {"autocovariance_error over tiling's, median", median(covariance.values), 1.25, "", of},
      {"the same, worst", covariance.largest(), 1.25, "", covariance.worst},
      {"excess of strokes, median", median(strokes.values), kNoTarget, "", "512 x 512, 3 seeds"},
      {"the same, worst", strokes.largest(), kNoTarget, "", strokes.worst}};
}

} // namespace lichen::bench
