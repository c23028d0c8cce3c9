// SPDX-License-Identifier: MIT
// Nodes -> instances, cameras and lights in the world [glTF 2.0, sections 3.5.3 and 3.10], and
// KHR_lights_punctual.
#include "node_walk.h"

#include "camera_load.h"
#include "directions.h"
#include "geometry.h"
#include "printable.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <set>

namespace lichen::renderer {
namespace {

glm::dmat4 localMatrix(const Place& node) {
  if (node.find("matrix"))
    return node.vector("matrix", glm::dmat4(1.0));
  const auto scale = node.vector("scale", glm::dvec3(1.0));
  const auto rotation = node.vector("rotation", glm::dvec4(0, 0, 0, 1), -1, 1);
  const glm::dquat q{rotation.w, rotation.x, rotation.y, rotation.z};
  glm::dmat4 matrix = glm::length(q) > 0.0 ? glm::mat4_cast(glm::normalize(q)) : glm::dmat4(1.0);
  for (int i = 0; i < 3; ++i)
    matrix[i] *= scale[i];
  matrix[3] = glm::dvec4(node.vector("translation", glm::dvec3(0.0)), 1.0);
  return matrix;
}

/// Position and rotation of a node without its scale, which cameras and lights ignore.
glm::dmat4 rigid(const glm::dmat4& m) {
  const auto back = glm::dvec3(m[2]);
  const glm::dvec3 z = glm::length(back) > 0.0 ? glm::normalize(back) : glm::dvec3(0, 0, 1);
  const glm::dvec3 up = glm::dvec3(m[1]) - z * glm::dot(z, glm::dvec3(m[1]));
  const glm::dvec3 y =
      glm::length(up) > 0.0 ? glm::normalize(up) : glm::dvec3(frameAlong(glm::vec3(z))[1]);
  return glm::dmat4(glm::dvec4(glm::cross(y, z), 0), glm::dvec4(y, 0), glm::dvec4(z, 0), m[3]);
}

Light readLight(const Place& source, const glm::dmat4& world) {
  Light light;
  const glm::dmat4 frame = rigid(world);
  (void)source.member("type");
  const std::string type = source.oneOf("type", {"directional", "point", "spot"});
  if (type != "directional")
    light.kind = type == "point" ? LightKind::point : LightKind::spot;
  light.color = source.vector("color", light.color, 0);
  light.intensity = float(source.number("intensity", 1, 0));
  light.range = float(source.number("range", 0, 0));
  light.position = glm::dvec3(frame[3]);
  light.direction = -glm::vec3(frame[2]);
  const double right = glm::half_pi<double>();
  double outer = right / 2, inner = 0;
  if (const std::optional<Place> spot = source.find("spot")) {
    outer = spot->number("outerConeAngle", outer, 0, std::nextafter(float(right), 2.0f));
    inner = spot->number("innerConeAngle", inner, 0, outer);
  }
  light.innerConeCosine = float(std::cos(inner));
  light.outerConeCosine = float(std::cos(outer));
  return light;
}

/// Whether a node or a mesh gives a morph target a weight.
bool morphs(const Place& place) {
  bool any = false;
  place.each("weights",
             [&](const Place& weight, std::size_t) { any = any || weight.asNumber() != 0.0; });
  return any;
}

/// Throws a Fault unless the nodes form trees, which scenes list by their roots.
void checkHierarchy(const SceneFile& file) {
  const std::size_t count = file.root().countOf("nodes");
  std::vector<std::size_t> parents(count, count);
  file.root().each("nodes", [&](const Place& node, std::size_t index) {
    node.each("children", [&](const Place& child, std::size_t) {
      const std::size_t c = child.asIndex(count);
      if (parents[c] != count)
        child.fail("node " + std::to_string(c) + " is already a child of node " +
                   std::to_string(parents[c]) + "; a node may have only one parent");
      parents[c] = index;
    });
  });
  // Each node has at most one parent, so a cycle is a chain of parents without end.
  std::vector<bool> reachesRoot(count, false);
  for (std::size_t start = 0; start < count; ++start) {
    std::vector<std::size_t> chain;
    for (std::size_t at = start; at != count && !reachesRoot[at]; at = parents[at]) {
      if (chain.size() == count)
        file.root().member("nodes").fail("node " + std::to_string(start) +
                                         " is its own ancestor; nodes must not form cycles");
      chain.push_back(at);
    }
    for (const std::size_t done : chain)
      reachesRoot[done] = true;
  }
  file.root().each("scenes", [&](const Place& scene, std::size_t) {
    std::set<std::size_t> listed;
    scene.each("nodes", [&](const Place& entry, std::size_t) {
      const std::size_t node = entry.asIndex(count);
      if (parents[node] != count)
        entry.fail("node " + std::to_string(node) + " is a child of node " +
                   std::to_string(parents[node]) + "; scenes may list only root nodes");
      if (!listed.insert(node).second)
        entry.fail("node " + std::to_string(node) + " appears twice");
    });
  });
}

/// Walks the default scene's nodes with an explicit stack, so that deep hierarchies cannot overflow
/// the call stack.
class NodeWalk {
public:
  NodeWalk(SceneFile& file, Scene& scene)
      : file_(file), scene_(scene), lights_(file.root().extension("KHR_lights_punctual")),
        primitivesOfMesh_(file.root().countOf("meshes")),
        worldOfNode_(file.root().countOf("nodes")) {}

  void run() {
    checkHierarchy(file_);
    const std::optional<Place> chosen = file_.follow(file_.root(), "scene", "scenes");
    if (file_.root().countOf("scenes") == 0)
      throw Fault{"has no scene; add a scene with a mesh"};
    push(chosen ? *chosen : file_.element("scenes", 0), "nodes", glm::dmat4(1.0));
    while (!pending_.empty()) {
      const auto [index, parent] = pending_.back();
      pending_.pop_back();
      visit(index, parent);
    }
    for (const std::size_t node : skinnedNodes_) // after the transforms of all joints are known
      addSkinned(file_.element("nodes", node));
    if (scene_.instances.empty())
      throw Fault{"its scene has nothing to draw; add a mesh with triangles"};
    if (morphs_)
      scene_.notes.push_back("morph targets are ignored; meshes are drawn as they are stored");
  }

private:
  void visit(std::size_t index, const glm::dmat4& parent) {
    const Place node = file_.element("nodes", index);
    const glm::dmat4 world = parent * localMatrix(node);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        if (!(std::abs(world[column][row]) <= kLargest)) // also true for NaN
          throw Fault{"/nodes: the transform of node \"" +
                      printable(node.string("name").value_or("")) + "\" is not finite"};
    if (const std::optional<Place> camera = file_.follow(node, "camera", "cameras")) {
      scene_.cameras.push_back(readCamera(*camera, rigid(world), scene_.notes));
      scene_.cameras.back().nodeName = node.string("name").value_or("");
    }
    const std::optional<std::size_t> light =
        node.extension("KHR_lights_punctual").index("light", lights_.countOf("lights"));
    if (light)
      scene_.lights.push_back(readLight(lights_.member("lights").at(*light), world));
    worldOfNode_[index] = world;
    const std::optional<std::size_t> mesh = file_.index(node, "mesh", "meshes");
    if (mesh)
      morphs_ = morphs_ || morphs(node) || morphs(file_.element("meshes", *mesh));
    if (mesh && file_.index(node, "skin", "skins"))
      skinnedNodes_.push_back(index);
    else if (mesh)
      addMesh(*mesh, world);
    push(node, "children", world);
  }

  /// Pushes nodes so that the first one is visited next.
  void push(const Place& owner, const char* key, const glm::dmat4& parent) {
    const std::size_t first = pending_.size();
    owner.each(key, [&](const Place& node, std::size_t) {
      pending_.push_back({node.asIndex(worldOfNode_.size()), parent});
    });
    std::reverse(pending_.begin() + std::ptrdiff_t(first), pending_.end());
  }

  /// A skinned mesh ignores its own node's transform and is drawn in its bind pose, in which all of
  /// its joints move it alike: where its first joint puts it.
  void addSkinned(const Place& node) {
    const Place skin = *file_.follow(node, "skin", "skins");
    const Place joints = skin.member("joints");
    if (skin.countOf("joints") == 0)
      joints.fail("is empty; expected the nodes that move the mesh");
    const Place joint = joints.at(0);
    const std::size_t index = joint.asIndex(worldOfNode_.size());
    if (!worldOfNode_[index])
      joint.fail("node " + std::to_string(index) +
                 " is not in the scene to draw; joints must be in the same scene as their mesh");
    glm::dmat4 fromBind(1.0);
    if (const std::optional<Place> accessor = skin.find("inverseBindMatrices")) {
      const std::size_t count = file_.countOf(*accessor);
      charge(count);
      fromBind = glm::make_mat4(file_.vectors<16>(*accessor, count, {kFloat}).at(0).data());
    }
    addMesh(*file_.index(node, "mesh", "meshes"), *worldOfNode_[index] * fromBind);
  }

  void addMesh(std::size_t mesh, const glm::dmat4& world) {
    if (!primitivesOfMesh_[mesh])
      primitivesOfMesh_[mesh] = loadMesh(mesh);
    addInstances(*primitivesOfMesh_[mesh], world);
  }

  [[noreturn]] static void failTooManyInstances() {
    throw Fault{"/nodes: the scene draws more than " + std::to_string(kMaxSceneInstances) +
                    " primitives, or " + std::to_string(kMaxDrawnVertices) +
                    " vertices and indices; use a smaller scene",
                ErrorKind::resources};
  }

  void addInstances(const std::vector<std::size_t>& primitives, const glm::dmat4& world) {
    for (const std::size_t primitive : primitives) {
      const Primitive& p = scene_.primitives[primitive];
      drawn_ += p.vertices.size() + p.indices.size();
      if (scene_.instances.size() == kMaxSceneInstances || drawn_ > kMaxDrawnVertices)
        failTooManyInstances();
      scene_.instances.push_back({primitive, world});
    }
  }

  /// Appends a mesh's primitives to the scene and returns their indices.
  std::vector<std::size_t> loadMesh(std::size_t index) {
    const Place mesh = file_.element("meshes", index);
    (void)mesh.member("primitives");
    std::vector<std::size_t> primitives;
    mesh.each("primitives", [&](const Place& place, std::size_t) {
      if (++loaded_ > kMaxSceneInstances)
        failTooManyInstances();
      const SourcePrimitive source = sourcePrimitive(file_, place);
      std::optional<Primitive> primitive = loadPrimitive(source);
      if (!primitive) {
        scene_.notes.push_back("a primitive of mesh " + std::to_string(index) +
                               " without triangles is ignored");
        return;
      }
      noteMissingTangents(mesh, source, scene_.materials[primitive->material]);
      primitives.push_back(scene_.primitives.size());
      scene_.primitives.push_back(std::move(*primitive));
    });
    return primitives;
  }

  void noteMissingTangents(const Place& mesh, const SourcePrimitive& source,
                           const Material& material) {
    if (material.noiseNeedsTangents && !source.attributes.find("TANGENT"))
      scene_.notes.push_back(
          mesh.pointer() + " \"" + printable(mesh.string("name").value_or("")) +
          "\" has no TANGENT attribute, which the noise of its material \"" +
          printable(material.name) +
          "\" follows; an arbitrary direction is used; add tangents with lichen apply");
  }

  /// Counts vertices, indices and matrices of joints before they are read.
  void charge(std::size_t count) {
    vertices_ += count;
    if (vertices_ > kMaxSceneVertices)
      throw Fault{"/meshes: more than " + std::to_string(kMaxSceneVertices) +
                      " vertices and indices; use a smaller scene",
                  ErrorKind::resources};
  }

  std::optional<Primitive> loadPrimitive(const SourcePrimitive& source) {
    const std::size_t material =
        file_.index(source.place, "material", "materials").value_or(scene_.materials.size() - 1);
    charge(expandedSize(source));
    std::optional<Primitive> primitive = readPrimitive(file_, source, scene_.materials[material]);
    if (primitive)
      primitive->material = material;
    return primitive;
  }

  struct Pending {
    std::size_t node;
    glm::dmat4 parent;
  };
  SceneFile& file_;
  Scene& scene_;
  Place lights_; ///< the extension's object
  std::vector<std::optional<std::vector<std::size_t>>> primitivesOfMesh_;
  std::vector<std::optional<glm::dmat4>> worldOfNode_; ///< only for nodes of the scene
  std::vector<std::size_t> skinnedNodes_;
  bool morphs_ = false;
  std::size_t loaded_ = 0; ///< primitives
  std::vector<Pending> pending_;
  std::size_t vertices_ = 0; ///< charged so far
  std::size_t drawn_ = 0;    ///< vertices and indices of the instances so far
};

} // namespace

void walkNodes(SceneFile& file, Scene& scene) { NodeWalk(file, scene).run(); }

} // namespace lichen::renderer
