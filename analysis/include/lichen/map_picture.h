// SPDX-License-Identifier: MIT
// Maps as pictures: code values in [0, 1] that people can look at and measures can compare.
//
// Colours are shown in sRGB, slopes as a glTF normal map. Data is shown unchanged: one channel as
// grey, two as red and green. Light above 1 is shown as log2(1 + light), divided by the exemplar's
// largest value.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image.h>

#include <string>
#include <vector>

namespace lichen {

/// Converts an exemplar, and a noise made from it, to pictures with 1 or 3 channels. Copies, the
/// constructor and picture() throw std::bad_alloc, as all building blocks do.
class MapLook {
public:
  /// The exemplar must lie within its documented ranges. The pictures show `encoding`, which may
  /// differ from the exemplar's.
  MapLook(const MapExemplar& exemplar, ValueEncoding encoding);

  /// Converts an exemplar with the same target and channels.
  [[nodiscard]] SrgbImage picture(const MapExemplar& exemplar) const;
  /// Converts decoded values, as synthesize() returns them.
  [[nodiscard]] SrgbImage picture(LinearImage decoded) const;

  /// Names of the pictures' channels, in order: "red", "roughness", "normal x".
  [[nodiscard]] const std::vector<std::string>& channelNames() const { return channelNames_; }
  /// The encoded value that the pictures show as 1.
  [[nodiscard]] double largest() const { return double(largest_); }

private:
  NoiseMap map_; ///< only target, channels and encoding of the map
  float largest_ = 1.0f;
  std::vector<std::string> channelNames_;
};

} // namespace lichen
