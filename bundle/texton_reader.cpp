// SPDX-License-Identifier: MIT
// What a texton noise has of its own: the shape that its textons share, and each map's texton.
#include "extension_reader.h"

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxTileSide = 16384;
/// Frames of the largest texton then are below 2,048 texels, whatever the padding.
constexpr std::uint64_t kMaxMipLevels = 9;

/// Two integers in [1, most], x and y; ones that can be used where there are none.
std::array<int, 2> readPair(ObjectReader& reader, const char* key, std::uint64_t most) {
  constexpr std::array<int, 2> kUsable{1, 1};
  const auto values = reader.numbers(key, {1.0, double(most)});
  if (!values)
    return kUsable;
  if (values->size() != 2) {
    reader.error("count", key, std::to_string(values->size()) + " values; 2 are accepted");
    return kUsable;
  }
  for (const double value : *values)
    if (value != double(int(value))) {
      reader.error("type", key, json(value).dump() + "; an integer is accepted");
      return kUsable;
    }
  return {int((*values)[0]), int((*values)[1])};
}

/// An integer in [1, most], or 1.
int readCount(ObjectReader& reader, const char* key, std::uint64_t most) {
  const auto value = reader.integer(key, most);
  if (value && *value == 0)
    reader.error("range", key, "0; 1 to " + std::to_string(most) + " is accepted");
  return int(std::max<std::uint64_t>(1, value.value_or(1)));
}

void checkImage(ObjectReader& reader, const TextonShape& shape, const NoiseMap& map,
                const Table& image) {
  const auto error = [&](const std::string& message) {
    reader.error("map-texton", "texton", message);
  };
  const std::uint32_t width = shape.frameWidth();
  const std::uint32_t height = shape.frameHeight() * std::uint32_t(shape.steps);
  const std::size_t texel = texelBytes(image.format);
  if (image.depth != 0 || image.width != width || image.height != height)
    return error(shapeOf(image) + " texels; " + std::to_string(width) + " x " +
                 std::to_string(height) + " are accepted for its noise's texton");
  if (image.mipLevels != std::uint32_t(shape.mipLevels))
    return error(std::to_string(image.mipLevels) + " mip levels; the noise's " +
                 std::to_string(shape.mipLevels) + " are accepted");
  if (texel == std::size_t(channelCount(image.format)))
    return error("8-bit texels; a float format is accepted");
  if (!map.channels.empty() && usedChannels(image.format) < map.channels.size())
    return error(std::to_string(usedChannels(image.format)) + " channels; those of the map, " +
                 std::to_string(map.channels.size()) + ", are accepted");
}

} // namespace

TextonShape readTextonShape(ObjectReader& noise, FindingList& findings) {
  TextonShape shape;
  const json* member = noise.required("texton");
  if (member == nullptr)
    return shape;
  ObjectReader reader(*member, noise.pointerTo("texton"), findings);
  const std::array<int, 2> coefficients =
      readPair(reader, "coefficients", std::uint64_t(kMaxTextonSide));
  shape.coefficientsX = coefficients[0];
  shape.coefficientsY = coefficients[1];
  const std::uint64_t order = reader.integer("order", 3).value_or(1);
  if (order == 2)
    reader.error("range", "order", "2; 0, 1 or 3 is accepted");
  shape.order = int(order);
  shape.mipLevels = readCount(reader, "mipLevels", kMaxMipLevels);
  const std::array<int, 2> tile = readPair(reader, "texelsPerTile", kMaxTileSide);
  shape.texelsPerTileX = tile[0];
  shape.texelsPerTileY = tile[1];
  if (reader.has("steps"))
    shape.steps = readCount(reader, "steps", std::uint64_t(kMaxTextonSteps));
  reader.warnOfUnknown();
  return shape;
}

void readTexton(ObjectReader& reader, const TextonShape& shape, const Tables& tables,
                NoiseMap& map) {
  const std::size_t n = map.channels.size();
  constexpr NumberRange kScales{0.0, 1e6};
  if (auto scale = reader.numbers("scale", kScales)) {
    if (n != 0 && scale->size() != n)
      reader.error("map-scale", "scale",
                   std::to_string(scale->size()) + " values; " + std::to_string(n) +
                       ", one a channel, are accepted");
    map.scale = std::move(*scale);
  }
  if (reader.has("endMean") != (shape.steps > 1))
    reader.error("map-end-mean", "endMean",
                 shape.steps > 1 ? "absent; the last step's mean is accepted"
                                 : "present; it is accepted with steps above 1 only");
  if (reader.has("endMean")) {
    if (auto mean = reader.numbers("endMean", meanRange(map.encoding))) {
      if (n != 0 && mean->size() != n)
        reader.error("map-end-mean", "endMean",
                     std::to_string(mean->size()) + " values; " + std::to_string(n) +
                         ", one a channel, are accepted");
      map.endMean = std::move(*mean);
    }
  }
  const std::size_t losses = map.mipLoss.size();
  if (losses < std::size_t(shape.mipLevels) || losses > kMaxTextonLosses)
    reader.error("map-mip-loss", "mipLoss",
                 std::to_string(losses) + " values; " + std::to_string(shape.mipLevels) + " to " +
                     std::to_string(kMaxTextonLosses) + " are accepted");
  const Table* image = readTableIndex(reader, "texton", "map-texton-index", tables, map.image);
  if (image != nullptr)
    checkImage(reader, shape, map, *image);
}

} // namespace lichen
