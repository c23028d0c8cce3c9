// SPDX-License-Identifier: MIT
// Blender's add-on Node Wrangler finds its slots by the words of a name. Unreal and Godot pack
// occlusion, roughness and metallic as glTF does; Unity's mask map follows its HDRP.
#include <lichen/image_io.h>
#include <lichen/synthesize.h>
#include <lichen/texture_files.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace lichen {
namespace {

/// A texture before it is encoded.
struct Texture {
  std::string_view suffix;
  LinearImage pixels;
};

/// The direction in a program's own normal maps.
GreenAxis greenAxisOf(Importer importer) {
  return importer == Importer::unreal ? GreenAxis::down : GreenAxis::up;
}

/// Whether a program takes opacity from the base colour's alpha.
bool opacityIsAlpha(Importer importer) {
  return importer == Importer::godot || importer == Importer::unity;
}

LinearImage channelOf(const LinearImage& image, std::size_t channel) {
  LinearImage result(image.width, image.height, 1);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    result.values[i] = image.values[std::size_t(image.channels) * i + channel];
  return result;
}

bool has(const NoiseMap& map, MapChannel channel) {
  return std::ranges::count(map.channels, channel) > 0;
}

/// What is not metal by default: coreTexture() has 1, which a factor of the material scales.
void clearAbsentMetal(const NoiseMap& map, LinearImage& packed) {
  if (!has(map, MapChannel::metallic))
    for (std::size_t i = 0; i < packed.pixelCount(); ++i)
      packed.values[3 * i + 2] = 0.0f;
}

/// Unity's mask map: metallic, occlusion, 0, smoothness.
LinearImage maskMap(const LinearImage& packed) {
  LinearImage mask(packed.width, packed.height, 4);
  for (std::size_t i = 0; i < packed.pixelCount(); ++i) {
    const float* orm = &packed.values[3 * i];
    std::copy_n(std::array{orm[2], orm[0], 0.0f, 1.0f - orm[1]}.begin(), 4, &mask.values[4 * i]);
  }
  return mask;
}

std::vector<Texture> packedTextures(const NoiseMap& map, LinearImage packed, Importer importer) {
  clearAbsentMetal(map, packed);
  if (importer == Importer::unity)
    return {{"MaskMap", maskMap(packed)}};
  if (importer != Importer::blender)
    return {{"OcclusionRoughnessMetallic", std::move(packed)}};
  std::vector<Texture> textures;
  const std::array<std::pair<MapChannel, std::string_view>, 3> parts{
      {{MapChannel::occlusion, "AmbientOcclusion"},
       {MapChannel::roughness, "Roughness"},
       {MapChannel::metallic, "Metallic"}}};
  for (std::size_t c = 0; c < parts.size(); ++c)
    if (has(map, parts[c].first))
      textures.push_back({parts[c].second, channelOf(packed, c)});
  return textures;
}

std::vector<Texture> texturesBefore(const NoiseMap& map, LinearImage values,
                                    const TextureStyle& style) {
  LinearImage pixels = coreTexture(map, std::move(values));
  switch (map.target) {
  case MapTarget::baseColor:
    return {{"BaseColor", std::move(pixels)}};
  case MapTarget::normal:
    if (style.green.value_or(greenAxisOf(style.importer)) == GreenAxis::down)
      for (std::size_t i = 0; i < pixels.pixelCount(); ++i)
        pixels.values[3 * i + 1] = 1.0f - pixels.values[3 * i + 1];
    return {{"Normal", std::move(pixels)}};
  case MapTarget::occlusionRoughnessMetallic:
    return packedTextures(map, std::move(pixels), style.importer);
  case MapTarget::emissive:
    return {{"Emissive", std::move(pixels)}};
  case MapTarget::height:
    return {{"Height", std::move(pixels)}};
  case MapTarget::opacity:
    return {{"Opacity", std::move(pixels)}};
  }
  return {};
}

std::string fileStem(std::string material, Importer importer) {
  for (char& c : material)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-')
      c = '_';
  if (material.empty())
    material = "noise";
  return (importer == Importer::unreal ? "T_" : "") + material; // Unreal's prefix of textures
}

Result<void> giveFiles(const std::string& material, const NoiseMap& map, LinearImage values,
                       const TextureStyle& style,
                       const std::function<Result<void>(const TextureFile&)>& take) {
  for (Texture& texture : texturesBefore(map, std::move(values), style)) {
    std::string name = fileStem(material, style.importer) + "_" + std::string(texture.suffix) +
                       (style.format == TextureFormat::exr ? ".exr" : ".png");
    Result<std::vector<std::byte>> bytes =
        style.format == TextureFormat::exr
            ? encodeExr(texture.pixels)
            : encodeCoreTexture(map.target, std::move(texture.pixels));
    if (!bytes)
      return bytes.error();
    if (Result<void> taken = take({std::move(name), std::move(bytes).value()}); !taken)
      return taken.error();
  }
  return {};
}

Result<void> giveAllFiles(const Bundle& bundle, const SynthesisOptions& synthesis,
                          const TextureStyle& style,
                          const std::function<Result<void>(const TextureFile&)>& take) {
  const std::size_t index = synthesis.material.noise;
  if (index >= bundle.noises.size())
    return Error{ErrorKind::usage, "noise " + std::to_string(index) + ": the bundle has " +
                                       std::to_string(bundle.noises.size())};
  const Noise& noise = bundle.noises[index];
  const bool packsOpacity = opacityIsAlpha(style.importer) &&
                            findMap(noise, MapTarget::baseColor) &&
                            findMap(noise, MapTarget::opacity);
  const auto count = double(noise.maps.size());
  double done = 0.0; // maps
  const auto valuesOf = [&](MapTarget target) {
    SynthesisOptions one = synthesis;
    one.map = target;
    one.progress = partOf(synthesis.progress, done / count, (done + 1.0) / count);
    done += 1.0;
    return synthesize(bundle, one);
  };
  for (const NoiseMap& map : noise.maps) {
    if (map.target == MapTarget::opacity && packsOpacity)
      continue;
    Result<LinearImage> values = valuesOf(map.target);
    if (!values)
      return values.error();
    if (map.target == MapTarget::baseColor && packsOpacity) {
      const Result<LinearImage> opacity = valuesOf(MapTarget::opacity);
      if (!opacity)
        return opacity.error();
      values = withAlpha(values.value(), opacity.value());
    }
    if (Result<void> given = giveFiles(noise.name, map, std::move(values).value(), style, take);
        !given)
      return given.error();
  }
  return {};
}

} // namespace

Result<void> makeTextures(const Bundle& bundle, const SynthesisOptions& synthesis,
                          const TextureStyle& style,
                          const std::function<Result<void>(const TextureFile& file)>& take) {
  return withinMemory([] { return "not enough memory to make the textures"; },
                      [&] { return giveAllFiles(bundle, synthesis, style, take); });
}

} // namespace lichen
