// SPDX-License-Identifier: MIT
// Local random-phase noise: the time of a bake, and its results compared with the Gaussian version
// of each exemplar.
#include "exemplars.h"
#include "gaussian_versions.h"
#include "rows.h"
#include "synthesized.h"

#include <lichen/quality.h>

#include <algorithm>

namespace lichen::bench {
namespace {

constexpr int kSide = 1024; // as the prototype in TARGETS.md: 256 x 256 -> 1024 x 1024
constexpr std::uint32_t kSeeds = 3;

} // namespace

std::vector<Row> localRandomPhaseRows() {
  constexpr int kRuns = 3;
  Measured seconds, beyond, spectrum, color, covariance;
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
    const std::vector<SrgbImage> versions = gaussianVersions(exemplar.image);
    double db = 0.0, distance = 0.0, own = 0.0, ofTiling = 0.0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const SrgbImage result = synthesized(noise, kSide, seed),
                      tiled = synthesized(tiling, kSide, seed);
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
  }
  const std::string of = "against the Gaussian version, 256 x 256 -> 1024 x 1024, 3 seeds";
  return {{"local random phase, bake of 256 x 256 with its table, median", median(seconds.values),
           0.3, "s", "of which all but the next row is tiling's"},
          {"its part beyond tiling's bake, median", median(beyond.values), kNoTarget, "s", ""},
          {"spectrum_distance_db, median", median(spectrum.values), 0.4, "dB", of},
          {"the same, worst", spectrum.largest(), 1.0, "dB", spectrum.worst},
          {"color_distance, worst", color.largest(), 0.003, "", color.worst},
          {"autocovariance_error over tiling's, median", median(covariance.values), 1.25, "", of},
          {"the same, worst", covariance.largest(), 1.25, "", covariance.worst}};
}

} // namespace lichen::bench
