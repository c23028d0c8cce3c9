// SPDX-License-Identifier: MIT
// Pixels (width * height * 1 to 4 channels) -> values (width * height * channels of the map).
#include "map_values.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace lichen::exemplar {
namespace {

/// Limits the steepest slope to 20 (docs/gltf_extension/README.md).
constexpr float kLeastNormalZ = 0.05f;

/// Pixels in any encoding: codes of PNG and JPEG, values of EXR.
struct Pixels {
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::vector<float>& values;

  [[nodiscard]] int colors() const { return channels <= 2 ? 1 : 3; }
  [[nodiscard]] bool hasAlpha() const { return channels > colors(); }
  [[nodiscard]] std::size_t count() const { return values.size() / std::size_t(channels); }
  [[nodiscard]] const float* operator[](std::size_t i) const {
    return &values[i * std::size_t(channels)];
  }
};

Pixels pixelsOf(const ImageFile& file) {
  return std::visit(
      [](const auto& image) {
        return Pixels{image.width, image.height, image.channels, image.values};
      },
      file.pixels);
}

bool holdsLight(const ImageFile& file) { return std::holds_alternative<LinearImage>(file.pixels); }

/// Returns the step between stored values. A half float has 11 significant bits.
double codeStep(const ImageFile& file) {
  constexpr int kHalfBits = 11;
  const int bits = file.bitsPerChannel == 32 ? kHalfBits : file.bitsPerChannel;
  return 1.0 / double((1 << bits) - 1);
}

MapExemplar emptyMap(const NamedImage& image, MapTarget target, ValueEncoding encoding,
                     std::span<const MapChannel> channels) {
  const Pixels pixels = pixelsOf(image.file);
  MapExemplar map;
  map.target = target;
  map.channels.assign(channels.begin(), channels.end());
  map.encoding = encoding;
  map.width = pixels.width;
  map.height = pixels.height;
  map.quantum = codeStep(image.file);
  map.values.reserve(pixels.count() * channels.size());
  return map;
}

/// Clamps values to `most`. `what` names the quantity in the note.
void clampAbove(MapExemplar& map, float most, const std::string& name, const char* what,
                std::vector<std::string>& notes) {
  float largest = most;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < map.values.size(); i += map.channels.size()) {
    bool beyond = false;
    for (std::size_t c = 0; c < map.channels.size(); ++c) {
      float& value = map.values[i + c];
      largest = std::max(largest, value);
      beyond = beyond || value > most;
      value = std::min(value, most);
    }
    pixels += beyond ? 1u : 0u;
  }
  if (pixels > 0)
    notes.push_back(fmt::format("{} has {} above {} in {} of {} pixels, up to {:g}; clamped to "
                                "{}",
                                name, what, most, pixels, map.values.size() / map.channels.size(),
                                largest, most));
}

bool exceedsOne(const MapExemplar& map) {
  return *std::max_element(map.values.begin(), map.values.end()) > 1.0f;
}

void encodeLog2(MapExemplar& map) {
  map.encoding = ValueEncoding::log2;
  for (float& value : map.values)
    value = std::log2(1.0f + value);
}

/// Returns whether the channels are equal up to `step`. Rounding may separate grey stored as
/// colour.
bool isGrey(const Pixels& pixels, double step) {
  for (std::size_t i = 0; i < pixels.count(); ++i) {
    const auto [least, most] = std::minmax({pixels[i][0], pixels[i][1], pixels[i][2]});
    if (double(most - least) > step)
      return false;
  }
  return true;
}

/// Returns whether the image has an alpha below 1 anywhere.
bool isTransparent(const Pixels& pixels) {
  if (!pixels.hasAlpha())
    return false;
  for (std::size_t i = 0; i < pixels.count(); ++i)
    if (pixels[i][pixels.colors()] < 1.0f)
      return true;
  return false;
}

Error tooFewColors(const NamedImage& image, const char* what) {
  return {ErrorKind::badInput,
          fmt::format("{}: a grey image; expected {} in red, green and blue", image.path, what)};
}

} // namespace

bool hasColors(const NamedImage& image) {
  const Pixels pixels = pixelsOf(image.file);
  return pixels.colors() == 3 && !isGrey(pixels, codeStep(image.file));
}

MapExemplar colorMap(const NamedImage& image, MapTarget target, std::vector<std::string>& notes) {
  constexpr MapChannel kChannels[] = {MapChannel::red, MapChannel::green, MapChannel::blue};
  const Pixels pixels = pixelsOf(image.file);
  MapExemplar map = emptyMap(image, target, ValueEncoding::srgb, kChannels);
  for (std::size_t i = 0; i < pixels.count(); ++i)
    for (int c = 0; c < 3; ++c)
      map.values.push_back(pixels[i][pixels.colors() == 1 ? 0 : c]);
  if (!holdsLight(image.file))
    return map;
  clampAbove(map, kHalfMax, image.name, "light", notes);
  if (exceedsOne(map)) {
    notes.push_back(image.name + " has values above 1; it is baked as log2(1 + light)");
    encodeLog2(map);
  } else {
    for (float& value : map.values)
      value = linearToSrgb(value);
  }
  return map;
}

std::optional<MapExemplar> alphaMap(const NamedImage& image) {
  constexpr MapChannel kChannels[] = {MapChannel::opacity};
  const Pixels pixels = pixelsOf(image.file);
  if (!isTransparent(pixels))
    return std::nullopt;
  MapExemplar map = emptyMap(image, MapTarget::opacity, ValueEncoding::linear, kChannels);
  for (std::size_t i = 0; i < pixels.count(); ++i)
    map.values.push_back(std::min(1.0f, pixels[i][pixels.colors()]));
  return map;
}

Result<MapExemplar> dataMap(const NamedImage& image, MapTarget target,
                            std::span<const MapChannel> channels, std::span<const int> sources,
                            bool isPacked, std::vector<std::string>& notes) {
  const Pixels pixels = pixelsOf(image.file);
  if (*std::max_element(sources.begin(), sources.end()) >= pixels.colors())
    return tooFewColors(image, "occlusion, roughness and metallic");
  MapExemplar map = emptyMap(image, target, ValueEncoding::linear, channels);
  for (std::size_t i = 0; i < pixels.count(); ++i)
    for (const int source : sources)
      map.values.push_back(pixels[i][source]);
  if (!isPacked && hasColors(image))
    notes.push_back(image.name + " has colours; its red channel is used");
  if (target == MapTarget::height && exceedsOne(map)) {
    clampAbove(map, kHalfMax, image.name, "height", notes);
    notes.push_back(image.name + " has values above 1; it is baked as log2(1 + height)");
    encodeLog2(map);
  } else {
    clampAbove(map, 1.0f, image.name, "values", notes);
  }
  return map;
}

Result<MapExemplar> normalMap(const NamedImage& image, bool greenPointsDown,
                              std::vector<std::string>& notes) {
  constexpr MapChannel kChannels[] = {MapChannel::slopeX, MapChannel::slopeY};
  const Pixels pixels = pixelsOf(image.file);
  if (pixels.colors() != 3)
    return tooFewColors(image, "normals");
  MapExemplar map = emptyMap(image, MapTarget::normal, ValueEncoding::slope, kChannels);
  // A step of the code is two steps of a normal's component, and so of the slope where the surface
  // is flat, as most of it is. A 1-bit image has a step of 2, which exceeds the range of a quantum.
  map.quantum = std::min(1.0, 2.0 * map.quantum);
  std::size_t inward = 0;
  for (std::size_t i = 0; i < pixels.count(); ++i) {
    const auto component = [&](int c) { return 2.0f * std::min(1.0f, pixels[i][c]) - 1.0f; };
    const auto [right, down] = uprightDirection(
        {component(0), greenPointsDown ? component(1) : -component(1)}, image.file.turnedFrom);
    const float z = std::max(component(2), kLeastNormalZ);
    inward += component(2) < 0.0f ? 1u : 0u;
    map.values.insert(map.values.end(), {-right / z, down / z});
  }
  if (2 * inward > pixels.count())
    return Error{ErrorKind::badInput,
                 fmt::format("{}: {} of {} normals point into the surface, so this is not a "
                             "normal map; expected normals as colours, with blue above one half",
                             image.path, inward, pixels.count())};
  if (inward > 0)
    notes.push_back(fmt::format("{}: {} of {} normals point into the surface; they are baked as "
                                "the steepest slopes",
                                image.name, inward, pixels.count()));
  return map;
}

void noteIgnoredAlpha(const NamedImage& image, bool mayBeOpacity, std::vector<std::string>& notes) {
  if (isTransparent(pixelsOf(image.file)))
    notes.push_back(image.name + " has an alpha channel that is not all opaque; it is ignored" +
                    std::string(mayBeOpacity ? " unless alpha is read as opacity" : ""));
}

} // namespace lichen::exemplar
