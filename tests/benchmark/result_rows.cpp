// SPDX-License-Identifier: MIT
// The quality measures of results made from the bundle alone.
#include "exemplars.h"
#include "rows.h"
#include "synthesized.h"

#include <lichen/measures.h>
#include <lichen/synthesize.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set_covariances.h>

namespace lichen::bench {
namespace {

using test::decodedMaps;
using test::norm;

constexpr double kExemplarSide = 256.0;
/// As for the prototype in TARGETS.md: 256 x 256 -> 1024 x 1024.
constexpr int kExemplarsASide = 4;
constexpr int kResultSide = 1024;
/// One draw of the tiles' offsets says little about the worst exemplar.
constexpr std::uint32_t kSeeds = 6;
constexpr int kLatticeSide = kLatticeExemplars * int(kExemplarSide);

/// Covariances between base colour and the other maps' channels; all images have one size.
std::vector<double> crossCovariances(const std::vector<LinearImage>& maps) {
  std::vector<double> covariances;
  for (std::size_t m = 1; m < maps.size(); ++m)
    for (const double covariance : test::crossCovariances(maps.front(), maps[m]))
      covariances.push_back(covariance);
  return covariances;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::minus<>());
  return result;
}

std::vector<LinearImage> resultMaps(const Bundle& bundle, const std::vector<MapExemplar>& set,
                                    std::uint32_t seed) {
  std::vector<LinearImage> images;
  for (const MapExemplar& map : set) {
    SynthesisOptions options;
    options.width = kExemplarsASide * set.front().width;
    options.height = kExemplarsASide * set.front().height;
    options.map = map.target;
    options.material.seed = seed;
    images.push_back(require(synthesize(bundle, options)));
  }
  return images;
}

/// The distance of the covariances between maps from the exemplar's, relative to their norm: the
/// bake's own error, the mean of several results, and the error that chance adds to one of them.
void appendCrossCovarianceRows(std::vector<Row>& rows, const std::vector<MapExemplar>& set,
                               const std::string& how) {
  const Bundle bundle = bakedBundle(set);
  const std::vector<double> wanted = crossCovariances(decodedMaps(set));
  std::vector<std::vector<double>> found;
  std::vector<double> mean(wanted.size(), 0.0);
  double worst = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    found.push_back(crossCovariances(resultMaps(bundle, set, seed)));
    worst = std::max(worst, norm(difference(found.back(), wanted)));
    for (std::size_t k = 0; k < wanted.size(); ++k)
      mean[k] += found.back()[k] / kSeeds;
  }
  double squares = 0.0;
  for (const std::vector<double>& one : found)
    squares += std::pow(norm(difference(one, mean)), 2.0);
  const double standardError = std::sqrt(squares / (kSeeds * (kSeeds - 1.0)));
  const auto percent = [&](double value) { return 100.0 * value / norm(wanted); };
  char chance[32];
  std::snprintf(chance, sizeof chance, "%.1f %%", percent(standardError));
  rows.push_back({"cross-covariance between the maps of a set, 4 exemplars a side, mean of 6 seeds",
                  percent(norm(difference(mean, wanted))), 3.0, "%",
                  how + ": base colour with the others; standard error " + chance});
  rows.push_back({"the same, worst of 6", percent(worst), 3.0, "%", how});
}

} // namespace

std::vector<Row> resultRows() {
  Measured color, lattice, spectrum, seam;
  for (const Exemplar& exemplar : exemplars256()) {
    const Bundle bundle = bakedBundle(exemplar.image);
    const LatticeView view{infiniteLattice(bundle.noises[0].as<TilingNoise>().grain),
                           1.0 / kExemplarSide, 1.0 / kExemplarSide};
    const auto meanOf = [&](int side, auto measure) {
      double sum = 0.0;
      for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
        sum += require(measure(synthesized(bundle, side, seed)));
      return sum / kSeeds;
    };
    const auto mean = [&](auto distance) {
      return meanOf(kResultSide,
                    [&](const SrgbImage& result) { return distance(exemplar.image, result); });
    };
    color.note(mean(colorDistance), exemplar.name);
    spectrum.note(mean(spectrumDistanceDb), exemplar.name);
    seam.note(mean(seamVisibility), exemplar.name);
    lattice.note(meanOf(kLatticeSide,
                        [&](const SrgbImage& result) { return latticeVisibility(result, view); }),
                 exemplar.name);
  }
  std::vector<Row> rows;
  const std::string how = ", mean of 6 seeds each";
  color.append(rows, "color_distance, 4 exemplars a side", kColorDistanceTarget, "", how);
  lattice.append(rows, "lattice_visibility, 16 exemplars a side", kLatticeVisibilityTarget, "",
                 how);
  spectrum.append(rows, "spectrum_distance_db, 4 exemplars a side", kSpectrumDistanceTargetDb, "dB",
                  how);
  seam.append(rows, "seam_visibility, 4 exemplars a side", kSeamVisibilityTarget, "", how);
  appendCrossCovarianceRows(rows, materialSet(int(kExemplarSide)), "rust");
  for (const MaterialSet& set : photographedSets())
    appendCrossCovarianceRows(rows, set.maps, set.name);
  return rows;
}

} // namespace lichen::bench
