// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a noise and its tables.
#include "borders.h"
#include "color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"
#include "mip_chain.h"
#include "prefilter.h"
#include "slab_means.h"
#include "transport/lower_bound.h"

#include <lichen/image_io.h>
#include <lichen/tiling.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

namespace lichen {
namespace {

using namespace tiling;
using transport::TransportOptions;

float decoded(float value, ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return srgbToLinear(value);
  case ValueEncoding::log2:
    return std::exp2(value) - 1.0f;
  case ValueEncoding::linear:
  case ValueEncoding::slope:
    return value;
  }
  return value;
}

std::vector<float> decodedValues(const MapExemplar& map) {
  std::vector<float> values(map.values.size());
  std::transform(map.values.begin(), map.values.end(), values.begin(),
                 [&](float v) { return decoded(v, map.encoding); });
  return values;
}

Result<void> checkOptions(std::span<const MapExemplar> maps, const TilingOptions& options) {
  const auto usage = [](const std::string& message) { return Error{ErrorKind::usage, message}; };
  if (options.bits != 8 && options.bits != 16)
    return usage("precision " + std::to_string(options.bits) + ": 8 or 16 bits are accepted");
  if (maps.empty())
    return usage("no map to bake: at least one is needed");
  for (const MapExemplar& map : maps) {
    if (map.width < 1 || map.height < 1 || map.width > kMaxImageSide || map.height > kMaxImageSide)
      return usage("a map of " + std::to_string(map.width) + " x " + std::to_string(map.height) +
                   " pixels: sides from 1 to " + std::to_string(kMaxImageSide) + " are accepted");
    if (map.channels.empty() || map.channels.size() > std::size_t(kMaxChannels))
      return usage("a map of " + std::to_string(map.channels.size()) +
                   " channels: 1 to 3 are accepted");
    if (map.values.size() != std::size_t(map.width) * std::size_t(map.height) * map.channels.size())
      return usage("a map with " + std::to_string(map.values.size()) +
                   " values: width x height x channels are needed");
    if (!std::all_of(map.values.begin(), map.values.end(),
                     [](float v) { return std::isfinite(v); }))
      return usage("a map with a value that is not finite: finite values are accepted");
    if (!(map.quantum > 0.0) || !(map.quantum <= 1.0))
      return usage("a quantum of " + std::to_string(map.quantum) +
                   ": above 0 and at most 1 is accepted");
  }
  return {};
}

/// An image that does not vary: nothing to match, one constant for image and table.
Gaussianized constantGaussian(const MapExemplar& map) {
  Gaussianized result;
  result.width = map.width;
  result.height = map.height;
  result.matched.assign(std::size_t(map.width) * std::size_t(map.height),
                        Point{float(kGaussianMean), 0.0f, 0.0f});
  result.image = result.matched;
  return result;
}

void appendValues(std::vector<double>& to, const auto& matrix) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      to.push_back(matrix(row, column));
}

/// What the table and its levels take, in units of transporting a pixel: nearly the same for every
/// exemplar. Measured on 256 x 256.
constexpr double kTableWork = 65536.0;

double gaussianizeWork(const MapExemplar& map, bool periodic) {
  return (periodic ? 1.0 : 2.0) * double(map.width) * double(map.height);
}

/// A bound half a step below the optimum leaves room for an excess of 0.03 %.
constexpr double kCertificateStep = 2e-4;

TransportBound certificate(const std::vector<Point>& points, const std::vector<Point>& matched,
                           ProgressPart progress) {
  std::vector<std::uint32_t> itself(points.size());
  std::iota(itself.begin(), itself.end(), 0u);
  return transport::boundTransportCost(points, matched, itself, kCertificateStep, progress);
}

/// Bakes one map and appends its two tables.
void bakeMap(const MapExemplar& map, bool periodic, const std::string& name,
             const TilingOptions& options, ProgressPart progress, TilingBake& bake) {
  const double work = gaussianizeWork(map, periodic);
  const double gaussianized = work / (work + kTableWork);
  TransportOptions transport = transport::optionsFor(options.transport);
  const Precision precision = options.bits == 8 ? Precision::bits8 : Precision::bits16;
  const ColorSpace space = colorSpaceOf(map);
  const std::vector<float> values = decodedValues(map);
  std::vector<Point> points;
  Gaussianized gaussian;
  if (space.dimensions() == 0) {
    gaussian = constantGaussian(map);
  } else {
    points = transportPoints(map, space);
    transport.progress = progress.part(0.0, gaussianized);
    gaussian = gaussianize(map, points, space.dimensions(), periodic, precision, transport);
    if (options.transport == TransportEffort::exact)
      bake.transportBounds.push_back(
          certificate(points, gaussian.matched, progress.part(gaussianized, 1.0)));
  }
  Table image = gaussianTable(gaussian, options.bits);
  const std::vector<ChannelMatrix> lost = lostVariance(image);
  transport.progress = progress.part(gaussianized, 1.0);
  const InverseTable table =
      fitInverseTable(gaussian, points, values, int(map.channels.size()), transport);
  std::vector<InverseTable> slabs = prefilteredSlabs(table, lost);
  restoreSlabMeans(slabs, image, lost);
  Table inverse = inverseTableTexels(slabs, map.encoding, options.bits);

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

} // namespace

Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                              const TilingOptions& options) {
  if (Result<void> checked = checkOptions(maps, options); !checked)
    return checked.error();
  try {
    TilingBake bake;
    bake.noise.name = name;
    bake.exemplarWasPeriodic =
        options.periodic == Periodic::yes ||
        (options.periodic == Periodic::detect && std::all_of(maps.begin(), maps.end(), isPeriodic));
    double whole = 0.0;
    for (const MapExemplar& map : maps)
      whole += gaussianizeWork(map, bake.exemplarWasPeriodic) + kTableWork;
    double done = 0.0;
    for (const MapExemplar& map : maps) {
      const double after = done + gaussianizeWork(map, bake.exemplarWasPeriodic) + kTableWork;
      bakeMap(map, bake.exemplarWasPeriodic, name, options,
              ProgressPart(options.progress).part(done / whole, after / whole), bake);
      done = after;
    }
    return bake;
  } catch (const Interrupted&) {
    return Error{ErrorKind::environment, name + ": interrupted"};
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, name + ": not enough memory to bake " +
                                           std::to_string(maps.front().width) + " x " +
                                           std::to_string(maps.front().height) + " pixels"};
  }
}

} // namespace lichen
