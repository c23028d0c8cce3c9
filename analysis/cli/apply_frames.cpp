// SPDX-License-Identifier: MIT
// Meshes of a scene -> tangent frames and notes; see apply_frames.h.
#include "apply_frames.h"

#include "options.h"
#include "progress_line.h"

#include <lichen/counted.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {
namespace {

/// X,Y,Z, not the zero vector.
Accepted<Vector3> axis() {
  constexpr double kMost = 1e6; // only the ratios of the components matter
  constexpr std::size_t kNumbers = 3;
  const Accepted<std::vector<double>> list = numbers({-kMost, kMost}, kNumbers);
  return {"X,Y,Z", fmt::format("X,Y,Z with numbers from {} to {}, not all 0", -kMost, kMost),
          [read = list.read](const std::string& text) -> std::optional<Vector3> {
            const std::optional<std::vector<double>> values = read(text);
            if (!values || values->size() != kNumbers)
              return std::nullopt;
            const Vector3 axis{float((*values)[0]), float((*values)[1]), float((*values)[2])};
            return axis == Vector3{} ? std::nullopt : std::optional(axis);
          }};
}

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

std::vector<std::string> notesOn(const GltfScene& scene, const std::vector<MeshFrames>& meshes) {
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
    const std::string others = more > 0
                                   ? fmt::format("; {} more {} such triangles; --json lists them",
                                                 more, more == 1 ? "mesh has" : "meshes have")
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

bool hasFrame(const GltfScene& scene, PrimitivePlace place) {
  return scene.attribute(place, "TANGENT") && scene.attribute(place, "NORMAL");
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

/// Notes the meshes that --grain does not affect: one note per material, which may have thousands
/// of meshes.
std::vector<std::string> notesOnGrain(const GltfScene& scene,
                                      std::span<const std::size_t> materials) {
  std::vector<std::string> notes;
  for (const std::size_t material : materials) {
    std::vector<PrimitivePlace> framed = scene.primitivesOf(material);
    std::erase_if(framed, [&](PrimitivePlace place) { return !hasFrame(scene, place); });
    if (framed.empty())
      continue;
    const std::string more =
        framed.size() > 1 ? fmt::format(", like {} more of its material", framed.size() - 1) : "";
    notes.push_back(
        fmt::format("{}: {}{}: has tangents, which the noise follows instead of --grain",
                    scene.path().string(), scene.primitiveTitle(framed.front()), more));
  }
  return notes;
}

void append(std::vector<std::string>& notes, std::vector<std::string> more) {
  notes.insert(notes.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

} // namespace

void addFrameOptions(CLI::App& verb, std::optional<Vector3>& grain) {
  addValue(
      verb, "--grain", grain, optional(axis()), "",
      "surface: an axis in the space of each mesh that the exemplar's rows follow [default: the "
      "smoothest directions]");
}

Result<AddedFrames> addFrames(GltfScene& scene, std::span<const std::size_t> materials,
                              const Noise& noise, Mapping mapping,
                              const std::optional<Vector3>& grain, const SharedOptions& shared) {
  if (mapping != Mapping::surface) {
    if (grain)
      return Error{ErrorKind::usage, fmt::format("--grain: belongs to --mapping surface, not to {}",
                                                 nameOf(mapping))};
    return AddedFrames{};
  }
  AddedFrames added;
  const bool bringsNormals = findMap(noise, MapTarget::normal).has_value();
  if (bringsNormals)
    added.notes = notesOnNormals(scene, materials);
  if (grain)
    append(added.notes, notesOnGrain(scene, materials));
  ProgressLine progress("apply", shared);
  Result<std::vector<MeshFrames>> meshes =
      addSurfaceFrames(scene, materials, {grain, bringsNormals}, progress.asProgress());
  if (!meshes)
    return meshes.error();
  added.meshes = std::move(meshes).value();
  append(added.notes, notesOn(scene, added.meshes));
  return added;
}

nlohmann::ordered_json asJson(std::span<const MeshFrames> frames) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const MeshFrames& mesh : frames) {
    Json singularities = Json::array();
    for (const FrameSingularity& singularity : mesh.singularities)
      singularities.push_back({{"position", singularity.position}, {"index", singularity.index}});
    Json components = Json::array();
    for (const FieldComponent& component : mesh.components)
      components.push_back({{"triangles", component.triangles},
                            {"closed", component.isClosed},
                            {"eulerCharacteristic", component.eulerCharacteristic},
                            {"singularities", component.singularities}});
    list.push_back({{"mesh", mesh.mesh},
                    {"triangles", mesh.triangles},
                    {"newNormals", mesh.hasNewNormals},
                    {"components", components},
                    {"singularities", singularities}});
  }
  return list;
}

} // namespace lichen::cli
