// SPDX-License-Identifier: MIT
// Materials and a noise -> materials without extensions that hide it, and the textures that remain.
// Sources: KHR_materials_unlit; KHR_materials_pbrSpecularGlossiness (archived).
#include "steps.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::apply {
namespace {

using nlohmann::json;

/// The extension that describes a material by diffuse and specular textures instead of the core's.
constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";
constexpr const char* kCore = "pbrMetallicRoughness";

json::json_pointer placeOf(const char* extension) {
  return json::json_pointer("/extensions/" + std::string(extension));
}

bool brings(const Noise& noise, MapTarget target, MapChannel channel) {
  const std::optional<std::size_t> map = findMap(noise, target);
  if (!map)
    return false;
  const std::vector<MapChannel>& channels = noise.maps[*map].channels;
  return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

/// Whether the material is described by that extension alone, so that removing it moves its diffuse
/// texture to baseColorTexture.
bool isSpecularGlossy(const json& material) {
  return material.contains(placeOf(kSpecularGlossiness)) &&
         material[placeOf(kSpecularGlossiness)].is_object() && !material.contains(kCore);
}

/// Gives a specular-glossy material the core members for all that the noise does not bring.
void describeCore(GltfScene& scene, std::size_t material, const Noise& noise) {
  const json& described = scene.document()["materials"][material];
  const json& glossy = described[placeOf(kSpecularGlossiness)];
  const auto texture = glossy.find("diffuseTexture"); // for viewers without noise, too
  if (texture != glossy.end() && texture->is_object() && texture->contains("index") &&
      (*texture)["index"].is_number_unsigned())
    scene.setTexture(material, kCore, "baseColorTexture", *texture);
  const auto isNumber = [](const json& value) { return value.is_number(); };
  constexpr std::size_t kColorAndAlpha = 4;
  if (const auto color = glossy.find("diffuseFactor");
      color != glossy.end() && color->is_array() && color->size() == kColorAndAlpha &&
      std::all_of(color->begin(), color->end(), isNumber) &&
      !brings(noise, MapTarget::baseColor, MapChannel::red))
    scene.setFactor(material, kCore, "baseColorFactor", color->get<std::vector<double>>());
  constexpr MapTarget kSurface = MapTarget::occlusionRoughnessMetallic;
  if (!brings(noise, kSurface, MapChannel::metallic))
    scene.setFactor(material, kCore, "metallicFactor", {0.0});
  if (const auto glossiness = glossy.find("glossinessFactor");
      glossiness != glossy.end() && glossiness->is_number() &&
      !brings(noise, kSurface, MapChannel::roughness))
    scene.setFactor(material, kCore, "roughnessFactor",
                    {std::clamp(1.0 - glossiness->get<double>(), 0.0, 1.0)});
}

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

} // namespace

void removeCompetingExtensions(GltfScene& scene, std::span<const std::size_t> materials,
                               const Noise& noise, std::vector<std::string>& notes) {
  for (const char* extension : {"KHR_materials_unlit", kSpecularGlossiness}) {
    std::vector<std::size_t> having;
    std::vector<std::string> titles;
    for (const std::size_t material : materials) {
      const json& described = scene.document()["materials"][material];
      if (!described.contains(placeOf(extension)))
        continue;
      having.push_back(material);
      titles.push_back(scene.materialTitle(material));
      if (extension == kSpecularGlossiness && isSpecularGlossy(described))
        describeCore(scene, material, noise);
    }
    if (having.empty())
      continue;
    scene.removeExtension(having, extension);
    notes.push_back(fmt::format("{}: removed {} from {}: the noise needs the metallic-roughness "
                                "shading of core glTF",
                                scene.path().string(), extension, shortList(titles)));
  }
}

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

} // namespace lichen::apply
