// SPDX-License-Identifier: MIT
// Reads the tiling members of a map and checks them against one another and against the tables. D
// is the number of dimensions of the exemplar's values, n that of the map's channels.
#include "tiling_format.h"

#include <lichen/counted.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace lichen {
namespace {

void checkChannels(ObjectReader& reader, const NoiseMap& map, const TilingMap& tiling) {
  const auto n = int(map.channels.size());
  if (n == 0)
    return;
  if (tiling.dimensions > n)
    reader.error("map-dimensions", "dimensions",
                 std::to_string(tiling.dimensions) + "; expected at most the " +
                     counted(std::uint64_t(n), "channel") + " of the map");
  else if (!tiling.inverseTable && tiling.dimensions != n)
    reader.error("map-dimensions", "dimensions",
                 std::to_string(tiling.dimensions) + " without an inverseTable; expected the " +
                     counted(std::uint64_t(n), "channel") + " of the map");
}

/// Whether all texels of a mip level have the same last channel, of `Bytes`, bit for bit.
template <std::size_t Bytes>
bool hasOneLoss(std::span<const std::byte> level, std::size_t texel) {
  bool same = true; // without an early end, compilers vectorize it
  for (std::size_t end = texel; end <= level.size(); end += texel)
    same &= std::memcmp(&level[end - Bytes], &level[texel - Bytes], Bytes) == 0;
  return same;
}

bool hasOneLoss(const Table& image, std::uint32_t mip) {
  const LevelRange range = levelRange(image, mip);
  const std::span<const std::byte> level = image.bytes().subspan(range.offset, range.size);
  const std::size_t texel = texelBytes(image.format);
  switch (texel / std::size_t(channelCount(image.format))) {
  case 1:
    return hasOneLoss<1>(level, texel);
  case 2:
    return hasOneLoss<2>(level, texel);
  default:
    return hasOneLoss<4>(level, texel);
  }
}

/// Checks the last channel: one loss per mip level, in [0, 1], never decreasing.
void checkLosses(ObjectReader& reader, const Table& image) {
  const std::vector<float> losses = fetchLosses(image);
  float least = 0.0f;
  for (std::uint32_t mip = 0; mip < image.mipLevels; ++mip) {
    const float loss = losses[mip];
    const std::string which = "mip level " + std::to_string(mip) + " of the image ";
    if (!hasOneLoss(image, mip))
      return reader.error("map-loss", "gaussian",
                          which + "has different values in its last channel; expected the same "
                                  "loss in all its texels");
    if (!(loss >= least && loss <= 1.0f))
      return reader.error("map-loss", "gaussian",
                          which + "has the loss " + nlohmann::json(loss).dump() +
                              " in its last channel; expected " + nlohmann::json(least).dump() +
                              " to 1");
    least = loss;
  }
}

void checkGaussian(ObjectReader& reader, const TilingMap& tiling, const Table& image) {
  const auto fullChain = std::uint32_t(std::bit_width(std::max(image.width, image.height)));
  if (image.depth != 0)
    return reader.error("map-gaussian", "gaussian", shapeOf(image) + "; expected a 2-D image");
  if (image.mipLevels != fullChain)
    return reader.error("map-gaussian", "gaussian",
                        counted(image.mipLevels, "mip level") + "; expected the full chain of " +
                            std::to_string(fullChain));
  const int expected = tiling.dimensions == 1 ? 2 : 4;
  if (channelCount(image.format) != expected)
    return reader.error("map-gaussian", "gaussian",
                        counted(std::uint64_t(channelCount(image.format)), "channel") +
                            "; expected " + std::to_string(expected) + " for " +
                            counted(std::uint64_t(tiling.dimensions), "dimension") +
                            " and the loss");
  checkLosses(reader, image);
}

void checkInverseTable(ObjectReader& reader, const NoiseMap& map, const TilingMap& tiling,
                       const Table& table) {
  const bool isSlope = map.encoding == ValueEncoding::slope;
  const std::size_t needed = map.channels.size() + (isSlope ? 1 : 0); // the slopes' variance
  if (usedChannels(table.format) < needed)
    return reader.error("map-inverse-table", "inverseTable",
                        counted(std::uint64_t(channelCount(table.format)), "channel") +
                            "; expected at least " + std::to_string(needed));
  const bool isUnorm = texelBytes(table.format) == std::size_t(channelCount(table.format));
  const bool isInUnit =
      map.encoding == ValueEncoding::root || map.encoding == ValueEncoding::linear;
  if (isUnorm && !isInUnit)
    return reader.error("map-inverse-table", "inverseTable",
                        "8-bit texels for the encoding " + std::string(nameOf(map.encoding)) +
                            "; expected a float format");
  const std::uint32_t side = table.width;
  const bool isCube = table.height == (tiling.dimensions > 1 ? side : 1) &&
                      table.depth == (tiling.dimensions > 2 ? side : 1);
  if (!isCube || !std::has_single_bit(side) || side < kLeastTableSide || side > kMostTableSide)
    return reader.error("map-inverse-table", "inverseTable",
                        shapeOf(table) + " texels; expected a 3-D image with " +
                            std::to_string(tiling.dimensions) +
                            " equal sides, a power of two from " + std::to_string(kLeastTableSide) +
                            " to " + std::to_string(kMostTableSide) + ", and sides of 1");
  const std::uint32_t most = std::min(kMostTableLevels, std::uint32_t(std::bit_width(side)) - 1);
  if (table.mipLevels > most)
    reader.error("map-inverse-table", "inverseTable",
                 counted(table.mipLevels, "mip level") + "; expected at most " +
                     std::to_string(most) + " for a side of " + std::to_string(side));
}

} // namespace

MethodMap TilingFormat::readMap(ObjectReader& reader, const Noise&, const NoiseMap& map,
                                const Tables& tables, FindingList&) const {
  constexpr std::uint64_t kMostDimensions = 3;
  TilingMap tiling;
  tiling.dimensions = int(reader.integer("dimensions", kMostDimensions, "range", 1).value_or(1));
  const Table* gaussian =
      readTableIndex(reader, "gaussian", "map-gaussian-index", tables, tiling.gaussian);
  if (reader.has("inverseTable")) {
    std::size_t index = 0;
    const Table* table =
        readTableIndex(reader, "inverseTable", "map-inverse-table-index", tables, index);
    tiling.inverseTable = index;
    if (table != nullptr)
      checkInverseTable(reader, map, tiling, *table);
  } else if (const std::size_t n = map.channels.size();
             n != 0 && map.covariance.size() == n * n &&
             !hasEigenvaluesFrom(map.covariance, n, kCovarianceTolerance)) {
    reader.error("map-covariance", "covariance",
                 "not positive definite, as it must be without an inverseTable");
  }
  checkChannels(reader, map, tiling);
  if (gaussian != nullptr)
    checkGaussian(reader, tiling, *gaussian);
  return tiling;
}

} // namespace lichen
