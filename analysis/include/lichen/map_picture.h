// SPDX-License-Identifier: MIT
// Maps as pictures: code values in [0, 1] that can be looked at and measured alike.
//
// A picture is what a glTF core texture holds of the map: colours in sRGB, slopes as a normal map,
// data as it is. Light above 1 is shown by log2(1 + light), divided by the exemplar's largest.
#pragma once

#include <lichen/image.h>
#include <lichen/tiling.h>

#include <string>
#include <vector>

namespace lichen {

/// How an exemplar, and a noise made from it, become pictures of 1 or 3 channels.
class MapLook {
public:
  /// A channel of the pictures that shows one of the map.
  struct Channel {
    int index = 0;
    std::string name; ///< "red", "roughness", "normal x"
  };

  /// The exemplar is within its documented ranges. `encoding`, which may be another than its own,
  /// is what the pictures show.
  MapLook(const MapExemplar& exemplar, ValueEncoding encoding);

  /// Of an exemplar with the same target and channels.
  [[nodiscard]] SrgbImage picture(const MapExemplar& exemplar) const;
  /// Of decoded values, as synthesize() gives them.
  [[nodiscard]] SrgbImage picture(LinearImage decoded) const;

  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }
  /// The encoded value that pictures show as 1.
  [[nodiscard]] double largest() const { return double(largest_); }

private:
  NoiseMap map_; ///< target, channels and encoding of the map
  float largest_ = 1.0f;
  std::vector<Channel> channels_;
};

} // namespace lichen
