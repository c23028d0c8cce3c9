// SPDX-License-Identifier: MIT
// Primitives without a frame -> one mesh -> directions -> accessors; see surface_frames.h.
#include <lichen/surface_frames.h>

#include <nlohmann/json.hpp>

#include <map>

namespace lichen {
namespace {

/// The first texture or effect of a material that needs tangents, or nothing.
std::optional<std::string> tangentReader(const nlohmann::json& material, bool hasOtherNormals) {
  using nlohmann::json;
  constexpr std::string_view kNormals = "/normalTexture";
  for (const std::string_view place :
       {kNormals, std::string_view("/extensions/KHR_materials_anisotropy"),
        std::string_view("/extensions/KHR_materials_clearcoat/clearcoatNormalTexture")})
    if (const json::json_pointer pointer{std::string(place)};
        material.contains(pointer) && !(hasOtherNormals && place == kNormals))
      return pointer.back();
  return std::nullopt;
}

/// The primitives without a frame, per mesh.
Result<std::map<std::size_t, std::vector<PrimitivePlace>>>
placesWithoutFrame(const GltfScene& scene, std::span<const std::size_t> materials,
                   bool bringsNormals) {
  std::map<std::size_t, std::vector<PrimitivePlace>> places;
  for (const std::size_t material : materials)
    for (const PrimitivePlace place : scene.primitivesOf(material)) {
      if (hasFrame(scene, place))
        continue;
      if (const auto reader = tangentReader(scene.document()["materials"][material], bringsNormals))
        return Error{ErrorKind::badInput,
                     scene.path().string() + ": " + scene.primitiveTitle(place) +
                         ": has no TANGENT, and " + *reader + " of " +
                         scene.materialTitle(material) +
                         " needs one that follows its texture coordinates; export the mesh with "
                         "tangents, or choose a material without " +
                         *reader};
      places[place.mesh].push_back(place);
    }
  return places;
}

/// Primitives that share their vertices, and the index of the first of these in the joined mesh.
struct VertexBlock {
  std::vector<PrimitivePlace> places;
  std::size_t first = 0;
  std::size_t count = 0;
  bool hasNormals = false;
};

/// Limits the data to read and solve in one scene, because a small file can name the same vertices
/// many times. Enough for some minutes of work.
class Budget {
public:
  /// Adds to the totals and returns whether they are within the limits.
  [[nodiscard]] bool spend(std::size_t elements, std::size_t triangles) {
    elements_ += elements;
    triangles_ += triangles;
    return elements_ <= kMostElements && triangles_ <= kMostTriangles;
  }

private:
  static constexpr std::size_t kMostElements = std::size_t(1) << 30; // vertices and indices
  static constexpr std::size_t kMostTriangles = 4 * kMostFieldTriangles;

  std::size_t elements_ = 0;
  std::size_t triangles_ = 0;
};

/// The primitives of a mesh, joined.
struct JoinedMesh {
  std::vector<VertexBlock> blocks;
  std::vector<Vector3> positions;
  std::vector<Vector3> normals; ///< zero where they are absent
  std::vector<std::uint32_t> triangles;
};

Result<JoinedMesh> join(GltfScene& scene, const std::vector<PrimitivePlace>& places,
                        Budget& budget) {
  JoinedMesh mesh;
  std::map<std::pair<std::size_t, std::optional<std::size_t>>, std::size_t> blockOf;
  for (const PrimitivePlace place : places) {
    Result<PrimitiveGeometry> read = scene.geometry(place);
    if (!read)
      return read.error();
    PrimitiveGeometry& geometry = read.value();
    const std::size_t triangles = geometry.triangles.size() / 3;
    if (!budget.spend(geometry.positions.size() + geometry.triangles.size(), triangles))
      return Error{ErrorKind::resources,
                   scene.path().string() + ": " + scene.primitiveTitle(place) +
                       ": the primitives up to this one have too many triangles or vertices "
                       "in all; choose fewer materials at a time"};
    const auto [entry, isNew] =
        blockOf.try_emplace({*scene.attribute(place, "POSITION"), scene.attribute(place, "NORMAL")},
                            mesh.blocks.size());
    if (isNew) {
      const std::size_t count = geometry.positions.size();
      mesh.blocks.push_back({{}, mesh.positions.size(), count, !geometry.normals.empty()});
      mesh.positions.insert(mesh.positions.end(), geometry.positions.begin(),
                            geometry.positions.end());
      geometry.normals.resize(count, Vector3{});
      mesh.normals.insert(mesh.normals.end(), geometry.normals.begin(), geometry.normals.end());
    }
    VertexBlock& block = mesh.blocks[entry->second];
    block.places.push_back(place);
    if (mesh.triangles.size() + geometry.triangles.size() > 3 * kMostFieldTriangles ||
        mesh.positions.size() > 3 * kMostFieldTriangles)
      return Error{ErrorKind::resources,
                   scene.path().string() + ": " + scene.meshTitle(place.mesh) + ": more than " +
                       std::to_string(kMostFieldTriangles) +
                       " triangles; use a smaller mesh, or one with tangents"};
    for (const std::uint32_t index : geometry.triangles)
      mesh.triangles.push_back(std::uint32_t(block.first + index));
  }
  return mesh;
}

void addAttributes(GltfScene& scene, const JoinedMesh& mesh, const DirectionField& field) {
  for (const VertexBlock& block : mesh.blocks) {
    std::vector<std::array<float, 4>> tangents;
    for (std::size_t v = block.first; v < block.first + block.count; ++v)
      tangents.push_back({field.tangents[v][0], field.tangents[v][1], field.tangents[v][2], 1.0f});
    const std::size_t tangent = scene.addVertices(tangents);
    std::optional<std::size_t> normal;
    if (!block.hasNormals)
      normal = scene.addVertices(std::span(field.normals).subspan(block.first, block.count));
    for (const PrimitivePlace place : block.places) {
      if (normal)
        scene.setAttribute(place, "NORMAL", *normal);
      scene.setAttribute(place, "TANGENT", tangent);
    }
  }
}

std::vector<FrameSingularity> singularitiesOf(const JoinedMesh& mesh, const DirectionField& field) {
  std::vector<FrameSingularity> singularities;
  for (const FieldSingularity& found : field.singularities) {
    FrameSingularity& singularity = singularities.emplace_back();
    singularity.index = found.index;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        singularity.position[axis] +=
            mesh.positions[mesh.triangles[3 * found.triangle + k]][axis] / 3.0f;
  }
  return singularities;
}

Result<MeshFrames> addToMesh(GltfScene& scene, const std::vector<PrimitivePlace>& places,
                             Budget& budget, const std::optional<Vector3>& grain,
                             const Progress& progress) {
  const std::string title = scene.meshTitle(places.front().mesh);
  const Result<JoinedMesh> joined = join(scene, places, budget);
  if (!joined)
    return joined.error();
  const JoinedMesh& mesh = joined.value();
  const Result<DirectionField> field =
      directionField(mesh.positions, mesh.triangles, mesh.normals, progress, grain);
  if (!field)
    return Error{field.error().kind,
                 scene.path().string() + ": " + title + ": " + field.error().message};
  addAttributes(scene, mesh, field.value());
  MeshFrames frames{title, mesh.triangles.size() / 3, false, field.value().components,
                    singularitiesOf(mesh, field.value())};
  for (const VertexBlock& block : mesh.blocks)
    frames.hasNewNormals = frames.hasNewNormals || !block.hasNormals;
  return frames;
}

} // namespace

bool hasFrame(const GltfScene& scene, PrimitivePlace place) {
  return scene.attribute(place, "TANGENT") && scene.attribute(place, "NORMAL");
}

Result<void> checkFrames(const GltfScene& scene, std::size_t material, bool bringsNormals) {
  const auto places = placesWithoutFrame(scene, {&material, 1}, bringsNormals);
  return places ? Result<void>() : Result<void>(places.error());
}

Result<std::vector<MeshFrames>> addSurfaceFrames(GltfScene& scene,
                                                 std::span<const std::size_t> materials,
                                                 const FrameOptions& options,
                                                 const Progress& progress) {
  const auto add = [&]() -> Result<std::vector<MeshFrames>> {
    const auto places = placesWithoutFrame(scene, materials, options.bringsNormals);
    if (!places)
      return places.error();
    std::vector<MeshFrames> all;
    Budget budget;
    const auto meshes = double(places.value().size());
    for (const auto& [mesh, ofMesh] : places.value()) {
      const auto done = double(all.size());
      Result<MeshFrames> added = addToMesh(scene, ofMesh, budget, options.grain,
                                           partOf(progress, done / meshes, (done + 1.0) / meshes));
      if (!added)
        return added.error();
      all.push_back(std::move(added).value());
    }
    return all;
  };
  return withinMemory(
      [&] { return scene.path().string() + ": not enough memory for the frames of its meshes"; },
      add);
}

} // namespace lichen
