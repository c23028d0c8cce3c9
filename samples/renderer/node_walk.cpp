// SPDX-License-Identifier: MIT
// Nodes -> instances, cameras and lights in the world [glTF 2.0, sections 3.5.3 and 3.10], and
// KHR_lights_punctual.
#include "node_walk.h"

#include "accessor.h"
#include "camera_load.h"
#include "geometry.h"
#include "orthonormal_frame.h"
#include "printable.h"
#include "relative_to.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace lichen::renderer {
namespace {

constexpr std::size_t kMatrix = 16; // numbers in a 4 x 4 matrix
constexpr double kLargest = std::numeric_limits<float>::max();

glm::dmat4 localMatrix(const tinygltf::Node& node) {
  if (node.matrix.size() == kMatrix) {
    return glm::make_mat4(node.matrix.data());
  }
  const auto vec3 = [](const std::vector<double>& v, glm::dvec3 absent) {
    return v.size() == 3 ? glm::dvec3(v[0], v[1], v[2]) : absent;
  };
  const glm::dvec3 scale = vec3(node.scale, glm::dvec3(1.0));
  glm::dmat4 matrix(1.0);
  if (node.rotation.size() == 4) {
    const glm::dquat q{node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]};
    if (glm::length(q) > 0.0)
      matrix = glm::mat4_cast(glm::normalize(q));
  }
  for (int i = 0; i < 3; ++i)
    matrix[i] *= scale[i];
  matrix[3] = glm::dvec4(vec3(node.translation, glm::dvec3(0.0)), 1.0);
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

Light readLight(const tinygltf::Light& source, const glm::dmat4& world) {
  Light light;
  const glm::dmat4 frame = rigid(world);
  if (source.type == "point")
    light.kind = LightKind::point;
  else if (source.type == "spot")
    light.kind = LightKind::spot;
  if (source.color.size() == 3)
    light.color = glm::vec3(source.color[0], source.color[1], source.color[2]);
  light.intensity = float(source.intensity);
  light.range = float(source.range);
  light.position = glm::dvec3(frame[3]);
  light.direction = -glm::vec3(frame[2]);
  light.innerConeCosine = float(std::cos(source.spot.innerConeAngle));
  light.outerConeCosine = float(std::cos(source.spot.outerConeAngle));
  return light;
}

/// Walks the default scene's nodes with an explicit stack, so that deep hierarchies cannot overflow
/// the call stack.
class NodeWalk {
public:
  NodeWalk(const tinygltf::Model& model, Scene& scene)
      : model_(model), scene_(scene), primitivesOfMesh_(model.meshes.size()),
        worldOfNode_(model.nodes.size()), jointsOfSkin_(model.skins.size()) {}

  Result<void> run() {
    if (model_.scenes.empty())
      return Error{ErrorKind::badInput, "has no scene; add a scene with a mesh"};
    const int chosen = model_.defaultScene >= 0 ? model_.defaultScene : 0;
    push(model_.scenes[std::size_t(chosen)].nodes, glm::dmat4(1.0));
    while (!pending_.empty()) {
      const auto [index, parent] = pending_.back();
      pending_.pop_back();
      if (Result<void> visited = visit(std::size_t(index), parent); !visited)
        return visited;
    }
    for (const std::size_t node : skinnedNodes_) // after the transforms of all joints are known
      if (Result<void> added = addSkinned(model_.nodes[node]); !added)
        return added;
    if (scene_.instances.empty())
      return Error{ErrorKind::badInput,
                   "its scene has nothing to draw; add a mesh with triangles, lines or points"};
    return {};
  }

private:
  Result<void> visit(std::size_t index, const glm::dmat4& parent) {
    const tinygltf::Node& node = model_.nodes[index];
    const glm::dmat4 world = parent * localMatrix(node);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        if (!(std::abs(world[column][row]) <= kLargest)) // also true for NaN
          return Error{ErrorKind::badInput, "/nodes: the transform of node \"" +
                                                printable(node.name) + "\" is not finite"};
    if (node.camera >= 0)
      addCamera(node, world);
    if (const auto light = node.extensions.find("KHR_lights_punctual");
        light != node.extensions.end() && light->second.Has("light"))
      scene_.lights.push_back(readLight(
          model_.lights[std::size_t(light->second.Get("light").GetNumberAsInt())], world));
    worldOfNode_[index] = world;
    if (node.mesh >= 0 && node.skin >= 0)
      skinnedNodes_.push_back(index);
    else if (node.mesh >= 0)
      if (Result<void> added = addMesh(node, world, restPose(node)); !added)
        return added;
    push(node.children, world);
    return {};
  }

  /// The pose of a node's morph targets, without a skin.
  [[nodiscard]] RestPose restPose(const tinygltf::Node& node) const {
    const std::vector<double>& ofMesh = model_.meshes[std::size_t(node.mesh)].weights;
    return {node.weights.empty() ? std::span(ofMesh) : std::span(node.weights), {}};
  }

  /// Pushes nodes so that the first one is visited next.
  void push(const std::vector<int>& nodes, const glm::dmat4& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
      pending_.push_back({*node, parent});
  }

  void addCamera(const tinygltf::Node& node, const glm::dmat4& world) {
    Camera camera = readCamera(model_, std::size_t(node.camera), rigid(world));
    camera.nodeName = node.name;
    scene_.cameras.push_back(std::move(camera));
  }

  /// A skinned mesh follows its joints and ignores its own node's transform.
  Result<void> addSkinned(const tinygltf::Node& node) {
    const auto skin = std::size_t(node.skin);
    if (!jointsOfSkin_[skin]) {
      Result<Joints> joints = loadJoints(skin);
      if (!joints)
        return joints.error();
      jointsOfSkin_[skin] = std::move(joints).value();
    }
    RestPose pose = restPose(node);
    pose.jointMatrices = jointsOfSkin_[skin]->matrices;
    return addMesh(node, glm::translate(glm::dmat4(1.0), jointsOfSkin_[skin]->origin), pose);
  }

  /// Joint matrices of a skin, from the bind pose to the rest pose, relative to `origin` in the
  /// world.
  struct Joints {
    glm::dvec3 origin{0.0};
    std::vector<glm::mat4> matrices;
  };

  Result<Joints> loadJoints(std::size_t index) const {
    const tinygltf::Skin& skin = model_.skins[index];
    std::vector<float> inverseBind;
    if (skin.inverseBindMatrices >= 0) {
      Result<std::vector<float>> values = readAccessor(model_, skin.inverseBindMatrices);
      if (!values)
        return values.error();
      inverseBind = std::move(values).value();
    }
    std::vector<glm::dmat4> joints;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const std::optional<glm::dmat4>& joint = worldOfNode_[std::size_t(skin.joints[j])];
      if (!joint)
        return Error{ErrorKind::badInput,
                     "/skins/" + std::to_string(index) + "/joints/" + std::to_string(j) +
                         ": node " + std::to_string(skin.joints[j]) +
                         " is not in the scene to draw; joints must be in the same scene as their "
                         "mesh"};
      const glm::mat4 bind =
          inverseBind.empty() ? glm::mat4(1.0f) : glm::make_mat4(&inverseBind[kMatrix * j]);
      joints.push_back(*joint * glm::dmat4(bind));
    }
    return relativeJoints(glm::dvec3(joints.front()[3]), joints);
  }

  /// Places the joints relative to `origin`, so that vertices, which are floats, stay small.
  static Joints relativeJoints(const glm::dvec3& origin, const std::vector<glm::dmat4>& joints) {
    Joints result;
    if (glm::length(origin) < double(kMaxSceneReach)) // the loader rejects anything farther
      result.origin = origin;
    for (const glm::dmat4& joint : joints)
      result.matrices.push_back(relativeTo(result.origin, joint));
    return result;
  }

  /// Nodes share the primitives of a mesh, except nodes whose pose deforms it.
  Result<void> addMesh(const tinygltf::Node& node, const glm::dmat4& world, const RestPose& pose) {
    const auto mesh = std::size_t(node.mesh);
    if (deforms(pose)) {
      Result<std::vector<std::size_t>> own = loadMesh(mesh, pose);
      return own ? addInstances(own.value(), world) : own.error();
    }
    if (!primitivesOfMesh_[mesh]) {
      Result<std::vector<std::size_t>> shared = loadMesh(mesh, pose);
      if (!shared)
        return shared.error();
      primitivesOfMesh_[mesh] = std::move(shared).value();
    }
    return addInstances(*primitivesOfMesh_[mesh], world);
  }

  static Error tooManyInstances() {
    return Error{ErrorKind::resources, "/nodes: the scene draws more than " +
                                           std::to_string(kMaxSceneInstances) + " primitives, or " +
                                           std::to_string(kMaxDrawnVertices) +
                                           " vertices and indices; use a smaller scene"};
  }

  Result<void> addInstances(const std::vector<std::size_t>& primitives, const glm::dmat4& world) {
    for (const std::size_t primitive : primitives) {
      const Primitive& p = scene_.primitives[primitive];
      drawn_ += p.vertices.size() + p.indices.size();
      if (scene_.instances.size() == kMaxSceneInstances || drawn_ > kMaxDrawnVertices)
        return tooManyInstances();
      scene_.instances.push_back({primitive, world});
    }
    return {};
  }

  /// Appends a mesh's primitives to the scene and returns their indices.
  Result<std::vector<std::size_t>> loadMesh(std::size_t mesh, const RestPose& pose) {
    std::vector<std::size_t> primitives;
    for (const tinygltf::Primitive& source : model_.meshes[mesh].primitives) {
      if (++loaded_ > kMaxSceneInstances)
        return tooManyInstances();
      Result<std::optional<Primitive>> primitive = loadPrimitive(source, pose);
      if (!primitive)
        return primitive.error();
      if (!primitive.value()) {
        scene_.notes.push_back("a primitive of mesh " + std::to_string(mesh) +
                               " without triangles is ignored");
        continue;
      }
      noteMissingTangents(mesh, source, scene_.materials[primitive.value()->material]);
      primitives.push_back(scene_.primitives.size());
      scene_.primitives.push_back(std::move(*primitive.value()));
    }
    return primitives;
  }

  void noteMissingTangents(std::size_t mesh, const tinygltf::Primitive& source,
                           const Material& material) {
    // tangents can be generated for this texture
    const TextureSlot& normals = material.normalTexture;
    const bool makesTangents =
        normals.image && source.attributes.contains("TEXCOORD_" + std::to_string(normals.texCoord));
    if (material.noiseNeedsTangents && !makesTangents && !source.attributes.contains("TANGENT"))
      scene_.notes.push_back(
          "/meshes/" + std::to_string(mesh) + " \"" + printable(model_.meshes[mesh].name) +
          "\" has no TANGENT attribute, which the noise of its material \"" +
          printable(material.name) +
          "\" follows; an arbitrary direction is used; add tangents with lichen apply");
  }

  Result<std::optional<Primitive>> loadPrimitive(const tinygltf::Primitive& source,
                                                 const RestPose& pose) {
    const std::size_t material =
        source.material >= 0 ? std::size_t(source.material) : scene_.materials.size() - 1;
    vertices_ += expandedSize(model_, source, scene_.materials[material], pose);
    if (vertices_ > kMaxSceneVertices)
      return Error{ErrorKind::resources, "/meshes: more than " + std::to_string(kMaxSceneVertices) +
                                             " vertices and indices; use a smaller scene"};
    Result<std::optional<Primitive>> primitive =
        readPrimitive(model_, source, scene_.materials[material], pose);
    if (primitive && primitive.value())
      primitive.value()->material = material;
    return primitive;
  }

  struct Pending {
    int node;
    glm::dmat4 parent;
  };
  const tinygltf::Model& model_;
  Scene& scene_;
  /// not deformed by a pose
  std::vector<std::optional<std::vector<std::size_t>>> primitivesOfMesh_;
  std::vector<std::optional<glm::dmat4>> worldOfNode_; ///< only for nodes of the scene
  std::vector<std::size_t> skinnedNodes_;
  std::vector<std::optional<Joints>> jointsOfSkin_;
  std::size_t loaded_ = 0; ///< loaded primitives, once more for each node that deforms them
  std::vector<Pending> pending_;
  std::size_t vertices_ = 0; ///< vertices and indices of the primitives loaded so far
  std::size_t drawn_ = 0;    ///< vertices and indices of the instances so far
};

} // namespace

Result<void> walkNodes(const tinygltf::Model& model, Scene& scene) {
  return NodeWalk(model, scene).run();
}

} // namespace lichen::renderer
