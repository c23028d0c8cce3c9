// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> Gaussian images and inverse tables.
#include "gaussianized_maps.h"

#include "exemplar/color_space.h"
#include "exemplar/grain.h"
#include "exemplar/value_encoding.h"
#include "gaussianize.h"
#include "level_means.h"
#include "map_fit.h"
#include "mip_chain.h"
#include "normality.h"
#include "prefilter.h"

#include <lichen/table.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace lichen::gaussian {
namespace {

/// Whether the covariance is positive definite, as the format requires of a map without a table,
/// with a margin for rounding in the file.
bool spansAll(const MapExemplar& map) {
  const exemplar::ColorSpace space = exemplar::colorSpaceOf(exemplar::asStored(map));
  constexpr double kLeastShare = 1e-8; // of the variance, ten times what the format accepts
  const auto solver = transport::principalAxes(space.moments.covariance);
  return space.dimensions() == int(space.moments.mean.size()) &&
         solver.eigenvalues()[0] > kLeastShare * space.moments.covariance.trace();
}

Result<void> checkOptions(std::span<const MapExemplar> maps,
                          const GaussianizationOptions& options) {
  const auto usage = [](const std::string& message) { return Error{ErrorKind::usage, message}; };
  if (options.bits != 8 && options.bits != 16)
    return usage("precision " + std::to_string(options.bits) + "; expected 8 or 16 bits");
  if (maps.empty())
    return usage("no map to bake; expected at least one");
  for (const MapExemplar& map : maps) {
    if (Result<void> checked = exemplar::checkRanges(map); !checked)
      return checked;
    if (options.gaussian == GaussianOnly::yes && !spansAll(map))
      return usage(
          "the values of " + std::string(nameOf(map.target)) + " span less than " +
          std::to_string(map.channels.size()) +
          " dimensions, and a bake without an inverse table needs all; expected gaussian auto "
          "or no");
  }
  return {};
}

/// The fit of a map that does not vary: one constant for image and table.
MapFit constantFit(const MapExemplar& map) {
  MapFit fit;
  fit.gaussian.width = map.width;
  fit.gaussian.height = map.height;
  fit.gaussian.image.assign(std::size_t(map.width) * std::size_t(map.height),
                            Point{float(gaussian::kGaussianMean), 0.0f, 0.0f});
  fit.table.channels = int(map.channels.size());
  for (int cell = 0; cell < fit.table.side; ++cell)
    for (std::size_t c = 0; c < map.channels.size(); ++c)
      fit.table.values.push_back(exemplar::tableValue(map.values[c], map.encoding));
  return fit;
}

void appendValues(std::vector<double>& to, const auto& matrix) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      to.push_back(matrix(row, column));
}

/// How the values of a map are stored.
enum class MapKind { constant, gaussianOnly, sorted, transported };

/// A map and the way it will be stored.
struct PlannedMap {
  const MapExemplar& map;
  exemplar::ColorSpace space;
  MapKind kind;
};

/// A map without a table cannot correlate with others, so maps of a set are not tested.
bool detectsGaussian(std::size_t maps, GaussianOnly wanted) {
  return maps == 1 && wanted == GaussianOnly::detect;
}

MapKind kindOf(const MapExemplar& map, const exemplar::ColorSpace& space,
               const GaussianizationOptions& options, bool mayBeGaussian) {
  if (options.gaussian == GaussianOnly::yes)
    return MapKind::gaussianOnly;
  if (space.dimensions() == 0)
    return MapKind::constant;
  if (mayBeGaussian && spansAll(map) && gaussian::isGaussian(exemplar::asStored(map)))
    return MapKind::gaussianOnly;
  if (space.dimensions() == 1)
    return MapKind::sorted;
  return MapKind::transported;
}

/// A map's Gaussian image, with mips too, and its inverse table.
struct MapTables {
  Gaussianized image;
  Table gaussian;
  std::optional<Table> inverse;
};

/// Parts of the progress: of the plan in a bake, of the fit in a map, and of the mips in what
/// follows; the levels of the table take the rest.
constexpr double kPlanOfProgress = 0.02, kFitOfProgress = 0.9, kMipsOfProgress = 0.5;

MapTables jointTables(const MapExemplar& map, MapFit fit, int bits, ProgressPart progress) {
  progress.reach(0.0);
  Table gaussian = gaussianTable(fit.gaussian, bits);
  MapTables tables{std::move(fit.gaussian), std::move(gaussian), {}};
  const std::vector<exemplar::ChannelMatrix> lost =
      lostVariance(tables.gaussian, tables.image.dimensions);
  const std::vector<float> losses = fetchLosses(tables.gaussian);
  progress.reach(kMipsOfProgress);
  const ValueEncoding encoding = exemplar::storedEncoding(map.encoding);
  const bool holdsRoots = encoding == ValueEncoding::root;
  std::vector<InverseTable> levels = prefilteredLevels(fit.table, lost, holdsRoots);
  restoreLevelMeans(levels, holdsRoots, tables.gaussian, losses);
  if (encoding == ValueEncoding::slope)
    appendSlopeVariance(levels, fit.table, tables.gaussian, lost, losses);
  tables.inverse = inverseTableTexels(levels, encoding, bits);
  return tables;
}

GaussianizedMap gaussianizedMap(const MapExemplar& map, MapTables tables, const std::string& name) {
  const MapExemplar stored = exemplar::asStored(map);
  const exemplar::Moments moments = exemplar::momentsOf(stored.values, int(stored.channels.size()));
  GaussianizedMap result;
  result.map.target = map.target;
  result.map.channels = map.channels;
  result.map.encoding = stored.encoding;
  appendValues(result.map.mean, moments.mean);
  appendValues(result.map.covariance, moments.covariance);
  result.image = std::move(tables.image);
  const std::string prefix = name + "." + std::string(nameOf(map.target));
  result.gaussian = std::move(tables.gaussian);
  result.gaussian.name = prefix + ".gaussian";
  result.inverse = std::move(tables.inverse);
  if (result.inverse)
    result.inverse->name = prefix + ".inverse";
  return result;
}

/// Makes the joint fit. The first map that chooses a share of the surroundings chooses it for all,
/// in `fitting`, so that Gaussian images are similar where the maps are. If `settled` is not null,
/// the map is appended to it for later maps.
MapFit fitJoint(const PlannedMap& planned, MapFitOptions& fitting, std::vector<SettledMap>* settled,
                ProgressPart progress) {
  fitting.progress = progress;
  MapFit fit = fitMap(planned.map, planned.space, fitting);
  if (planned.space.dimensions() > 1)
    fitting.share = fit.share;
  if (settled != nullptr)
    settled->emplace_back(planned.map, planned.space, fit.gaussian, fit.table);
  return fit;
}

/// Makes the map's tables, of the planned kind. Only a map with a joint table correlates with the
/// `settled` maps and joins them; `settled` is nullptr if no map follows.
MapTables tablesOf(const PlannedMap& planned, int bits, MapFitOptions& fitting,
                   std::vector<SettledMap>* settled, ProgressPart progress) {
  const MapExemplar& map = planned.map;
  const ProgressPart first = progress.part(0.0, kFitOfProgress);
  const ProgressPart rest = progress.part(kFitOfProgress, 1.0);
  first.reach(0.0);
  if (planned.kind == MapKind::constant)
    return jointTables(map, constantFit(map), bits, rest);
  if (planned.kind == MapKind::gaussianOnly) {
    Gaussianized image =
        gaussianImage(exemplar::asStored(map), fitting.borders, fitting.precision, first);
    rest.reach(0.0);
    Table gaussian = gaussianTable(image, bits);
    return {std::move(image), std::move(gaussian), std::nullopt};
  }
  return jointTables(map, fitJoint(planned, fitting, settled, first), bits, rest);
}

/// Plans each map. `progress` covers only this step.
std::vector<PlannedMap> plannedMaps(std::span<const MapExemplar> maps,
                                    const GaussianizationOptions& options, ProgressPart progress) {
  std::vector<PlannedMap> planned;
  const bool mayBeGaussian = detectsGaussian(maps.size(), options.gaussian);
  for (const MapExemplar& map : maps) {
    progress.reach(double(planned.size()) / double(maps.size()));
    const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
    planned.push_back({map, space, kindOf(map, space, options, mayBeGaussian)});
  }
  return planned;
}

} // namespace

Result<gaussian::BorderTreatment> gaussianizeMaps(const std::string& name,
                                                  std::span<const MapExemplar> maps,
                                                  const GaussianizationOptions& options,
                                                  UsesGrain usesGrain, const MapConsumer& consume) {
  if (Result<void> checked = checkOptions(maps, options); !checked)
    return checked.error();
  try {
    const Grain grain = usesGrain == UsesGrain::yes ? exemplar::grainOf(maps.front()) : Grain::none;
    const gaussian::BorderTreatment borders{bordersFit(maps, options.periodic), grain};
    const ProgressPart progress(options.progress);
    const std::vector<PlannedMap> planned =
        plannedMaps(maps, options, progress.part(0.0, kPlanOfProgress));
    const auto pixels = [](double sum, const MapExemplar& map) {
      return sum + double(map.width) * double(map.height);
    };
    const double whole = std::accumulate(maps.begin(), maps.end(), 0.0, pixels);
    MapFitOptions fitting;
    fitting.borders = borders;
    fitting.precision =
        options.bits == 8 ? gaussian::Precision::bits8 : gaussian::Precision::bits16;
    fitting.largestShare = maps.size() == 1 ? kLargestShare : kLargestShareInSet;
    std::vector<SettledMap> settled;
    double done = 0.0;
    const ProgressPart bakes = progress.part(kPlanOfProgress, 1.0);
    for (const PlannedMap& map : planned) {
      const double after = pixels(done, map.map);
      fitting.settled = settled;
      const ProgressPart part = bakes.part(done / whole, after / whole);
      std::vector<SettledMap>* const joined = &map != &planned.back() ? &settled : nullptr;
      consume(gaussianizedMap(map.map, tablesOf(map, options.bits, fitting, joined, part), name));
      part.reach(1.0);
      done = after;
    }
    return borders;
  } catch (const Interrupted&) {
    return Error{ErrorKind::environment, name + ": interrupted"};
  }
}

std::size_t appended(Table table, std::vector<Table>& tables) {
  tables.push_back(std::move(table));
  return tables.size() - 1;
}

std::string noMemoryToBake(const std::string& name, std::span<const MapExemplar> maps) {
  const std::string pixels = maps.empty() ? "nothing"
                                          : std::to_string(maps.front().width) + " x " +
                                                std::to_string(maps.front().height) + " pixels";
  return name + ": not enough memory to bake " + pixels;
}

} // namespace lichen::gaussian
