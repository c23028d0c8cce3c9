// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a quilting noise and its tables.
#include "cells.h"
#include "closed_borders.h"
#include "exemplar/color_space.h"
#include "exemplar/grain.h"
#include "exemplar/planes.h"
#include "exemplar/value_encoding.h"
#include "fitting_shifts.h"
#include "placement/near_periods.h"
#include "progress_part.h"

#include <lichen/quilting.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

/// Cells in a tile of an exemplar that does not repeat, and the fewest of one that does.
constexpr double kUsualCells = 150.0, kFewestCells = 40.0;

Result<void> checkOptions(std::span<const MapExemplar> maps, const QuiltingOptions& options) {
  if (options.bits != 8 && options.bits != 16)
    return Error{ErrorKind::usage,
                 "precision " + std::to_string(options.bits) + "; expected 8 or 16 bits"};
  if (options.guide && !(*options.guide >= kGuideRange.least && *options.guide <= kGuideRange.most))
    return Error{ErrorKind::usage, "guide: expected 0 to 1"};
  if (maps.empty())
    return Error{ErrorKind::usage, "no map to bake; expected at least one"};
  return exemplar::checkRanges(maps);
}

TexelFormat formatOf(const MapExemplar& map, int bits) {
  const bool isFloat =
      bits == 16 || map.encoding == ValueEncoding::slope || map.encoding == ValueEncoding::log2;
  switch (map.encoding == ValueEncoding::slope ? 3 : map.channels.size()) {
  case 1:
    return isFloat ? TexelFormat::r16Sfloat : TexelFormat::r8Unorm;
  case 2:
    return isFloat ? TexelFormat::rg16Sfloat : TexelFormat::rg8Unorm;
  default:
    return isFloat ? TexelFormat::rgba16Sfloat : TexelFormat::rgba8Unorm;
  }
}

/// The image that QuiltingMap describes.
Table imageOf(const MapExemplar& map, int bits) {
  Table table;
  table.format = formatOf(map, bits);
  table.width = std::uint32_t(map.width);
  table.height = std::uint32_t(map.height);
  const bool isSlope = map.encoding == ValueEncoding::slope;
  const int stored = channelCount(table.format);
  const auto channels = map.channels.size();
  exemplar::ImageLevel level{map.width, map.height, stored, {}}; // of decoded values
  for (std::size_t i = 0; i < map.values.size(); i += channels) {
    std::array<float, 4> texel{0.0f, 0.0f, 0.0f, 1.0f};
    for (std::size_t c = 0; c < channels; ++c)
      texel[c] = exemplar::decoded(map.values[i + c], map.encoding);
    if (isSlope)
      texel[2] = 0.5f * (texel[0] * texel[0] + texel[1] * texel[1]);
    level.values.insert(level.values.end(), texel.begin(), texel.begin() + stored);
  }
  while (true) {
    std::vector<float> texels = level.values;
    for (std::size_t i = 0; i < texels.size(); ++i)
      if (i % std::size_t(stored) < channels)
        texels[i] = exemplar::encoded(texels[i], map.encoding);
    appendTexels(table.texels, table.format, texels);
    if (level.width == 1 && level.height == 1)
      return table;
    level = exemplar::areaAverage(level);
    ++table.mipLevels;
  }
}

NoiseMap noiseMapOf(const MapExemplar& map) {
  const exemplar::Moments moments = exemplar::momentsOf(map.values, int(map.channels.size()));
  NoiseMap result;
  result.target = map.target;
  result.channels = map.channels;
  result.encoding = map.encoding;
  for (Eigen::Index i = 0; i < moments.mean.size(); ++i)
    result.mean.push_back(moments.mean[i]);
  for (Eigen::Index i = 0; i < moments.covariance.size(); ++i)
    result.covariance.push_back(moments.covariance(i)); // symmetric
  return result;
}

/// [-1/2, 1/2) -> [0, 1).
std::array<double, 2> asOffset(const std::array<double, 2>& shift) {
  return {shift[0] < 0.0 ? shift[0] + 1.0 : shift[0], shift[1] < 0.0 ? shift[1] + 1.0 : shift[1]};
}

/// How highly tiles at these offsets correlate with one another on average, over all channels of
/// the first map: by the variance of their mean.
double correlationOf(const MapExemplar& map, std::span<const std::array<double, 2>> offsets) {
  if (offsets.size() < 2)
    return 0.0;
  const std::size_t channels = map.channels.size();
  std::vector<float> sums(map.values.size());
  const std::size_t rowValues = std::size_t(map.width) * channels;
  for (const std::array<double, 2>& offset : offsets) {
    const auto along = std::size_t(placement::pixelsOf(offset[0], map.width)) * channels;
    const int down = placement::pixelsOf(offset[1], map.height);
    for (int y = 0; y < map.height; ++y) {
      const float* const from = &map.values[std::size_t((y + down) % map.height) * rowValues];
      float* const sum = &sums[std::size_t(y) * rowValues];
      for (std::size_t i = 0; i < rowValues - along; ++i)
        sum[i] += from[i + along];
      for (std::size_t i = rowValues - along; i < rowValues; ++i)
        sum[i] += from[i + along - rowValues];
    }
  }
  const auto varianceOf = [&](const std::vector<float>& values) {
    return exemplar::momentsOf(values, int(channels)).covariance.trace();
  };
  const auto count = double(offsets.size());
  const double variance = varianceOf(map.values);
  const double ofMean = varianceOf(sums) / (count * count);
  return variance > 0.0 ? std::clamp((count * ofMean / variance - 1.0) / (count - 1.0), 0.0, 1.0)
                        : 0.0;
}

std::size_t appended(Table table, std::string name, std::vector<Table>& tables) {
  table.name = std::move(name);
  tables.push_back(std::move(table));
  return tables.size() - 1;
}

/// As bakeQuilting(), but throws std::bad_alloc.
Result<MethodBake> bakeMaps(const std::string& name, std::span<const MapExemplar> given,
                            const QuiltingOptions& options) {
  if (Result<void> checked = checkOptions(given, options); !checked)
    return checked.error();
  constexpr double kPeriodsOfProgress = 0.1, kBordersOfProgress = 0.6, kCellsOfProgress = 0.9;
  const ProgressPart progress(options.progress);
  progress.reach(0.0);
  MethodBake bake;
  bake.noise.name = name;
  bake.borderTreatment = "cuts";
  std::vector<MapExemplar> maps = exemplar::asStored(given);
  constexpr std::size_t kMostSought = 64; // how many there are says how large cells are
  const placement::NearPeriods periods = placement::nearPeriods(maps, kMostSought, options.guide);
  const double count =
      periods.shifts.empty() ? kUsualCells : std::max(kFewestCells, double(periods.shifts.size()));
  bake.figures.strength = periods.strength;
  progress.reach(kPeriodsOfProgress);
  quilting::CellField field = quilting::cellsOf(maps, count);
  const quilting::FittingShifts fitting = quilting::fittingShifts(field, periods.shifts);
  if (!bordersFit(given, options.periodic) &&
      quilting::closeBorders(maps, field, count, fitting,
                             progress.part(kPeriodsOfProgress, kBordersOfProgress))) {
    bake.figures.bordersWereKept = false;
    field = quilting::cellsOf(maps, count);
  }
  const quilting::CellImage cells = quilting::cellImage(field, options.bits);
  progress.reach(kCellsOfProgress);
  QuiltingNoise shared;
  shared.grain = exemplar::grainOf(given.front());
  shared.reach = cells.reach;
  for (const std::array<double, 2>& shift : fitting.shifts)
    if (shared.offsets.size() < kMostQuiltingOffsets)
      shared.offsets.push_back(asOffset(shift));
  shared.correlation = correlationOf(maps.front(), shared.offsets);
  bake.noise.data = shared;
  const std::size_t cellTable = appended(cells.table, name + ".cells", bake.tables);
  for (const MapExemplar& map : maps) {
    NoiseMap noiseMap = noiseMapOf(map);
    const std::size_t image =
        appended(imageOf(map, options.bits),
                 name + "." + std::string(nameOf(map.target)) + ".image", bake.tables);
    noiseMap.data = QuiltingMap{image, cellTable};
    bake.noise.maps.push_back(std::move(noiseMap));
  }
  progress.reach(1.0);
  return bake;
}

} // namespace

Result<MethodBake> bakeQuilting(std::string name, std::span<const MapExemplar> maps,
                                const QuiltingOptions& options) {
  const auto exhausted = [&] { return name + ": not enough memory to bake the noise"; };
  return withinMemory(exhausted, [&]() -> Result<MethodBake> {
    return unlessInterrupted(name, [&] { return bakeMaps(name, maps, options); });
  });
}

} // namespace lichen
