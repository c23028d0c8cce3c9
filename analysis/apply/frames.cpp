// SPDX-License-Identifier: MIT
// Meshes of a scene -> tangent frames and notes.
#include "steps.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::apply {
namespace {

/// Lists the points where the direction field is singular, on one line.
std::string placesOf(const std::vector<FrameSingularity>& singularities) {
  constexpr std::size_t kMostNamed = 4; // most meshes have at most four
  std::vector<std::string> places;
  for (const FrameSingularity& singularity : singularities) {
    const auto [x, y, z] = singularity.position;
    places.push_back(fmt::format("({:.3g}, {:.3g}, {:.3g})", x, y, z));
    if (places.size() == kMostNamed)
      break;
  }
  return fmt::format("{}{}", fmt::join(places, ", "),
                     places.size() < singularities.size() ? " and more" : "");
}

std::vector<std::string> notesOn(const GltfScene& scene, const std::vector<MeshFrames>& meshes,
                                 SettingWords words) {
  std::vector<std::string> notes, smoothed;
  const MeshFrames* singular = nullptr; // the first mesh with a singularity
  std::size_t singularMeshes = 0;
  for (const MeshFrames& frames : meshes) {
    if (frames.hasNewNormals)
      smoothed.push_back(frames.mesh);
    if (!frames.singularities.empty() && singularMeshes++ == 0)
      singular = &frames;
  }
  if (singular != nullptr) {
    const std::size_t count = singular->singularities.size();
    const std::size_t more = singularMeshes - 1;
    const std::string others =
        more > 0 ? fmt::format("; {} more {} such triangles; {} lists them", more,
                               more == 1 ? "mesh has" : "meshes have", words({"json", ""}))
                 : "";
    notes.push_back(fmt::format("{}: {}: the noise rotates around {} of its direction field, at {} "
                                "in the mesh's coordinates{}",
                                scene.path().string(), singular->mesh,
                                counted(count, "singular triangle"),
                                placesOf(singular->singularities), others));
  }
  if (!smoothed.empty())
    notes.push_back(fmt::format("{}: {}: had no normals; smooth ones were added",
                                scene.path().string(), shortList(smoothed)));
  return notes;
}

/// Notes the materials whose normal texture will use the noise's tangents instead of tangents from
/// its texture coordinates.
std::vector<std::string> notesOnNormals(const GltfScene& scene,
                                        std::span<const std::size_t> materials) {
  std::vector<std::string> turned;
  for (const std::size_t material : materials) {
    const std::vector<PrimitivePlace> places = scene.primitivesOf(material);
    if (scene.document()["materials"][material].contains("normalTexture") &&
        !std::all_of(places.begin(), places.end(),
                     [&](PrimitivePlace place) { return hasFrame(scene, place); }))
      turned.push_back(scene.materialTitle(material));
  }
  if (turned.empty())
    return {};
  return {fmt::format(
      "{}: {}: viewers without the extension orient {} normalTexture by the noise's tangents",
      scene.path().string(), shortList(turned), turned.size() == 1 ? "its" : "their")};
}

/// Notes the meshes that a grain does not affect: one note per material, which may have thousands
/// of meshes.
std::vector<std::string> notesOnGrain(const GltfScene& scene,
                                      std::span<const std::size_t> materials, SettingWords words) {
  std::vector<std::string> notes;
  for (const std::size_t material : materials) {
    std::vector<PrimitivePlace> framed = scene.primitivesOf(material);
    std::erase_if(framed, [&](PrimitivePlace place) { return !hasFrame(scene, place); });
    if (framed.empty())
      continue;
    const std::string more =
        framed.size() > 1 ? fmt::format(", like {} more of its material", framed.size() - 1) : "";
    notes.push_back(fmt::format("{}: {}{}: has tangents, which the noise follows instead of {}",
                                scene.path().string(), scene.primitiveTitle(framed.front()), more,
                                words({"grain", ""})));
  }
  return notes;
}

} // namespace

Result<std::vector<MeshFrames>> addFrames(GltfScene& scene, std::span<const std::size_t> materials,
                                          const Noise& noise, const std::optional<Vector3>& grain,
                                          const BakeObserver& observer,
                                          std::vector<std::string>& notes) {
  const bool bringsNormals = findMap(noise, MapTarget::normal).has_value();
  if (bringsNormals)
    append(notes, notesOnNormals(scene, materials));
  if (grain)
    append(notes, notesOnGrain(scene, materials, observer.words));
  Result<std::vector<MeshFrames>> meshes =
      addSurfaceFrames(scene, materials, {grain, bringsNormals}, observer.of("apply"));
  if (meshes)
    append(notes, notesOn(scene, meshes.value(), observer.words));
  return meshes;
}

} // namespace lichen::apply
