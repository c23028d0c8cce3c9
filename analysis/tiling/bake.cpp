// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a noise and its tables.
#include "borders.h"
#include "color_space.h"
#include "gaussian_image.h"
#include "inverse_table.h"
#include "map_fit.h"
#include "map_ranges.h"
#include "mip_chain.h"
#include "normality.h"
#include "prefilter.h"
#include "separable.h"
#include "slab_means.h"
#include "slope_variance.h"
#include "value_encoding.h"

#include <lichen/tiling.h>

#include <algorithm>
#include <numeric>

namespace lichen {
namespace {

using namespace tiling;

/// Whether `covariance` is definite, as the format asks of a map without a table; with room for its
/// rounding in the file.
bool spansAll(const ColorSpace& space) {
  constexpr double kLeastShare = 1e-8; // of the variance, ten times what the format accepts
  const Eigen::SelfAdjointEigenSolver<ChannelMatrix> solver(space.moments.covariance);
  return space.dimensions() == int(space.moments.mean.size()) &&
         solver.eigenvalues()[0] > kLeastShare * space.moments.covariance.trace();
}

Result<void> checkOptions(std::span<const MapExemplar> maps, const TilingOptions& options) {
  const auto usage = [](const std::string& message) { return Error{ErrorKind::usage, message}; };
  if (options.bits != 8 && options.bits != 16)
    return usage("precision " + std::to_string(options.bits) + ": 8 or 16 bits are accepted");
  if (maps.empty())
    return usage("no map to bake: at least one is needed");
  for (const MapExemplar& map : maps) {
    if (Result<void> checked = checkRanges(map); !checked)
      return checked;
    if (options.gaussian == GaussianOnly::yes && !spansAll(colorSpaceOf(map)))
      return usage("the values of " + std::string(nameOf(map.target)) + " span less than " +
                   std::to_string(map.channels.size()) +
                   " dimensions: without an inverse table all are needed, so gaussian auto or no "
                   "is accepted");
  }
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

MapWork workAlone(const MapExemplar& map, bool periodic, TransportEffort effort) {
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

/// Of a map that may have `others` before it, to go with.
MapWork workOf(const MapExemplar& map, bool periodic, TransportEffort effort, bool others) {
  MapWork work = workAlone(map, periodic, effort);
  if (!others || effort == TransportEffort::fast)
    return work;
  const double standard = workAlone(map, periodic, TransportEffort::standard).fit;
  // An exact transport comes after one of the default effort.
  work.fit += (kJoiningWork + (effort == TransportEffort::exact ? 1.0 : 0.0)) * standard;
  return work;
}

/// The tables of a map and what the bundle says of them.
struct MapTables {
  Gaussianized image;
  Table gaussian;
  std::vector<ChannelMatrix> lost; ///< by the mips of `gaussian`
  std::optional<Table> inverse;
  std::vector<double> tableBasis, tableOffset; ///< of a separable table

  MapTables(Gaussianized gaussianized, int bits)
      : image(std::move(gaussianized)), gaussian(gaussianTable(image, bits)),
        lost(lostVariance(gaussian)) {}
};

MapTables jointTables(const MapExemplar& map, const MapFit& fit, int bits) {
  MapTables tables(fit.gaussian, bits);
  std::vector<InverseTable> slabs = prefilteredSlabs(fit.table, tables.lost);
  restoreSlabMeans(slabs, tables.gaussian, tables.lost);
  if (map.encoding == ValueEncoding::slope)
    appendSlopeVariance(slabs, fit.table, tables.gaussian, tables.lost);
  tables.inverse = inverseTableTexels(slabs, map.encoding, bits);
  return tables;
}

MapTables separableTables(const MapExemplar& map, const SeparableFit& fit, int bits) {
  MapTables tables(combinedImage(fit), bits);
  // Values along an axis have either sign, and the darks are differences: always half floats.
  constexpr int kTableBits = 16;
  tables.inverse =
      inverseTableTexels(separableSlabs(fit, bits, tables.lost), map.encoding, kTableBits);
  appendValues(tables.tableBasis, fit.basis);
  appendValues(tables.tableOffset, fit.offset);
  return tables;
}

void appendMap(const MapExemplar& map, const Moments& moments, MapTables tables,
               const std::string& name, TilingBake& bake) {
  NoiseMap result;
  result.target = map.target;
  result.channels = map.channels;
  result.encoding = map.encoding;
  appendValues(result.mean, moments.mean);
  appendValues(result.covariance, moments.covariance);
  double loss = 0.0;
  for (const ChannelMatrix& mip : tables.lost)
    result.mipLoss.push_back(loss = std::max(loss, scalarLoss(mip)));
  const std::string prefix = name + "." + std::string(nameOf(map.target));
  tables.gaussian.name = prefix + ".gaussian";
  result.gaussian = bake.tables.size();
  bake.tables.push_back(std::move(tables.gaussian));
  if (tables.inverse) {
    result.levels = tableLevels();
    result.tableBasis = std::move(tables.tableBasis);
    result.tableOffset = std::move(tables.tableOffset);
    tables.inverse->name = prefix + ".inverse";
    result.inverseTable = bake.tables.size();
    bake.tables.push_back(*std::move(tables.inverse));
  }
  bake.noise.maps.push_back(std::move(result));
}

/// The joint fit. The first map that chooses a share of the surroundings chooses it for all, in
/// `fitting`: their Gaussian images stay alike where the maps are. Where others are to go with the
/// map, it is one of the `settled` after.
MapFit fitJoint(const MapExemplar& map, const ColorSpace& space, MapFitOptions& fitting,
                std::vector<SettledMap>* settled, ProgressPart progress, TilingBake& bake) {
  const MapWork work = workOf(map, fitting.periodic, fitting.transport, !fitting.settled.empty());
  fitting.progress = progress.part(0.0, work.fit / work.whole());
  MapFit fit = fitMap(map, space, fitting);
  if (space.dimensions() > 1)
    fitting.share = fit.share;
  if (settled != nullptr)
    settled->emplace_back(map, space, fit.gaussian, fit.table);
  for (const TransportBound& bound : fit.gaussian.bounds)
    bake.transportBounds.push_back(bound);
  return fit;
}

bool isGaussianOnly(const MapExemplar& map, const ColorSpace& space, GaussianOnly wanted) {
  return wanted == GaussianOnly::yes ||
         (wanted == GaussianOnly::detect && spansAll(space) && isGaussian(map));
}

/// Bakes one map and appends its tables. Only a map with a joint table is `settled` and goes with
/// those that are; nullptr where no map is to come.
void bakeMap(const MapExemplar& map, const std::string& name, const TilingOptions& options,
             MapFitOptions& fitting, std::vector<SettledMap>* settled, ProgressPart progress,
             TilingBake& bake) {
  const ColorSpace space = colorSpaceOf(map);
  const auto append = [&](MapTables tables) {
    appendMap(map, space.moments, std::move(tables), name, bake);
    progress.reach(1.0);
  };
  if (space.dimensions() == 0 && options.gaussian != GaussianOnly::yes)
    return append(jointTables(map, constantFit(map), options.bits));
  if (isGaussianOnly(map, space, options.gaussian))
    return append(MapTables(gaussianImage(map, space.moments, fitting.periodic, fitting.precision),
                            options.bits));
  // Slopes need their variance, and half floats do not hold what light above 1 is along an axis.
  const bool mayBeSeparable =
      map.encoding != ValueEncoding::slope && map.encoding != ValueEncoding::log2;
  if (options.lut == LookupTable::separable && space.dimensions() > 1 && mayBeSeparable) {
    const SeparableFit fit = fitSeparable(map, fitting.periodic, fitting.precision,
                                          transport::optionsFor(fitting.transport));
    if (fit.dimensions() > 1)
      return append(separableTables(map, fit, options.bits));
  }
  append(jointTables(map, fitJoint(map, space, fitting, settled, progress, bake), options.bits));
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
      return workOf(map, bake.exemplarWasPeriodic, options.transport, &map != &maps.front())
          .whole();
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
    const bool joins = options.transport != TransportEffort::fast;
    double done = 0.0;
    for (const MapExemplar& map : maps) {
      const double after = done + workOfMap(map);
      fitting.settled = settled;
      bakeMap(map, name, options, fitting, joins && &map != &maps.back() ? &settled : nullptr,
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
