// SPDX-License-Identifier: MIT
// Meshes of a scene -> errors and notes; see apply_meshes.h.
#include "apply_meshes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace lichen::cli {
namespace {

/// Returns " and 3 others" for a group of 4; empty for a group of 1.
std::string andOthers(std::size_t count) {
  return count < 2 ? "" : fmt::format(" and {} other{}", count - 1, count == 2 ? "" : "s");
}

/// The first primitive of a group, and the number of primitives in it.
struct Group {
  std::string first;
  std::size_t count = 0;
};

} // namespace

Result<void> checkMeshes(GltfScene& scene, std::span<const std::size_t> materials,
                         std::vector<std::string>& notes) {
  static const nlohmann::json kNone = nlohmann::json::array();
  const auto found = scene.document().find("meshes");
  const nlohmann::json& meshes = found == scene.document().end() ? kNone : *found;
  std::map<std::string, Group> compressed; // by extension
  Group broken;
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; meshes[m].contains("primitives") && p < meshes[m]["primitives"].size();
         ++p) {
      const PrimitivePlace place{m, p};
      const nlohmann::json& primitive = meshes[m]["primitives"][p];
      const bool getsNoise = primitive.contains("material") &&
                             std::find(materials.begin(), materials.end(),
                                       primitive["material"].get<std::size_t>()) != materials.end();
      const Result<std::optional<std::string>> checked = scene.checkVertices(place);
      if (!checked && (getsNoise || checked.error().kind != ErrorKind::badInput))
        return checked.error();
      if (!checked && broken.count++ == 0)
        broken.first = checked.error().message;
      if (!checked || !checked.value())
        continue;
      Group& group = compressed[*checked.value()];
      if (group.count++ == 0)
        group.first = scene.primitiveTitle(place);
    }
  if (broken.count > 0)
    notes.push_back(fmt::format("{}; it{} {} without noise and unchanged, but viewers may "
                                "reject the scene",
                                broken.first, andOthers(broken.count),
                                broken.count == 1 ? "is" : "are"));
  for (const auto& [extension, group] : compressed)
    notes.push_back(fmt::format("{}: {}{}: compressed with {}, which lichen-render does not read",
                                scene.path().string(), group.first, andOthers(group.count),
                                extension));
  return {};
}

} // namespace lichen::cli
