// SPDX-License-Identifier: MIT
// Reads the tiling members of a noise and of a map, and checks the map's members against one
// another and against the Gaussian image.
#include "methods/inverse_table_reader.h"
#include "methods/method_reader.h"
#include "methods/noise_members.h"

#include <lichen/counted.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace lichen {
namespace {

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
  const auto level = std::span(image.texels).subspan(range.offset, range.size);
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

MethodNoise readNoise(ObjectReader& reader, FindingList&) { return TilingNoise{readGrain(reader)}; }

MethodMap readMap(ObjectReader& reader, const Noise&, const NoiseMap& map, const Tables& tables,
                  FindingList&) {
  TilingMap tiling;
  const InverseTableMembers inverse = readInverseTable(reader, map, tables);
  tiling.dimensions = inverse.dimensions;
  tiling.inverseTable = inverse.table;
  const Table* gaussian =
      readTableIndex(reader, "gaussian", "map-gaussian-index", tables, tiling.gaussian);
  if (gaussian != nullptr)
    checkGaussian(reader, tiling, *gaussian);
  return tiling;
}

constexpr std::array<std::string_view, 2> kTableMembers{"gaussian", "inverseTable"};

} // namespace

extern const MethodReader kTilingReader{.name = "tiling",
                                        .revision = 1,
                                        .tableMembers = kTableMembers,
                                        .readNoise = readNoise,
                                        .readMap = readMap};

} // namespace lichen
