// SPDX-License-Identifier: MIT
// Names and indices of materials -> the materials whose meshes can show the noise.
#include "steps.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <map>
#include <numeric>

namespace lichen::apply {
namespace {

/// Returns the only material with this name, or the material with this index.
Result<std::size_t> findMaterial(const GltfScene& scene, const std::string& wanted,
                                 SettingWords words) {
  const auto refuse = [&](const std::string& what) {
    return Error{ErrorKind::usage, fmt::format("{}: {} {}", words({"material", wanted}),
                                               scene.path().string(), what)};
  };
  const std::size_t count = scene.materialCount();
  std::vector<std::size_t> found;
  std::vector<std::string> titles;
  for (std::size_t m = 0; m < count; ++m) {
    const nlohmann::json& material = scene.document()["materials"][m];
    const auto name = material.find("name");
    titles.push_back(std::to_string(m));
    if (name == material.end() || !name->is_string())
      continue;
    titles.back() += fmt::format(" '{}'", name->get<std::string>());
    if (*name == wanted)
      found.push_back(m);
  }
  if (found.size() > 1)
    return refuse(fmt::format("has that name for {}; expected an index", fmt::join(found, ", ")));
  if (!found.empty())
    return found.front();
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (code == std::errc{} && end == wanted.data() + wanted.size() && index < count)
    return index;
  constexpr std::size_t kMostNamed = 12;
  const bool isMore = titles.size() > kMostNamed;
  titles.resize(std::min(titles.size(), kMostNamed));
  return refuse(fmt::format("has no such material; expected one of {}{}", fmt::join(titles, ", "),
                            isMore ? " and others" : ""));
}

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

Result<ChosenMaterials> findMaterials(const GltfScene& scene,
                                      const std::vector<std::string>& wanted, SettingWords words) {
  if (scene.materialCount() == 0)
    return Error{ErrorKind::badInput,
                 scene.path().string() + ": has no materials; expected at least one"};
  ChosenMaterials chosen;
  for (const std::string& each : wanted) {
    if (each == "all") {
      chosen.areAll = true;
      continue;
    }
    const Result<std::size_t> material = findMaterial(scene, each, words);
    if (!material)
      return material.error();
    chosen.indices.push_back(material.value());
  }
  if (chosen.areAll && !chosen.indices.empty())
    return Error{
        ErrorKind::usage,
        fmt::format("{}: given with another {}; expected all, or materials by name or index",
                    words({"material", "all"}), words({"material", ""}))};
  if (chosen.areAll) {
    chosen.indices.resize(scene.materialCount());
    std::iota(chosen.indices.begin(), chosen.indices.end(), std::size_t(0));
  }
  std::sort(chosen.indices.begin(), chosen.indices.end());
  chosen.indices.erase(std::unique(chosen.indices.begin(), chosen.indices.end()),
                       chosen.indices.end());
  return chosen;
}

Result<std::vector<std::size_t>> materialsWith(const std::string& attribute, const GltfScene& scene,
                                               const ChosenMaterials& chosen,
                                               const std::string& option,
                                               const std::string& instead,
                                               std::vector<std::string>& notes) {
  std::vector<std::size_t> fit;
  std::vector<std::string> others;
  std::string first; // the first primitive without the attribute
  for (const std::size_t material : chosen.indices) {
    const std::vector<PrimitivePlace>& places = scene.primitivesOf(material);
    const auto without = std::find_if(places.begin(), places.end(), [&](PrimitivePlace place) {
      return !scene.attribute(place, attribute);
    });
    if (without == places.end()) {
      fit.push_back(material);
      continue;
    }
    others.push_back(scene.materialTitle(material));
    if (first.empty())
      first = scene.primitiveTitle(*without);
  }
  if (others.empty())
    return fit;
  const std::string reason = fmt::format("has no {}, which {} needs", attribute, option);
  if (!chosen.areAll || fit.empty())
    return Error{ErrorKind::badInput,
                 fmt::format("{}: {} with {} {}; use {}", scene.path().string(), first,
                             others.front(), reason, instead)};
  notes.push_back(fmt::format("{}: skipped {}: {} {}; use {} there", scene.path().string(),
                              shortList(others), first, reason, instead));
  return fit;
}

Result<std::vector<std::size_t>> materialsWithFrames(const GltfScene& scene,
                                                     const ChosenMaterials& chosen,
                                                     bool bringsNormals,
                                                     std::vector<std::string>& notes) {
  std::vector<std::size_t> fit;
  std::vector<std::string> others;
  std::optional<Error> first;
  for (const std::size_t material : chosen.indices) {
    const Result<void> checked = checkFrames(scene, material, bringsNormals);
    if (checked) {
      fit.push_back(material);
      continue;
    }
    others.push_back(scene.materialTitle(material));
    if (!first)
      first = checked.error();
  }
  if (first && (!chosen.areAll || fit.empty()))
    return *first;
  if (first)
    notes.push_back(fmt::format("{}; skipped {}", first->message, shortList(others)));
  return fit;
}

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

} // namespace lichen::apply
