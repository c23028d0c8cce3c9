// SPDX-License-Identifier: MIT
// Values (width * height * channels of the map) -> pixels (width * height * 1 or 3). glTF 2.0,
// sections 3.9.2 and 3.9.3.
#include <lichen/image_io.h>
#include <lichen/synthesize.h>

#include <cmath>
#include <utility>

namespace lichen {
namespace {

LinearImage normals(const LinearImage& slopes) {
  LinearImage result(slopes.width, slopes.height, 3);
  for (std::size_t i = 0; i < slopes.pixelCount(); ++i) {
    const float x = -slopes.values[2 * i], y = -slopes.values[2 * i + 1];
    const float scale = 0.5f / std::sqrt(x * x + y * y + 1.0f);
    float* code = &result.values[3 * i];
    code[0] = 0.5f + scale * x;
    code[1] = 0.5f + scale * y;
    code[2] = 0.5f + scale;
  }
  return result;
}

LinearImage occlusionRoughnessMetallic(const NoiseMap& map, const LinearImage& values) {
  LinearImage result(values.width, values.height, 3);
  result.values.assign(result.values.size(), 1.0f);
  const auto channels = std::size_t(values.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const auto place = std::size_t(map.channels[c]) - std::size_t(MapChannel::occlusion);
    for (std::size_t i = 0; i < values.pixelCount(); ++i)
      result.values[3 * i + place] = values.values[channels * i + c];
  }
  return result;
}

} // namespace

LinearImage coreTexture(const NoiseMap& map, LinearImage values) {
  if (map.target == MapTarget::normal)
    return normals(values);
  if (map.target == MapTarget::occlusionRoughnessMetallic)
    return occlusionRoughnessMetallic(map, values);
  return values;
}

LinearImage withAlpha(const LinearImage& color, const LinearImage& opacity) {
  LinearImage result(opacity.width, opacity.height, 4);
  for (std::size_t i = 0; i < opacity.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      result.values[4 * i + c] = color.values.empty() ? 1.0f : color.values[3 * i + c];
    result.values[4 * i + 3] = opacity.values[i];
  }
  return result;
}

Result<std::vector<std::byte>> encodeCoreTexture(MapTarget target, LinearImage texture) {
  // 16 bits, because displacement makes steps of 1 / 255 visible.
  const int bits = target == MapTarget::height ? 16 : 8;
  const bool isLight = target == MapTarget::baseColor || target == MapTarget::emissive;
  return isLight ? encodePng(toSrgb(std::move(texture)), bits) : encodePng(texture, bits);
}

} // namespace lichen
