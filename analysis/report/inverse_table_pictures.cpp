// SPDX-License-Identifier: MIT
// Inverse table of a map -> a picture of each mip level.
#include "inverse_table_pictures.h"

#include <lichen/inverse_table.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// One level of an inverse table, its slices side by side, decoded.
LinearImage slicesPicture(const Table& table, std::uint32_t level, std::size_t channels,
                          ValueEncoding encoding) {
  const auto side = [level](std::uint32_t size) {
    return std::size_t(std::max(1u, size >> level));
  };
  const std::size_t width = side(table.width), height = side(table.height);
  const std::size_t slices = side(table.depth);
  std::vector<float> texels = decodeLevel(table, level);
  if (encoding == ValueEncoding::root)
    for (float& value : texels)
      value *= value;
  const auto stored = std::size_t(channelCount(table.format));
  LinearImage image(int(width * slices), int(height), int(channels));
  for (std::size_t z = 0; z < slices; ++z)
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x)
        std::copy_n(&texels[((z * height + y) * width + x) * stored], std::min(channels, stored),
                    image.pixel(int(z * width + x), int(y)));
  return image;
}

} // namespace

Result<Json> inverseTablePictures(const Bundle& bundle, const NoiseMap& map, const MapLook& look) {
  const std::optional<std::size_t> index = decodingTableOf(map);
  if (!index)
    return Json();
  const Table& table = bundle.tables[*index];
  Json levels = Json::array();
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    Result<Json> shown =
        pictureJson(look.picture(slicesPicture(table, level, map.channels.size(), map.encoding)));
    if (!shown)
      return shown;
    const double amplitude = 1.0 - double(level) / kMostTableLevels;
    levels.push_back({{"picture", std::move(shown).value()},
                      {"slices", std::max(1u, table.depth >> level)},
                      {"lost", 1.0 - amplitude * amplitude}});
  }
  return Json{{"levels", std::move(levels)}};
}

} // namespace lichen
