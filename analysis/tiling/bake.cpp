// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a noise and its tables.
#include "borders.h"
#include "color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"
#include "map_fit.h"
#include "map_ranges.h"
#include "mip_chain.h"
#include "prefilter.h"
#include "slab_means.h"
#include "value_encoding.h"

#include <lichen/tiling.h>

#include <algorithm>
#include <numeric>

namespace lichen {
namespace {

using namespace tiling;

Result<void> checkOptions(std::span<const MapExemplar> maps, const TilingOptions& options) {
  const auto usage = [](const std::string& message) { return Error{ErrorKind::usage, message}; };
  if (options.bits != 8 && options.bits != 16)
    return usage("precision " + std::to_string(options.bits) + ": 8 or 16 bits are accepted");
  if (maps.empty())
    return usage("no map to bake: at least one is needed");
  for (const MapExemplar& map : maps)
    if (Result<void> checked = checkRanges(map); !checked)
      return checked;
  return {};
}

/// A map that does not vary: nothing to match, one constant for image and table.
MapFit constantFit(const MapExemplar& map) {
  MapFit fit;
  fit.gaussian.width = map.width;
  fit.gaussian.height = map.height;
  fit.gaussian.image.assign(std::size_t(map.width) * std::size_t(map.height),
                            Point{float(kGaussianMean), 0.0f, 0.0f});
  fit.table.channels = int(map.channels.size());
  for (int cell = 0; cell < fit.table.side; ++cell)
    for (std::size_t c = 0; c < map.channels.size(); ++c)
      fit.table.values.push_back(decoded(map.values[c], map.encoding));
  return fit;
}

void appendValues(std::vector<double>& to, const auto& matrix) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      to.push_back(matrix(row, column));
}

/// What the steps of a map's bake take, in units of transporting a pixel by the default effort.
/// More than one trial of a share is not foreseen: most photographs need none.
struct MapWork {
  double fit = 0.0;
  double slabs = 0.0;

  [[nodiscard]] double whole() const { return fit + slabs; }
};

MapWork workOf(const MapExemplar& map, bool periodic, TransportEffort effort) {
  // Nearly the same for every exemplar; measured on 256 x 256.
  constexpr double kTable = 0.7 * 65536.0;
  constexpr double kSlabs = 0.4 * 65536.0;
  // By the rounds of optionsFor() and docs/decisions/008-multiscale-transport.md.
  constexpr double kFast = 0.5;
  // A photograph's certificate, 4 s, over its default transport, 0.38 s.
  constexpr double kExact = 12.0;
  const double pixels = double(map.width) * double(map.height);
  const double transport = (periodic ? 1.0 : 2.0) * pixels;
  switch (effort) {
  case TransportEffort::fast:
    return {kTable + kFast * transport, kSlabs};
  case TransportEffort::standard:
    break;
  case TransportEffort::exact:
    return {kTable + kExact * transport, kSlabs};
  }
  return {kTable + transport, kSlabs};
}

/// Bakes one map and appends its two tables. The first map that chooses a share of the surroundings
/// chooses it for all, in `fitting`: their Gaussian images stay alike where the maps are. In a set,
/// `settled` are the maps before it, and it joins them.
void bakeMap(const MapExemplar& map, const std::string& name, int bits, MapFitOptions& fitting,
             std::vector<SettledMap>* settled, ProgressPart progress, TilingBake& bake) {
  const MapWork work = workOf(map, fitting.periodic, fitting.transport);
  const double fitted = work.fit / work.whole();
  const ColorSpace space = colorSpaceOf(map);
  MapFit fit;
  if (space.dimensions() == 0) {
    fit = constantFit(map);
  } else {
    fitting.progress = progress.part(0.0, fitted);
    if (settled != nullptr)
      fitting.settled = *settled;
    fit = fitMap(map, space, fitting);
    if (space.dimensions() > 1)
      fitting.share = fit.share;
    if (settled != nullptr)
      settled->push_back(settledMap(map, space, fit.gaussian, fit.table));
    for (const TransportBound& bound : fit.gaussian.bounds)
      bake.transportBounds.push_back(bound);
  }
  Table image = gaussianTable(fit.gaussian, bits);
  const std::vector<ChannelMatrix> lost = lostVariance(image);
  std::vector<InverseTable> slabs = prefilteredSlabs(fit.table, lost);
  restoreSlabMeans(slabs, image, lost);
  Table inverse = inverseTableTexels(slabs, map.encoding, bits);

  NoiseMap result;
  result.target = map.target;
  result.channels = map.channels;
  result.encoding = map.encoding;
  appendValues(result.mean, space.moments.mean);
  appendValues(result.covariance, space.moments.covariance);
  result.levels = tableLevels();
  double loss = 0.0;
  for (const ChannelMatrix& mip : lost)
    result.mipLoss.push_back(loss = std::max(loss, scalarLoss(mip)));
  const std::string prefix = name + "." + std::string(nameOf(map.target));
  image.name = prefix + ".gaussian";
  inverse.name = prefix + ".inverse";
  result.gaussian = bake.tables.size();
  bake.tables.push_back(std::move(image));
  result.inverseTable = bake.tables.size();
  bake.tables.push_back(std::move(inverse));
  bake.noise.maps.push_back(std::move(result));
  progress.reach(1.0);
}

/// As bakeTiling(), but throws std::bad_alloc.
Result<TilingBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                            const TilingOptions& options) {
  if (Result<void> checked = checkOptions(maps, options); !checked)
    return checked.error();
  try {
    TilingBake bake;
    bake.noise.name = name;
    bake.exemplarWasPeriodic = bordersFit(maps, options.periodic);
    const auto workOfMap = [&](const MapExemplar& map) {
      return workOf(map, bake.exemplarWasPeriodic, options.transport).whole();
    };
    double whole = 0.0;
    for (const MapExemplar& map : maps)
      whole += workOfMap(map);
    MapFitOptions fitting;
    fitting.periodic = bake.exemplarWasPeriodic;
    fitting.precision = options.bits == 8 ? Precision::bits8 : Precision::bits16;
    fitting.transport = options.transport;
    fitting.largestShare = maps.size() == 1 ? kLargestShare : kLargestShareInSet;
    std::vector<SettledMap> settled;
    double done = 0.0;
    for (const MapExemplar& map : maps) {
      const double after = done + workOfMap(map);
      bakeMap(map, name, options.bits, fitting, maps.size() > 1 ? &settled : nullptr,
              ProgressPart(options.progress).part(done / whole, after / whole), bake);
      done = after;
    }
    return bake;
  } catch (const Interrupted&) {
    return Error{ErrorKind::environment, name + ": interrupted"};
  }
}

} // namespace

bool bordersFit(std::span<const MapExemplar> maps, Periodic periodic) {
  return periodic == Periodic::yes ||
         (periodic == Periodic::detect && std::all_of(maps.begin(), maps.end(), isPeriodic));
}

Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                              const TilingOptions& options) {
  const auto exhausted = [&] {
    const std::string pixels = maps.empty() ? "nothing"
                                            : std::to_string(maps.front().width) + " x " +
                                                  std::to_string(maps.front().height) + " pixels";
    return name + ": not enough memory to bake " + pixels;
  };
  return withinMemory(exhausted, [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
