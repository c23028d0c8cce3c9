// SPDX-License-Identifier: MIT
// Image file (1 to 4 channels) -> base colour exemplar (3 channels).
#include "exemplar.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace lichen::cli {
namespace {

/// What README.md recommends.
constexpr int kFewPixels = 64;
constexpr int kGoodPixels = 256;
constexpr int kPlentyOfPixels = 1024;

template <Encoding kEncoding>
std::vector<float> redGreenBlue(const Image<kEncoding>& image, std::vector<std::string>& notes) {
  const int colours = image.channels <= 2 ? 1 : 3;
  std::vector<float> values;
  values.reserve(image.pixelCount() * 3);
  bool opaque = true;
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    const float* pixel = &image.values[i * std::size_t(image.channels)];
    for (int c = 0; c < 3; ++c)
      values.push_back(pixel[colours == 1 ? 0 : c]);
    opaque = opaque && (image.channels == colours || pixel[colours] >= 1.0f);
  }
  if (!opaque)
    notes.push_back("the image has an alpha channel that is not all opaque; it is ignored");
  return values;
}

/// Sets light beyond what tables hold to the most that they do.
void clampLight(MapExemplar& map, std::vector<std::string>& notes) {
  float most = kHalfMax;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < map.values.size(); i += map.channels.size()) {
    bool beyond = false;
    for (std::size_t c = 0; c < map.channels.size(); ++c) {
      float& light = map.values[i + c];
      most = std::max(most, light);
      beyond = beyond || light > kHalfMax;
      light = std::min(light, kHalfMax);
    }
    pixels += beyond ? 1 : 0;
  }
  if (pixels > 0)
    notes.push_back(fmt::format("{} of {} pixels have light above {}, up to {:g}; it is baked as "
                                "{}",
                                pixels, map.values.size() / map.channels.size(), kHalfMax, most,
                                kHalfMax));
}

/// Whether no channel varies by more than a rounding.
bool isOneColour(const MapExemplar& map) {
  const std::size_t channels = map.channels.size();
  for (std::size_t c = 0; c < channels; ++c) {
    float least = map.values[c], most = map.values[c];
    for (std::size_t i = c; i < map.values.size(); i += channels) {
      least = std::min(least, map.values[i]);
      most = std::max(most, map.values[i]);
    }
    if (most - least > float(map.quantum))
      return false;
  }
  return true;
}

void noteContent(const MapExemplar& map, std::vector<std::string>& notes) {
  const auto noteSize = [&](const char* remark) {
    notes.push_back(fmt::format("{} x {} pixels {}; {} to {} a side are best", map.width,
                                map.height, remark, kGoodPixels, kPlentyOfPixels));
  };
  if (isOneColour(map))
    notes.push_back("the image has only one colour, and so will the noise");
  else if (std::min(map.width, map.height) < kFewPixels)
    noteSize("show little of a material");
  if (std::max(map.width, map.height) > kPlentyOfPixels)
    noteSize("take long to bake and much memory to use");
}

} // namespace

MapExemplar baseColorExemplar(const ImageFile& file, std::vector<std::string>& notes) {
  MapExemplar map;
  map.target = MapTarget::baseColor;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  notes.insert(notes.end(), file.notes.begin(), file.notes.end());
  std::visit(
      [&](const auto& image) {
        map.width = image.width;
        map.height = image.height;
        map.values = redGreenBlue(image, notes);
      },
      file.pixels);
  // A half float has 11 significant bits.
  const int bits = file.bitsPerChannel == 32 ? 11 : file.bitsPerChannel;
  map.quantum = 1.0 / double((1 << bits) - 1);
  if (std::holds_alternative<LinearImage>(file.pixels)) {
    clampLight(map, notes);
    const bool highRange = *std::max_element(map.values.begin(), map.values.end()) > 1.0f;
    map.encoding = highRange ? ValueEncoding::log2 : ValueEncoding::srgb;
    if (highRange)
      notes.push_back("the image has values above 1; it is baked as log2(1 + light)");
    for (float& value : map.values)
      value = highRange ? std::log2(1.0f + value) : linearToSrgb(value);
  }
  noteContent(map, notes);
  return map;
}

} // namespace lichen::cli
