// SPDX-License-Identifier: MIT
// Materials and a noise -> the textures that remain; see apply_textures.h.
#include "apply_textures.h"

#include "apply_extensions.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace lichen::cli {
namespace {

using nlohmann::json;

/// A texture of a material, and the channels of a noise that can replace it.
struct Slot {
  const char* place; ///< a JSON pointer into the material
  MapTarget target;
  std::vector<MapChannel> channels;
};

const std::vector<Slot>& coreSlots() {
  static const std::vector<Slot> slots{
      {"/pbrMetallicRoughness/baseColorTexture", MapTarget::baseColor, {MapChannel::red}},
      {"/normalTexture", MapTarget::normal, {MapChannel::slopeX}},
      {"/pbrMetallicRoughness/metallicRoughnessTexture",
       MapTarget::occlusionRoughnessMetallic,
       {MapChannel::roughness, MapChannel::metallic}},
      {"/occlusionTexture", MapTarget::occlusionRoughnessMetallic, {MapChannel::occlusion}},
      {"/emissiveTexture", MapTarget::emissive, {MapChannel::red}}};
  return slots;
}

bool takesWholePlaceOf(const Noise& noise, const Slot& slot) {
  const std::optional<std::size_t> map = findMap(noise, slot.target);
  if (!map)
    return false;
  const std::vector<MapChannel>& has = noise.maps[*map].channels;
  return std::all_of(slot.channels.begin(), slot.channels.end(), [&](MapChannel channel) {
    return std::find(has.begin(), has.end(), channel) != has.end();
  });
}

/// The material as removeCompetingExtensions() leaves it, as far as textures go.
json withCoreTextures(json material) {
  const json::json_pointer glossy("/extensions/" + std::string(kSpecularGlossiness));
  if (!material.contains(glossy))
    return material;
  const json::json_pointer diffuse = glossy / "diffuseTexture";
  if (isSpecularGlossy(material) && material.contains(diffuse))
    material["pbrMetallicRoughness"]["baseColorTexture"] = material[diffuse];
  material["extensions"].erase(kSpecularGlossiness);
  return material;
}

/// Adds the textures of a material that remain visible beside the noise; all of them if `noise` is
/// null.
void addTextures(const json& value, const std::string& pointer, const Noise* noise, bool hasAlpha,
                 std::set<std::size_t>& textures) {
  if (!value.is_structured())
    return;
  if (noise != nullptr)
    for (const Slot& slot : coreSlots())
      if (pointer == slot.place && takesWholePlaceOf(*noise, slot) &&
          (slot.target != MapTarget::baseColor || !hasAlpha || findMap(*noise, MapTarget::opacity)))
        return;
  if (value.is_object() && value.contains("index") && value["index"].is_number_unsigned())
    textures.insert(value["index"].get<std::size_t>());
  for (const auto& [key, member] : value.items())
    addTextures(member, pointer + "/" + key, noise, hasAlpha, textures);
}

/// Adds the images of a texture, including those that extensions reference.
void addImages(const json& texture, std::set<std::size_t>& images) {
  for (const auto& [key, member] : texture.items())
    if (key == "source" && member.is_number_unsigned())
      images.insert(member.get<std::size_t>());
    else if (member.is_object())
      addImages(member, images);
}

/// Returns the images that a viewer of the noise shows.
std::set<std::size_t> imagesInUse(const GltfScene& scene, std::span<const std::size_t> materials,
                                  const Noise& noise, const MixWeight& mix) {
  std::set<std::size_t> textures, images;
  if (mix.source == MixSource::texture)
    textures.insert(mix.texture);
  for (std::size_t m = 0; m < scene.materialCount(); ++m) {
    const json& material = scene.document()["materials"][m];
    const bool hasNoise = std::find(materials.begin(), materials.end(), m) != materials.end();
    const bool hasAlpha = material.contains("alphaMode") && material["alphaMode"] != "OPAQUE";
    if (hasNoise)
      addTextures(withCoreTextures(material), "", &noise, hasAlpha, textures);
    else
      addTextures(material, "", nullptr, hasAlpha, textures);
  }
  for (const std::size_t texture : textures)
    if (const json::json_pointer place("/textures/" + std::to_string(texture));
        scene.document().contains(place))
      addImages(scene.document()[place], images);
  return images;
}

} // namespace

std::vector<std::string> notesOnTextures(const GltfScene& scene,
                                         std::span<const std::size_t> materials,
                                         const Noise& noise) {
  std::vector<std::string> staying;
  for (const std::size_t m : materials) {
    const json material = withCoreTextures(scene.document()["materials"][m]);
    for (const Slot& slot : coreSlots()) {
      const json::json_pointer place(slot.place);
      if (!takesWholePlaceOf(noise, slot) && material.contains(place))
        staying.push_back(fmt::format("{} of {}", place.back(), scene.materialTitle(m)));
    }
  }
  if (staying.empty())
    return {};
  return {fmt::format("{}: {} {} visible: the noise has no such map, or not all its channels",
                      scene.path().string(), shortList(staying),
                      staying.size() == 1 ? "stays" : "stay")};
}

void leaveReplacedImages(GltfScene& scene, std::span<const std::size_t> materials,
                         const Noise& noise, const MixWeight& mix,
                         std::vector<std::string>& notes) {
  const std::vector<UnusableImage> unusable = scene.unusableImages();
  if (unusable.empty())
    return;
  const std::set<std::size_t> used = imagesInUse(scene, materials, noise, mix);
  for (const auto& [image, reason] : unusable) {
    if (used.contains(image))
      continue;
    scene.leaveImage(image);
    notes.push_back(fmt::format("{}: /images/{}: {}, but the noise replaces everything that shows "
                                "it",
                                scene.path().string(), image, reason));
  }
}

} // namespace lichen::cli
