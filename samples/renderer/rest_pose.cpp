// SPDX-License-Identifier: MIT
// Linear blending of morph targets and joints [glTF 2.0, sections 3.7.2.2 and 3.7.3].
#include "rest_pose.h"

#include "accessor.h"
#include "orthonormal_frame.h"
#include "unit_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lichen::renderer {
namespace {

using Attributes = std::map<std::string, int>;

/// Calls `add(vertex, delta)` for each vertex with the weighted delta of a morph target's
/// attribute; does nothing if the target lacks the attribute.
template <class Add>
Result<void> addDeltas(const tinygltf::Model& model, const Attributes& morphTarget,
                       const char* name, float weight, std::vector<Vertex>& vertices, Add add) {
  const auto found = morphTarget.find(name);
  if (found == morphTarget.end())
    return {};
  const Result<std::vector<float>> deltas = readAccessor(model, found->second);
  if (!deltas)
    return deltas.error();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const float* delta = deltas.value().data() + 3 * i;
    add(vertices[i], weight * glm::vec3(delta[0], delta[1], delta[2]));
  }
  return {};
}

Result<void> applyMorphs(const tinygltf::Model& model, const tinygltf::Primitive& source,
                         std::span<const double> weights, std::vector<Vertex>& vertices) {
  for (std::size_t t = 0; t < std::min(weights.size(), source.targets.size()); ++t) {
    if (weights[t] == 0.0)
      continue;
    const auto add = [&](const char* name, auto assign) {
      return addDeltas(model, source.targets[t], name, float(weights[t]), vertices, assign);
    };
    const std::array added{
        add("POSITION", [](Vertex& v, glm::vec3 delta) { v.position += delta; }),
        add("NORMAL", [](Vertex& v, glm::vec3 delta) { v.normal += delta; }),
        add("TANGENT", [](Vertex& v, glm::vec3 delta) { v.tangent += glm::vec4(delta, 0.0f); })};
    for (const Result<void>& result : added)
      if (!result)
        return result;
  }
  return {};
}

/// Weighted sum of joint matrices per vertex.
struct BlendedJoints {
  std::vector<glm::mat4> sums;
  std::vector<float> weights; ///< sum of the weights
};

/// Adds one attribute set: four joints per vertex.
Result<void> addJoints(const tinygltf::Model& model, int jointsAccessor, int weightsAccessor,
                       std::span<const glm::mat4> joints, BlendedJoints& blended) {
  const Result<std::vector<float>> indices = readAccessor(model, jointsAccessor);
  if (!indices)
    return indices.error();
  const Result<std::vector<float>> weights = readAccessor(model, weightsAccessor);
  if (!weights)
    return weights.error();
  for (std::size_t k = 0; k < indices.value().size(); ++k) {
    const float weight = weights.value()[k];
    if (weight == 0.0f)
      continue;
    const auto joint = std::size_t(indices.value()[k]); // 8 or 16 bits, exact as a float
    if (joint >= joints.size())
      return Error{ErrorKind::badInput, "/accessors/" + std::to_string(jointsAccessor) +
                                            ": joint " + std::to_string(joint) +
                                            " is not in the skin; expected 0 to " +
                                            std::to_string(joints.size() - 1)};
    blended.sums[k / 4] += weight * joints[joint];
    blended.weights[k / 4] += weight;
  }
  return {};
}

/// Accessors of one attribute set: joints and their weights.
std::optional<std::pair<int, int>> jointSet(const tinygltf::Primitive& source, std::size_t set) {
  const auto joints = source.attributes.find("JOINTS_" + std::to_string(set));
  const auto weights = source.attributes.find("WEIGHTS_" + std::to_string(set));
  if (joints == source.attributes.end() || weights == source.attributes.end())
    return std::nullopt;
  return std::make_pair(joints->second, weights->second);
}

Result<BlendedJoints> blendJoints(const tinygltf::Model& model, const tinygltf::Primitive& source,
                                  std::span<const glm::mat4> joints, std::size_t vertexCount) {
  BlendedJoints blended{std::vector<glm::mat4>(vertexCount, glm::mat4(0.0f)),
                        std::vector<float>(vertexCount, 0.0f)};
  for (std::size_t set = 0; const auto accessors = jointSet(source, set); ++set)
    if (Result<void> added = addJoints(model, accessors->first, accessors->second, joints, blended);
        !added)
      return added.error();
  // Normalise the weights to a sum of 1. Vertices without weights follow the first joint.
  for (std::size_t i = 0; i < vertexCount; ++i)
    blended.sums[i] =
        blended.weights[i] > 0.0f ? blended.sums[i] / blended.weights[i] : joints.front();
  return blended;
}

/// Factor by which `matrix` stretches space along a unit normal; same as in
/// shaders/world_frame.glsl.
float stretchAlong(glm::vec3 normal, const glm::mat4& matrix) {
  const glm::mat3 linear(matrix);
  const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const float area = glm::length(cofactors * normal);
  return area > 0.0f ? std::abs(glm::dot(linear[0], cofactors[0])) / area : 0.0f;
}

/// Same transform as in shaders/world_frame.glsl. Returns whether the matrix mirrors.
bool transformVertex(Vertex& v, const glm::mat4& matrix) {
  const glm::mat3 linear(matrix);
  const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const bool mirrors = glm::dot(linear[0], cofactors[0]) < 0.0f;
  const float side = mirrors ? -1.0f : 1.0f;
  v.position = glm::vec3(matrix * glm::vec4(v.position, 1.0f));
  v.normal = side * (cofactors * v.normal);
  v.tangent = glm::vec4(linear * glm::vec3(v.tangent), side * v.tangent.w);
  return mirrors;
}

Result<void> applySkin(const tinygltf::Model& model, const tinygltf::Primitive& source,
                       std::span<const glm::mat4> joints, Primitive& target) {
  const Result<BlendedJoints> blended = blendJoints(model, source, joints, target.vertices.size());
  if (!blended)
    return blended.error();
  for (std::size_t i = 0; i < target.undeformed.size(); ++i)
    target.undeformed[i].normal *= stretchAlong(target.vertices[i].normal, blended.value().sums[i]);
  std::vector<bool> mirrored(target.vertices.size());
  for (std::size_t i = 0; i < target.vertices.size(); ++i)
    mirrored[i] = transformVertex(target.vertices[i], blended.value().sums[i]);
  for (std::size_t i = 0; i < target.indices.size(); i += 3)
    if (mirrored[target.indices[i]])
      std::swap(target.indices[i + 1], target.indices[i + 2]);
  return {};
}

} // namespace

bool deforms(const RestPose& pose) {
  return !pose.jointMatrices.empty() ||
         std::any_of(pose.morphWeights.begin(), pose.morphWeights.end(),
                     [](double weight) { return weight != 0.0; });
}

std::size_t restPosePasses(const tinygltf::Primitive& source, const RestPose& pose) {
  std::size_t passes = 0;
  for (std::size_t t = 0; t < std::min(pose.morphWeights.size(), source.targets.size()); ++t)
    if (pose.morphWeights[t] != 0.0)
      ++passes;
  if (!pose.jointMatrices.empty())
    for (std::size_t set = 0; jointSet(source, set); ++set)
      ++passes;
  return passes;
}

Result<void> applyRestPose(const tinygltf::Model& model, const tinygltf::Primitive& source,
                           const RestPose& pose, Primitive& target) {
  if (Result<void> morphed = applyMorphs(model, source, pose.morphWeights, target.vertices);
      !morphed)
    return morphed;
  if (!pose.jointMatrices.empty())
    if (Result<void> skinned = applySkin(model, source, pose.jointMatrices, target); !skinned)
      return skinned;
  for (Vertex& v : target.vertices) {
    v.normal = normalizedOr(v.normal, glm::vec3(0.0f, 1.0f, 0.0f));
    v.tangent = glm::vec4(normalizedOr(glm::vec3(v.tangent), frameAlong(v.normal)[0]), v.tangent.w);
    if (!std::isfinite(v.position.x) || !std::isfinite(v.position.y) ||
        !std::isfinite(v.position.z))
      return Error{ErrorKind::badInput,
                   "/meshes: the rest pose moves a vertex beyond what a float can hold"};
  }
  return {};
}

} // namespace lichen::renderer
