// SPDX-License-Identifier: MIT
// Reads the tiling members of a map and checks them against one another and against the tables. D
// is the number of channels of the Gaussian image, n that of the map, L that of the levels.
#include "tiling_format.h"

#include <lichen/counted.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lichen {
namespace {

using nlohmann::json;

/// 64 slabs of a 32^3 table have a depth of 2,048, the smallest limit of desktop devices.
constexpr std::size_t kMaxTableLevels = 64;
constexpr double kLevelTolerance = 1e-6;

void checkGaussian(ObjectReader& reader, const NoiseMap& map, const TilingMap& tiling,
                   const Table& image) {
  const auto fullChain = std::uint32_t(std::bit_width(std::max(image.width, image.height)));
  const std::size_t dimensions = usedChannels(image.format);
  if (image.depth != 0)
    return reader.error("map-gaussian", "gaussian", shapeOf(image) + "; expected a 2-D image");
  if (image.format == TexelFormat::rgba8Srgb)
    return reader.error("map-gaussian", "gaussian", "an sRGB format; expected a linear one");
  if (image.mipLevels != fullChain)
    return reader.error("map-gaussian", "gaussian",
                        counted(image.mipLevels, "mip level") + "; expected the full chain of " +
                            std::to_string(fullChain));
  if (!map.channels.empty() && dimensions > map.channels.size())
    return reader.error("map-gaussian", "gaussian",
                        counted(dimensions, "channel") + "; expected at most those of the map, " +
                            std::to_string(map.channels.size()));
  if (!tiling.inverseTable && !map.channels.empty() && dimensions != map.channels.size())
    return reader.error("map-gaussian", "gaussian",
                        counted(dimensions, "channel") +
                            " without an inverse table; expected those of the map, " +
                            std::to_string(map.channels.size()));
  if (tiling.mipLoss.size() != fullChain && !tiling.mipLoss.empty())
    reader.error("map-mip-loss", "mipLoss",
                 counted(tiling.mipLoss.size(), "value") + "; expected one per mip level, " +
                     std::to_string(fullChain));
}

void checkInverseTable(ObjectReader& reader, const NoiseMap& map, const TilingMap& tiling,
                       const Table& table, const Table* gaussian) {
  if (table.mipLevels != 1)
    return reader.error("map-inverse-table", "inverseTable",
                        std::to_string(table.mipLevels) + " mip levels; expected 1");
  const bool isSlope = map.encoding == ValueEncoding::slope;
  const std::size_t needed = map.channels.size() + (isSlope ? 1 : 0); // the slopes' variance
  if (usedChannels(table.format) < needed)
    return reader.error("map-inverse-table", "inverseTable",
                        counted(std::uint64_t(channelCount(table.format)), "channel") +
                            "; expected at least " + std::to_string(needed));
  const bool isUnorm = texelBytes(table.format) == std::size_t(channelCount(table.format));
  const bool isColor = map.encoding == ValueEncoding::srgb || map.encoding == ValueEncoding::linear;
  if (isUnorm && !isColor)
    return reader.error("map-inverse-table", "inverseTable",
                        "8-bit texels for the encoding " + std::string(nameOf(map.encoding)) +
                            "; expected a float format");
  if (gaussian == nullptr || tiling.levels.empty())
    return;
  const auto slabs = std::uint32_t(tiling.levels.size());
  struct Shape {
    std::uint32_t width, height, depth;
  };
  const std::array<Shape, 3> shapes = {
      {{256, slabs, 0}, {64, 64 * slabs, 0}, {32, 32, 32 * slabs}}};
  const Shape& shape = shapes[usedChannels(gaussian->format) - 1];
  if (table.width != shape.width || table.height != shape.height || table.depth != shape.depth)
    reader.error("map-inverse-table", "inverseTable",
                 shapeOf(table) + " texels; expected " + std::to_string(shape.width) + " x " +
                     std::to_string(shape.height) +
                     (shape.depth > 0 ? " x " + std::to_string(shape.depth) : "") +
                     " for its Gaussian image and levels");
}

/// levels[k] = 1 - (1 - k / (L - 1))^2.
void readLevels(ObjectReader& reader, TilingMap& tiling) {
  auto levels = reader.numbers("levels", {0.0, 1.0});
  if (!levels)
    return;
  const std::size_t count = levels->size();
  if (count < 2 || count > kMaxTableLevels)
    return reader.error("map-levels", "levels",
                        counted(count, "value") + "; expected 2 to " +
                            std::to_string(kMaxTableLevels));
  for (std::size_t k = 0; k < count; ++k) {
    const double kept = 1.0 - double(k) / double(count - 1);
    if (std::abs((*levels)[k] - (1.0 - kept * kept)) > kLevelTolerance)
      return reader.error("map-levels", "levels",
                          json((*levels)[k]).dump() + " at " + std::to_string(k) + "; expected " +
                              json(1.0 - kept * kept).dump());
  }
  tiling.levels = std::move(*levels);
}

} // namespace

MethodMap TilingFormat::readMap(ObjectReader& reader, const Noise&, const NoiseMap& map,
                                const Tables& tables, FindingList&) const {
  TilingMap tiling;
  tiling.mipLoss = readLosses(reader, 1);
  const Table* gaussian =
      readTableIndex(reader, "gaussian", "map-gaussian-index", tables, tiling.gaussian);
  if (reader.has("inverseTable")) {
    std::size_t index = 0;
    readLevels(reader, tiling);
    const Table* table =
        readTableIndex(reader, "inverseTable", "map-inverse-table-index", tables, index);
    tiling.inverseTable = index;
    if (table != nullptr)
      checkInverseTable(reader, map, tiling, *table, gaussian);
  } else if (reader.optional("levels") != nullptr) {
    reader.error("map-levels", "levels", "present although there is no inverseTable");
  } else if (const std::size_t n = map.channels.size();
             n != 0 && map.covariance.size() == n * n &&
             !hasEigenvaluesFrom(map.covariance, n, kCovarianceTolerance)) {
    reader.error("map-covariance", "covariance",
                 "not positive definite, as it must be without an inverseTable");
  }
  if (gaussian != nullptr)
    checkGaussian(reader, map, tiling, *gaussian);
  return tiling;
}

} // namespace lichen
