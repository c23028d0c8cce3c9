// SPDX-License-Identifier: MIT
// Core glTF materials: preview images in the texture slots, with KHR_texture_transform so that
// exemplars have the same size as in the noise.
#include "preview_material.h"

#include "extension_writer.h"

#include <algorithm>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTextureTransform = "KHR_texture_transform";

bool hasChannel(const Noise& noise, MapChannel channel) {
  return std::any_of(noise.maps.begin(), noise.maps.end(), [channel](const NoiseMap& map) {
    return std::find(map.channels.begin(), map.channels.end(), channel) != map.channels.end();
  });
}

/// Adds an image and a texture with the shared, repeating sampler. Returns the texture's index.
std::size_t addTexture(Json& root, GltfBuilder& builder, const std::string& name,
                       const std::vector<std::byte>& png) {
  constexpr int kLinear = 9729;
  constexpr int kLinearMipmapLinear = 9987;
  if (!root.contains("samplers"))
    root["samplers"].push_back({{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}});
  root["images"].push_back({{"name", name},
                            {"mimeType", "image/png"},
                            {"bufferView", builder.addView(png, sizeof(std::uint32_t))}});
  root["textures"].push_back({{"sampler", 0}, {"source", root["images"].size() - 1}});
  return root["textures"].size() - 1;
}

/// A reference to a texture that spans `tilesPerImage` exemplars. With the extension's tile =
/// offset + R uv / scale, the image coordinate is tile / tilesPerImage.
Json textureInfo(Json& root, std::size_t texture, const MaterialNoise& use, int tilesPerImage) {
  Json info = {{"index", texture}};
  if (use.texCoord != 0)
    info["texCoord"] = use.texCoord;
  const double tiles = tilesPerImage;
  Json transform = Json::object();
  if (use.offset != std::array<double, 2>{0.0, 0.0})
    transform["offset"] = {use.offset[0] / tiles, use.offset[1] / tiles};
  if (use.rotation != 0.0)
    transform["rotation"] = use.rotation;
  if (const double scale = 1.0 / (use.scale * tiles); scale != 1.0)
    transform["scale"] = {scale, scale};
  if (!transform.empty()) {
    info["extensions"][kTextureTransform] = std::move(transform);
    if (Json& used = root["extensionsUsed"];
        std::find(used.begin(), used.end(), kTextureTransform) == used.end())
      used.push_back(kTextureTransform);
  }
  return info;
}

} // namespace

void addMaterial(Json& root, GltfBuilder& builder, const std::string& name, const Noise& noise,
                 const MaterialNoise& use, const PreviewImages& preview) {
  constexpr double kRoughnessWithoutMap = 0.8;
  constexpr const char* kPbr = "pbrMetallicRoughness";
  Json material = {{"name", name}};
  const auto texture = [&](const char* slot, const std::vector<std::byte>& png) {
    return textureInfo(root, addTexture(root, builder, name + "." + slot, png), use,
                       preview.tilesPerImage);
  };
  if (!preview.baseColor.empty())
    material[kPbr]["baseColorTexture"] = texture("baseColor", preview.baseColor);
  // Factors multiply the map; without the channel, the factor is the value.
  material[kPbr]["metallicFactor"] = hasChannel(noise, MapChannel::metallic) ? 1.0 : 0.0;
  material[kPbr]["roughnessFactor"] =
      hasChannel(noise, MapChannel::roughness) ? 1.0 : kRoughnessWithoutMap;
  if (!preview.occlusionRoughnessMetallic.empty()) {
    const Json info = texture("occlusionRoughnessMetallic", preview.occlusionRoughnessMetallic);
    if (hasChannel(noise, MapChannel::roughness) || hasChannel(noise, MapChannel::metallic))
      material[kPbr]["metallicRoughnessTexture"] = info;
    if (hasChannel(noise, MapChannel::occlusion))
      material["occlusionTexture"] = info;
  }
  if (!preview.normal.empty())
    material["normalTexture"] = texture("normal", preview.normal);
  if (!preview.emissive.empty()) {
    material["emissiveTexture"] = texture("emissive", preview.emissive);
    material["emissiveFactor"] = {1.0, 1.0, 1.0};
  }
  // Filtered opacity is the covered share of a pixel, so blending is correct at every distance. A
  // mask would close or open distant surfaces.
  if (hasChannel(noise, MapChannel::opacity))
    material["alphaMode"] = "BLEND";
  material["extensions"][std::string(kExtensionName)] = describeMaterialNoise(use);
  root["materials"].push_back(std::move(material));
}

} // namespace lichen
