// SPDX-License-Identifier: MIT
// Materials and a noise -> the textures that stay; see apply_textures.h.
#include "apply_textures.h"

#include "apply_materials.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {
namespace {

using nlohmann::json;

/// A texture of a material and the channels of a noise that take its place.
struct Slot {
  const char* place; ///< a JSON pointer into the material
  MapTarget target;
  std::vector<MapChannel> channels;
};

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

std::vector<std::string> notesOnTextures(const GltfScene& scene,
                                         std::span<const std::size_t> materials,
                                         const Noise& noise) {
  const std::vector<Slot> slots{
      {"/pbrMetallicRoughness/baseColorTexture", MapTarget::baseColor, {MapChannel::red}},
      {"/normalTexture", MapTarget::normal, {MapChannel::slopeX}},
      {"/pbrMetallicRoughness/metallicRoughnessTexture",
       MapTarget::occlusionRoughnessMetallic,
       {MapChannel::roughness, MapChannel::metallic}},
      {"/occlusionTexture", MapTarget::occlusionRoughnessMetallic, {MapChannel::occlusion}},
      {"/emissiveTexture", MapTarget::emissive, {MapChannel::red}}};
  std::vector<std::string> staying;
  for (const std::size_t material : materials)
    for (const Slot& slot : slots) {
      const json::json_pointer place(slot.place);
      if (!takesWholePlaceOf(noise, slot) &&
          scene.document()["materials"][material].contains(place))
        staying.push_back(fmt::format("{} of {}", place.back(), scene.materialTitle(material)));
    }
  if (staying.empty())
    return {};
  return {fmt::format("{}: {} {}: the noise has no such map, or not all its channels",
                      scene.path().string(), shortList(staying),
                      staying.size() == 1 ? "stays" : "stay")};
}

} // namespace lichen::cli
