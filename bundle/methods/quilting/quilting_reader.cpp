// SPDX-License-Identifier: MIT
// Reads the members of a quilting noise and of a map, and checks its images.
#include "methods/method_reader.h"
#include "methods/noise_members.h"

#include <lichen/counted.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace lichen {
namespace {

using nlohmann::json;

/// Records a fault of an image that is not 2-D with the full chain of mip levels. Returns whether
/// there is none.
bool checkShape(ObjectReader& reader, const char* key, const Table& image) {
  const auto fullChain = std::uint32_t(std::bit_width(std::max(image.width, image.height)));
  if (image.depth != 0)
    reader.error("map-quilting", key, shapeOf(image) + "; expected a 2-D image");
  else if (image.mipLevels != fullChain)
    reader.error("map-quilting", key,
                 counted(image.mipLevels, "mip level") + "; expected the full chain of " +
                     std::to_string(fullChain));
  else
    return true;
  return false;
}

/// Checks the magnitudes, beyond which decoded values could be infinite. Values of 8 bits cannot.
void checkTexels(ObjectReader& reader, const NoiseMap& map, const Table& image) {
  const float most = map.encoding == ValueEncoding::log2 ? kMostQuiltingLog2 : kMostQuiltingTexel;
  for (std::uint32_t level = 0; level < image.mipLevels; ++level)
    for (const float texel : decodeLevel(image, level))
      if (!(std::abs(texel) <= most))
        return reader.error("map-quilting-texels", "image",
                            "a number of " + json(double(texel)).dump() + "; expected -" +
                                json(most).dump() + " to " + json(most).dump());
}

void checkImage(ObjectReader& reader, const NoiseMap& map, const Table& image) {
  const std::size_t n = map.channels.size();
  if (!checkShape(reader, "image", image) || n == 0)
    return;
  const bool isSlope = map.encoding == ValueEncoding::slope;
  const int expected = isSlope || n == 3 ? 4 : int(n);
  if (channelCount(image.format) != expected)
    reader.error("map-quilting", "image",
                 counted(std::uint64_t(channelCount(image.format)), "channel") + "; expected " +
                     std::to_string(expected) + " for " + counted(std::uint64_t(n), "channel") +
                     (isSlope ? " of slopes and the mean of their squares" : ""));
  const bool isUnorm = texelBytes(image.format) == std::size_t(channelCount(image.format));
  if (isUnorm && map.encoding != ValueEncoding::root && map.encoding != ValueEncoding::linear)
    reader.error("map-quilting", "image",
                 "8-bit texels for the encoding " + std::string(nameOf(map.encoding)) +
                     "; expected a float format");
  if (!isUnorm)
    checkTexels(reader, map, image);
}

void checkCells(ObjectReader& reader, const Table& cells) {
  if (!checkShape(reader, "cells", cells))
    return;
  constexpr std::size_t kChannels = 4, kBlue = 2;
  if (std::size_t(channelCount(cells.format)) != kChannels)
    return reader.error("map-quilting", "cells", "texels of another format; expected RGBA");
  for (std::uint32_t level = 0; level < cells.mipLevels; ++level) {
    const std::vector<float> texels = decodeLevel(cells, level);
    if (!std::ranges::all_of(texels, [](float value) { return value >= 0.0f && value <= 1.0f; }))
      return reader.error("map-quilting-texels", "cells",
                          "a number outside the range of cells; expected 0 to 1");
    for (std::size_t i = kBlue; i < texels.size(); i += kChannels)
      if (texels[i] != texels[kBlue])
        return reader.error("map-quilting-sharpness", "cells",
                            "mip level " + std::to_string(level) +
                                " has more than one sharpness; expected one blue in a level");
  }
}

std::vector<std::array<double, 2>> readOffsets(ObjectReader& reader, FindingList& findings) {
  std::vector<std::array<double, 2>> offsets;
  const json* list = reader.array("offsets", kMostQuiltingOffsets);
  if (list == nullptr)
    return offsets;
  const auto isShare = [](const json& value) {
    return value.is_number() && value.get<double>() >= 0.0 && value.get<double>() < 1.0;
  };
  for (std::size_t i = 0; i < list->size(); ++i) {
    const json& pair = (*list)[i];
    if (!pair.is_array() || pair.size() != 2 || !isShare(pair[0]) || !isShare(pair[1]))
      findings.error("range", reader.pointerTo("offsets") + "/" + std::to_string(i),
                     "expected two numbers from 0 to below 1");
    else
      offsets.push_back({pair[0].get<double>(), pair[1].get<double>()});
  }
  if (list->size() < kFewestQuiltingOffsets)
    reader.error("count", "offsets",
                 counted(list->size(), "offset") + "; expected " +
                     std::to_string(kFewestQuiltingOffsets) + " to " +
                     std::to_string(kMostQuiltingOffsets) + ", or no member");
  return offsets;
}

MethodNoise readNoise(ObjectReader& reader, FindingList& findings) {
  constexpr double kLeastReach = 1e-4;
  QuiltingNoise shared;
  shared.grain = readGrain(reader);
  shared.reach = reader.number("reach", {kLeastReach, kMostCellReach}).value_or(kMostCellReach);
  shared.correlation = reader.numberOr("correlation", {0.0, 1.0}, 0.0);
  if (reader.has("offsets"))
    shared.offsets = readOffsets(reader, findings);
  return shared;
}

MethodMap readMap(ObjectReader& reader, const Noise& noise, const NoiseMap& map,
                  const Tables& tables, FindingList&) {
  QuiltingMap own;
  if (const Table* image = readTableIndex(reader, "image", "map-quilting-index", tables, own.image))
    checkImage(reader, map, *image);
  if (const Table* cells = readTableIndex(reader, "cells", "map-quilting-index", tables, own.cells))
    checkCells(reader, *cells);
  if (!noise.maps.empty() && noise.maps.front().as<QuiltingMap>().cells != own.cells)
    reader.error("map-quilting", "cells", "differs from the first map's; expected the same");
  return own;
}

constexpr std::array<std::string_view, 2> kTableMembers{"image", "cells"};

} // namespace

extern const MethodReader kQuiltingReader{.name = "quilting",
                                          .revision = 1,
                                          .tableMembers = kTableMembers,
                                          .readNoise = readNoise,
                                          .readMap = readMap};

} // namespace lichen
