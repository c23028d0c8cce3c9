// SPDX-License-Identifier: MIT
// Maps as pictures: code values in [0, 1] that can be looked at and measured alike.
//
// Colours are shown in sRGB, slopes as the normal map of glTF, data as it is: one channel grey, two
// red and green. Light above 1 is shown by log2(1 + light), divided by the exemplar's largest.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image.h>

#include <string>
#include <vector>

namespace lichen {

/// How an exemplar, and a noise made from it, become pictures of 1 or 3 channels. Copies, the
/// constructor and picture() throw std::bad_alloc, as building blocks do.
class MapLook {
public:
  /// The exemplar is within its documented ranges. `encoding`, which may be another than its own,
  /// is what the pictures show.
  MapLook(const MapExemplar& exemplar, ValueEncoding encoding);

  /// Of an exemplar with the same target and channels.
  [[nodiscard]] SrgbImage picture(const MapExemplar& exemplar) const;
  /// Of decoded values, as synthesize() gives them.
  [[nodiscard]] SrgbImage picture(LinearImage decoded) const;

  /// Of the pictures' channels in order: "red", "roughness", "normal x".
  [[nodiscard]] const std::vector<std::string>& channelNames() const { return channelNames_; }
  /// The encoded value that pictures show as 1.
  [[nodiscard]] double largest() const { return double(largest_); }

private:
  NoiseMap map_; ///< target, channels and encoding of the map
  float largest_ = 1.0f;
  std::vector<std::string> channelNames_;
};

} // namespace lichen
