// SPDX-License-Identifier: MIT
// The nodes with a material, and a noise -> the size of a tile in metres and pixels; see
// tile_size.h.
#include <lichen/gltf_scene.h>
#include <lichen/tile_size.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace lichen {
namespace {

// The nodes of a scene and the transforms of their meshes. Source: glTF 2.0 specification, sections
// 3.5 and 3.7.3.

struct MeshInstance {
  std::size_t node = 0;
  std::size_t mesh = 0;
  Eigen::Affine3d worldFromMesh;
};

using nlohmann::json;

/// The element of an array of the root, or null.
const json* element(const json& root, const char* array, std::size_t index) {
  const auto list = root.find(array);
  return list != root.end() && list->is_array() && index < list->size() ? &(*list)[index] : nullptr;
}

std::optional<std::size_t> indexOf(const json& object, const char* key) {
  const auto value = object.is_object() ? object.find(key) : object.end();
  return value != object.end() && value->is_number_unsigned()
             ? std::optional(value->get<std::size_t>())
             : std::nullopt;
}

/// The indices in an array of an object; empty if absent.
std::vector<std::size_t> indicesOf(const json& object, const char* key) {
  std::vector<std::size_t> indices;
  const auto list = object.is_object() ? object.find(key) : object.end();
  if (list != object.end() && list->is_array())
    for (const json& each : *list)
      if (each.is_number_unsigned())
        indices.push_back(each.get<std::size_t>());
  return indices;
}

/// Numbers of a node; `absent` if it does not have as many.
std::vector<double> numbersOf(const json& node, const char* key, std::vector<double> absent) {
  const auto list = node.find(key);
  if (list == node.end() || !list->is_array() || list->size() != absent.size() ||
      !std::all_of(list->begin(), list->end(), [](const json& each) { return each.is_number(); }))
    return absent;
  return list->get<std::vector<double>>();
}

Eigen::Affine3d localTransform(const json& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.contains("matrix")) {
    const std::vector<double> m =
        numbersOf(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
    return transform;
  }
  const std::vector<double> t = numbersOf(node, "translation", {0, 0, 0});
  const std::vector<double> q = numbersOf(node, "rotation", {0, 0, 0, 1}); // x, y, z, w
  const std::vector<double> s = numbersOf(node, "scale", {1, 1, 1});
  transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  transform.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  return transform;
}

/// The world transform of each node of the default scene.
std::vector<std::optional<Eigen::Affine3d>> worldTransforms(const json& root) {
  std::vector<std::optional<Eigen::Affine3d>> worlds;
  const auto nodes = root.find("nodes");
  const json* scene = element(root, "scenes", indexOf(root, "scene").value_or(0));
  if (nodes == root.end() || !nodes->is_array() || scene == nullptr)
    return worlds;
  worlds.resize(nodes->size());
  std::vector<std::pair<std::size_t, Eigen::Affine3d>> pending; // a node and its parent's transform
  const auto push = [&](const json& object, const char* key, const Eigen::Affine3d& parent) {
    for (const std::size_t child : indicesOf(object, key))
      pending.emplace_back(child, parent);
  };
  push(*scene, "nodes", Eigen::Affine3d::Identity());
  while (!pending.empty()) {
    const auto [index, parent] = pending.back();
    pending.pop_back();
    if (index >= worlds.size() || worlds[index] || !(*nodes)[index].is_object())
      continue;
    worlds[index] = parent * localTransform((*nodes)[index]);
    push((*nodes)[index], "children", *worlds[index]);
  }
  return worlds;
}

/// The transform that the first joint of a skin gives to its mesh, which ignores its own node's.
Eigen::Affine3d skinTransform(GltfScene& scene, const json& skin,
                              const std::vector<std::optional<Eigen::Affine3d>>& worlds) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  const std::vector<std::size_t> joints = indicesOf(skin, "joints");
  if (!joints.empty() && joints.front() < worlds.size() && worlds[joints.front()])
    transform = *worlds[joints.front()];
  if (const auto accessor = indexOf(skin, "inverseBindMatrices"))
    if (const auto matrices = scene.matrices(*accessor); matrices && !matrices.value().empty()) {
      const Eigen::Matrix4f inverseBind =
          Eigen::Map<const Eigen::Matrix4f>(matrices.value().front().data());
      transform.matrix() *= inverseBind.cast<double>();
    }
  return transform;
}

/// The nodes of the default scene (or else the first one) that have a mesh. Skips members that
/// violate glTF, and each further visit of a node. A skin counts as its first joint.
std::vector<MeshInstance> meshInstances(GltfScene& scene) {
  const json& root = scene.document();
  const std::vector<std::optional<Eigen::Affine3d>> worlds = worldTransforms(root);
  std::vector<MeshInstance> instances;
  for (std::size_t node = 0; node < worlds.size(); ++node) {
    const auto mesh = worlds[node] ? indexOf(root["nodes"][node], "mesh") : std::nullopt;
    if (!mesh)
      continue;
    const auto skinIndex = indexOf(root["nodes"][node], "skin");
    const json* skin = skinIndex ? element(root, "skins", *skinIndex) : nullptr;
    instances.push_back(
        {node, *mesh, skin != nullptr ? skinTransform(scene, *skin, worlds) : *worlds[node]});
  }
  return instances;
}

// The size of a tile on an object.

using Box = Eigen::AlignedBox3d;

constexpr double kHalfFieldOfView = std::numbers::pi / 8.0; // 22.5 degrees

/// A node that has the material.
struct Wearer {
  MeshInstance instance;
  Box world; ///< encloses the parts with the material
};

Eigen::Vector3d pointOf(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

/// The eight corners of a box, transformed.
std::vector<Eigen::Vector3d> cornersOf(const Box& box, const Eigen::Affine3d& transform) {
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(transform * box.corner(Box::CornerType(k)));
  return corners;
}

Box boxOf(const std::vector<Eigen::Vector3d>& points) {
  Box box;
  for (const Eigen::Vector3d& point : points)
    box.extend(point);
  return box;
}

/// The nodes of a scene by their mesh.
using InstancesOf = std::map<std::size_t, std::vector<MeshInstance>>;

/// Reads meshes up to a limit, because a small file can name the same vertices and nodes many
/// times.
class MeshReader {
public:
  explicit MeshReader(GltfScene& scene) : scene_(scene) {}

  [[nodiscard]] GltfScene& scene() const { return scene_; }

  Result<PrimitiveGeometry> geometry(PrimitivePlace place) {
    if (Result<void> within = spend(1); !within)
      return within.error();
    Result<PrimitiveGeometry> read = scene_.geometry(place);
    if (read)
      elements_ += read.value().positions.size() + read.value().triangles.size();
    return read;
  }

  /// Adds to the vertices, indices and nodes visited so far.
  Result<void> spend(std::size_t elements) {
    elements_ += elements;
    if (elements_ > kMostElements)
      return Error{ErrorKind::resources, scene_.path().string() + ": has too many vertices"};
    return {};
  }

private:
  static constexpr std::size_t kMostElements = std::size_t(1) << 28; // some ten seconds of work

  GltfScene& scene_;
  std::size_t elements_ = 0;
};

/// Measures a tile on the nodes that have one material.
class TileMeasure {
public:
  TileMeasure(MeshReader& reader, const InstancesOf& instancesOf, std::size_t material,
              const Noise& noise, const MaterialNoise& use)
      : reader_(reader), instancesOf_(instancesOf), material_(material), noise_(noise), use_(use) {}

  Result<TileSize> run() {
    Result<std::vector<Wearer>> found = wearers();
    if (!found)
      return found.error();
    std::vector<Wearer> object = std::move(found).value();
    if (!isInSpace(use_.mapping) || use_.space == NoiseSpace::object)
      object = {*std::max_element(object.begin(), object.end(), [](const auto& a, const auto& b) {
        return a.world.diagonal().norm() < b.world.diagonal().norm();
      })};
    const double radius = object.size() == 1 ? radiusOf(object.front()) : radiusOf(object);
    const Result<double> metres = tileMetres(object.front().instance);
    if (Result<void> all = reader_.spend(0); !all)
      return all.error();
    if (!metres)
      return metres.error();
    // The sphere touches the planes of the field of view at the distance radius / sin(half angle),
    // where half the picture's height spans tan(half angle) times the distance.
    const double pixelsPerMetre = 0.5 * kViewHeight * std::cos(kHalfFieldOfView) / radius;
    const double pixels = metres.value() * pixelsPerMetre;
    if (!std::isfinite(pixels) || !(pixels > 0.0))
      return unmeasurable("its triangles have no extent in the world, or an infinite one");
    return TileSize{object.front().instance.node, object.size(), metres.value(), pixels};
  }

private:
  [[nodiscard]] GltfScene& scene() const { return reader_.scene(); }

  [[nodiscard]] Error unmeasurable(const char* reason) const {
    return {ErrorKind::badInput,
            scene().path().string() + ": " + scene().materialTitle(material_) + ": " + reason};
  }

  /// The nodes that have the material. Reads each mesh once.
  Result<std::vector<Wearer>> wearers() {
    std::map<std::size_t, Box> boxes; // by mesh
    std::optional<Error> first;
    for (const PrimitivePlace place : scene().primitivesOf(material_)) {
      if (!instancesOf_.contains(place.mesh))
        continue;
      const Result<PrimitiveGeometry> geometry = reader_.geometry(place);
      if (!geometry && !first)
        first = geometry.error();
      if (geometry)
        for (const std::uint32_t index : geometry.value().triangles)
          boxes[place.mesh].extend(pointOf(geometry.value().positions[index]));
    }
    std::vector<Wearer> found;
    for (const auto& [mesh, box] : boxes)
      for (const MeshInstance& instance : instancesOf_.at(mesh)) {
        if (Result<void> within = reader_.spend(1); !within)
          return within.error();
        found.push_back({instance, boxOf(cornersOf(box, instance.worldFromMesh))});
      }
    if (found.empty())
      return first ? *first : unmeasurable("no node of the scene shows triangles with it");
    return found;
  }

  /// Calls visit(place, geometry) for each part of a mesh that has the material and can be read.
  template <class Visit>
  void visitParts(std::size_t mesh, const Visit& visit) {
    for (const PrimitivePlace place : scene().primitivesOf(material_))
      if (place.mesh == mesh)
        if (const Result<PrimitiveGeometry> geometry = reader_.geometry(place); geometry)
          visit(place, geometry.value());
  }

  /// The radius in metres of the sphere about the centre of a node's bounding box.
  double radiusOf(const Wearer& wearer) {
    std::vector<Eigen::Vector3d> points;
    visitParts(wearer.instance.mesh, [&](PrimitivePlace, const PrimitiveGeometry& geometry) {
      std::vector<bool> isUsed(geometry.positions.size(), false);
      for (const std::uint32_t index : geometry.triangles) {
        if (!isUsed[index])
          points.push_back(wearer.instance.worldFromMesh * pointOf(geometry.positions[index]));
        isUsed[index] = true;
      }
    });
    return radiusOf(points);
  }

  /// The same of several nodes; the sphere encloses their boxes.
  static double radiusOf(const std::vector<Wearer>& object) {
    std::vector<Eigen::Vector3d> corners;
    for (const Wearer& wearer : object)
      for (const Eigen::Vector3d& corner : cornersOf(wearer.world, Eigen::Affine3d::Identity()))
        corners.push_back(corner);
    return radiusOf(corners);
  }

  static double radiusOf(const std::vector<Eigen::Vector3d>& points) {
    const Eigen::Vector3d center = boxOf(points).center();
    double radius = 0.0;
    for (const Eigen::Vector3d& point : points)
      radius = std::max(radius, (point - center).norm());
    return radius;
  }

  /// The width in metres of a tile on one node.
  Result<double> tileMetres(const MeshInstance& instance) {
    if (!isInSpace(use_.mapping)) {
      const Result<double> perUnit = metresPerTexCoord(instance);
      return perUnit ? Result<double>(perUnit.value() * use_.scale) : perUnit.error();
    }
    const double metres = use_.scale * noise_.tileSizeMetres;
    if (use_.space == NoiseSpace::world)
      return metres;
    return metres * std::cbrt(std::abs(instance.worldFromMesh.linear().determinant()));
  }

  /// Metres per unit of texture coordinates, the median over the area.
  Result<double> metresPerTexCoord(const MeshInstance& instance) {
    std::vector<std::pair<double, double>> triangles; // metres per unit, and area
    visitParts(instance.mesh, [&](PrimitivePlace place, const PrimitiveGeometry& geometry) {
      const std::string attribute = "TEXCOORD_" + std::to_string(use_.texCoord);
      if (!scene().attribute(place, attribute))
        return;
      const auto texCoords = scene().vectors2(place, attribute);
      if (texCoords && texCoords.value().size() == geometry.positions.size())
        addTriangles(instance.worldFromMesh, geometry, texCoords.value(), triangles);
    });
    if (triangles.empty())
      return unmeasurable("its texture coordinates have no area, so the noise does not vary");
    std::sort(triangles.begin(), triangles.end());
    double total = 0.0, below = 0.0;
    for (const auto& [perUnit, area] : triangles)
      total += area;
    return std::find_if(
               triangles.begin(), triangles.end() - 1,
               [&](const auto& triangle) { return (below += triangle.second) >= 0.5 * total; })
        ->first;
  }

  /// Adds the triangles that have an area in the world and in texture coordinates.
  static void addTriangles(const Eigen::Affine3d& worldFromMesh, const PrimitiveGeometry& geometry,
                           const std::vector<std::array<float, 2>>& texCoords,
                           std::vector<std::pair<double, double>>& triangles) {
    for (std::size_t t = 0; t + 2 < geometry.triangles.size(); t += 3) {
      std::array<Eigen::Vector3d, 3> p;
      std::array<Eigen::Vector2d, 3> uv;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = geometry.triangles[t + k];
        p[k] = worldFromMesh * pointOf(geometry.positions[vertex]);
        uv[k] = {texCoords[vertex][0], texCoords[vertex][1]};
      }
      const double area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
      const Eigen::Vector2d u = uv[1] - uv[0], v = uv[2] - uv[0];
      const double texArea = std::abs(u.x() * v.y() - u.y() * v.x());
      if (area > 0.0 && texArea > 0.0)
        triangles.emplace_back(std::sqrt(area / texArea), area);
    }
  }

  MeshReader& reader_;
  const InstancesOf& instancesOf_;
  std::size_t material_;
  const Noise& noise_;
  const MaterialNoise& use_;
};

} // namespace

std::vector<Result<TileSize>> measureTiles(GltfScene& scene, std::span<const std::size_t> materials,
                                           const Noise& noise, const MaterialNoise& use) {
  InstancesOf instancesOf;
  for (MeshInstance& instance : meshInstances(scene))
    instancesOf[instance.mesh].push_back(std::move(instance));
  MeshReader reader(scene);
  std::vector<Result<TileSize>> sizes;
  for (const std::size_t material : materials)
    sizes.push_back(withinMemory(
        [&] { return scene.path().string() + ": not enough memory to measure a tile"; },
        [&] { return TileMeasure(reader, instancesOf, material, noise, use).run(); }));
  return sizes;
}

} // namespace lichen
