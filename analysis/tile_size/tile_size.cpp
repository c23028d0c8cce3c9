// SPDX-License-Identifier: MIT
// The nodes with a material, and a noise -> the size of a tile in metres and pixels; see
// tile_size.h.
#include "mesh_instances.h"

#include <lichen/tile_size.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace lichen {
namespace {

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
