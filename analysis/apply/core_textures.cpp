// SPDX-License-Identifier: MIT
// Materials and a noise -> materials without the extension that hides it, and the textures that
// remain. Sources: KHR_materials_unlit; KHR_materials_pbrSpecularGlossiness (archived).
#include "steps.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::apply {
namespace {

using nlohmann::json;

constexpr const char* kUnlit = "KHR_materials_unlit";
constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

bool has(const GltfScene& scene, std::size_t material, const std::string& extension) {
  return scene.document()["materials"][material].contains(
      json::json_pointer("/extensions/" + extension));
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

} // namespace

Result<void> checkShading(const GltfScene& scene, std::span<const std::size_t> materials) {
  for (const std::size_t material : materials)
    if (has(scene, material, kSpecularGlossiness))
      return Error{ErrorKind::badInput,
                   fmt::format("{}: {} has {}, which hides the noise; convert it to "
                               "metallic-roughness first, as 'gltf-transform metalrough' does",
                               scene.path().string(), scene.materialTitle(material),
                               kSpecularGlossiness)};
  return {};
}

void removeUnlit(GltfScene& scene, std::span<const std::size_t> materials,
                 std::vector<std::string>& notes) {
  std::vector<std::size_t> having;
  std::vector<std::string> titles;
  for (const std::size_t material : materials)
    if (has(scene, material, kUnlit)) {
      having.push_back(material);
      titles.push_back(scene.materialTitle(material));
    }
  if (having.empty())
    return;
  scene.removeExtension(having, kUnlit);
  notes.push_back(fmt::format("{}: removed {} from {}: the noise needs the metallic-roughness "
                              "shading of core glTF",
                              scene.path().string(), kUnlit, shortList(titles)));
}

std::vector<std::string> notesOnTextures(const GltfScene& scene,
                                         std::span<const std::size_t> materials,
                                         const Noise& noise) {
  std::vector<std::string> staying;
  for (const std::size_t m : materials) {
    const json& material = scene.document()["materials"][m];
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
