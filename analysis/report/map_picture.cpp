// SPDX-License-Identifier: MIT
// Stored or decoded values of a map -> a picture; see map_picture.h.
#include "exemplar/value_encoding.h"

#include <lichen/map_picture.h>
#include <lichen/synthesize.h>

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
    value = exemplar::decoded(value, exemplar.encoding);
  return image;
}

std::vector<std::string> channelNamesOf(const MapExemplar& exemplar) {
  if (exemplar.target == MapTarget::normal)
    return {"normal x", "normal y", "normal z"};
  std::vector<std::string> names;
  for (const MapChannel channel : exemplar.channels)
    names.emplace_back(nameOf(channel));
  return names;
}

} // namespace

MapLook::MapLook(const MapExemplar& exemplar, ValueEncoding encoding)
    : channelNames_(channelNamesOf(exemplar)) {
  map_.target = exemplar.target;
  map_.channels = exemplar.channels;
  map_.encoding = encoding;
  if (encoding == ValueEncoding::log2) {
    const float stored = *std::max_element(exemplar.values.begin(), exemplar.values.end());
    largest_ =
        std::max(1.0f, exemplar::encoded(exemplar::decoded(stored, exemplar.encoding), encoding));
  }
}

SrgbImage MapLook::picture(const MapExemplar& exemplar) const {
  return picture(decodedImage(exemplar));
}

SrgbImage MapLook::picture(LinearImage decoded) const {
  LinearImage texture = map_.target == MapTarget::normal ? coreTexture(map_, std::move(decoded))
                                                         : twoAsRedGreen(std::move(decoded));
  SrgbImage picture;
  picture.width = texture.width;
  picture.height = texture.height;
  picture.channels = texture.channels;
  picture.values = std::move(texture.values);
  const ValueEncoding shown =
      map_.encoding == ValueEncoding::root ? ValueEncoding::srgb : map_.encoding;
  if (shown == ValueEncoding::srgb || shown == ValueEncoding::log2)
    for (float& value : picture.values)
      value = exemplar::encoded(value, shown) / largest_;
  return picture;
}

} // namespace lichen
