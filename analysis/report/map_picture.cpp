// SPDX-License-Identifier: MIT
// Stored or decoded values of a map -> a picture; see map_picture.h.
#include "tiling/value_encoding.h"

#include <lichen/core_texture.h>
#include <lichen/map_picture.h>

#include <algorithm>

namespace lichen {
namespace {

LinearImage decodedImage(const MapExemplar& exemplar) {
  LinearImage image;
  image.width = exemplar.width;
  image.height = exemplar.height;
  image.channels = int(exemplar.channels.size());
  image.values = exemplar.values;
  for (float& value : image.values)
    value = tiling::decoded(value, exemplar.encoding);
  return image;
}

/// Of the pictures' channels that show one of the map's.
std::vector<MapLook::Channel> channelsOf(const MapExemplar& exemplar) {
  if (exemplar.target == MapTarget::normal)
    return {{0, "normal x"}, {1, "normal y"}, {2, "normal z"}};
  std::vector<MapLook::Channel> channels;
  const bool isPacked = exemplar.target == MapTarget::occlusionRoughnessMetallic;
  for (const MapChannel channel : exemplar.channels) {
    const int index = isPacked ? int(channel) - int(MapChannel::occlusion) : int(channels.size());
    channels.push_back({index, std::string(nameOf(channel))});
  }
  return channels;
}

} // namespace

MapLook::MapLook(const MapExemplar& exemplar, ValueEncoding encoding)
    : channels_(channelsOf(exemplar)) {
  map_.target = exemplar.target;
  map_.channels = exemplar.channels;
  map_.encoding = encoding;
  if (encoding == ValueEncoding::log2) {
    const float stored = *std::max_element(exemplar.values.begin(), exemplar.values.end());
    largest_ =
        std::max(1.0f, tiling::encoded(tiling::decoded(stored, exemplar.encoding), encoding));
  }
}

SrgbImage MapLook::picture(const MapExemplar& exemplar) const {
  return picture(decodedImage(exemplar));
}

SrgbImage MapLook::picture(LinearImage decoded) const {
  LinearImage texture = coreTexture(map_, std::move(decoded));
  SrgbImage picture;
  picture.width = texture.width;
  picture.height = texture.height;
  picture.channels = texture.channels;
  picture.values = std::move(texture.values);
  if (map_.encoding == ValueEncoding::srgb || map_.encoding == ValueEncoding::log2)
    for (float& value : picture.values)
      value = tiling::encoded(value, map_.encoding) / largest_;
  return picture;
}

} // namespace lichen
