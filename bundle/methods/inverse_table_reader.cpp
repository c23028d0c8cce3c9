// SPDX-License-Identifier: MIT
// Reads the members of a map's inverse table and checks them against one another and against the
// table. D is the number of dimensions of the exemplar's values, n the number of the map's
// channels.
#include "inverse_table_reader.h"

#include <lichen/counted.h>
#include <lichen/inverse_table.h>

#include <algorithm>
#include <bit>

namespace lichen {
namespace {

void checkChannels(ObjectReader& reader, const NoiseMap& map, const InverseTableMembers& members) {
  const auto n = int(map.channels.size());
  if (n == 0)
    return;
  if (members.dimensions > n)
    reader.error("map-dimensions", "dimensions",
                 std::to_string(members.dimensions) + "; expected at most the " +
                     counted(std::uint64_t(n), "channel") + " of the map");
  else if (!members.table && members.dimensions != n)
    reader.error("map-dimensions", "dimensions",
                 std::to_string(members.dimensions) + " without an inverseTable; expected the " +
                     counted(std::uint64_t(n), "channel") + " of the map");
}

void checkInverseTable(ObjectReader& reader, const NoiseMap& map, int dimensions,
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
  const bool isCube =
      table.height == (dimensions > 1 ? side : 1) && table.depth == (dimensions > 2 ? side : 1);
  if (!isCube || !std::has_single_bit(side) || side < kLeastTableSide || side > kMostTableSide)
    return reader.error("map-inverse-table", "inverseTable",
                        shapeOf(table) + " texels; expected a 3-D image with " +
                            std::to_string(dimensions) + " equal sides, a power of two from " +
                            std::to_string(kLeastTableSide) + " to " +
                            std::to_string(kMostTableSide) + ", and sides of 1");
  const std::uint32_t most = std::min(kMostTableLevels, std::uint32_t(std::bit_width(side)) - 1);
  if (table.mipLevels > most)
    reader.error("map-inverse-table", "inverseTable",
                 counted(table.mipLevels, "mip level") + "; expected at most " +
                     std::to_string(most) + " for a side of " + std::to_string(side));
}

} // namespace

InverseTableMembers readInverseTable(ObjectReader& reader, const NoiseMap& map,
                                     const Tables& tables) {
  constexpr std::uint64_t kMostDimensions = 3;
  InverseTableMembers members;
  members.dimensions = int(reader.integer("dimensions", kMostDimensions, "range", 1).value_or(1));
  if (reader.has("inverseTable")) {
    std::size_t index = 0;
    const Table* table =
        readTableIndex(reader, "inverseTable", "map-inverse-table-index", tables, index);
    members.table = index;
    if (table != nullptr)
      checkInverseTable(reader, map, members.dimensions, *table);
  } else if (const std::size_t n = map.channels.size();
             n != 0 && map.covariance.size() == n * n &&
             !hasEigenvaluesFrom(map.covariance, n, kCovarianceTolerance)) {
    reader.error("map-covariance", "covariance",
                 "not positive definite, as it must be without an inverseTable");
  }
  checkChannels(reader, map, members);
  return members;
}

} // namespace lichen
