// SPDX-License-Identifier: MIT
// Linear blending of morph targets and joints [glTF 2.0, sections 3.7.2.2 and 3.7.3].
#include "rest_pose.h"

#include "directions.h"

#include <algorithm>
#include <cmath>

namespace lichen::renderer {
namespace {

/// Number of targets with a weight that the primitive has.
std::size_t targetCount(const SourcePrimitive& source, const RestPose& pose) {
  return std::min(pose.morphWeights.size(), source.place.countOf("targets"));
}

void applyMorphs(SceneFile& file, const SourcePrimitive& source, const RestPose& pose,
                 std::vector<Vertex>& vertices) {
  for (std::size_t t = 0; t < targetCount(source, pose); ++t) {
    const auto weight = float(pose.morphWeights[t]);
    if (pose.morphWeights[t] == 0.0)
      continue;
    const Place morphTarget = source.place.member("targets").at(t);
    const auto add = [&](const char* name, const auto& assign) {
      if (const std::optional<Place> deltas = morphTarget.find(name)) {
        const auto values = file.vectors<3>(*deltas, vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i)
          assign(vertices[i], weight * glm::make_vec3(values[i].data()));
      }
    };
    add("POSITION", [](Vertex& v, glm::vec3 delta) { v.position += delta; });
    add("NORMAL", [](Vertex& v, glm::vec3 delta) { v.normal += delta; });
    add("TANGENT", [](Vertex& v, glm::vec3 delta) { v.tangent += glm::vec4(delta, 0.0f); });
  }
}

/// Weighted sum of joint matrices per vertex.
struct BlendedJoints {
  std::vector<glm::mat4> sums;
  std::vector<float> weights; ///< sum of the weights
};

/// Accessors of one attribute set: joints and their weights.
std::optional<std::pair<Place, Place>> jointSet(const SourcePrimitive& source, std::size_t set) {
  const auto joints = source.attributes.find(("JOINTS_" + std::to_string(set)).c_str());
  const auto weights = source.attributes.find(("WEIGHTS_" + std::to_string(set)).c_str());
  return joints && weights ? std::optional(std::pair(*joints, *weights)) : std::nullopt;
}

/// Adds one attribute set: four joints per vertex.
void addJoints(SceneFile& file, const std::pair<Place, Place>& set,
               std::span<const glm::mat4> matrices, BlendedJoints& blended) {
  const std::size_t count = blended.sums.size();
  const auto joints = file.vectors<4>(set.first, count, {kUnsignedByte, kUnsignedShort});
  const auto weights = file.vectors<4>(set.second, count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto joint = std::size_t(joints[i][k]); // 8 or 16 bits, exact as a float
      if (weights[i][k] == 0.0f)
        continue;
      if (joint >= matrices.size())
        set.first.fail("joint " + std::to_string(joint) + " is not in the skin; expected 0 to " +
                       std::to_string(matrices.size() - 1));
      blended.sums[i] += weights[i][k] * matrices[joint];
      blended.weights[i] += weights[i][k];
    }
}

BlendedJoints blendJoints(SceneFile& file, const SourcePrimitive& source,
                          std::span<const glm::mat4> joints, std::size_t vertexCount) {
  BlendedJoints blended{std::vector<glm::mat4>(vertexCount, glm::mat4(0.0f)),
                        std::vector<float>(vertexCount, 0.0f)};
  for (std::size_t set = 0; const auto accessors = jointSet(source, set); ++set)
    addJoints(file, *accessors, joints, blended);
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

void applySkin(SceneFile& file, const SourcePrimitive& source, std::span<const glm::mat4> joints,
               Primitive& target) {
  const BlendedJoints blended = blendJoints(file, source, joints, target.vertices.size());
  for (std::size_t i = 0; i < target.undeformed.size(); ++i)
    target.undeformed[i].normal *= stretchAlong(target.vertices[i].normal, blended.sums[i]);
  std::vector<bool> mirrored(target.vertices.size());
  for (std::size_t i = 0; i < target.vertices.size(); ++i)
    mirrored[i] = transformVertex(target.vertices[i], blended.sums[i]);
  for (std::size_t i = 0; i < target.indices.size(); i += 3)
    if (mirrored[target.indices[i]])
      std::swap(target.indices[i + 1], target.indices[i + 2]);
}

} // namespace

bool deforms(const RestPose& pose) {
  return !pose.jointMatrices.empty() ||
         std::any_of(pose.morphWeights.begin(), pose.morphWeights.end(),
                     [](double weight) { return weight != 0.0; });
}

std::size_t restPosePasses(const SourcePrimitive& source, const RestPose& pose) {
  std::size_t passes = 0;
  for (std::size_t t = 0; t < targetCount(source, pose); ++t)
    if (pose.morphWeights[t] != 0.0)
      ++passes;
  if (!pose.jointMatrices.empty())
    for (std::size_t set = 0; jointSet(source, set); ++set)
      ++passes;
  return passes;
}

void applyRestPose(SceneFile& file, const SourcePrimitive& source, const RestPose& pose,
                   Primitive& target) {
  applyMorphs(file, source, pose, target.vertices);
  if (!pose.jointMatrices.empty())
    applySkin(file, source, pose.jointMatrices, target);
  for (Vertex& v : target.vertices) {
    v.normal = normalizedOr(v.normal, glm::vec3(0.0f, 1.0f, 0.0f));
    v.tangent = glm::vec4(normalizedOr(glm::vec3(v.tangent), frameAlong(v.normal)[0]), v.tangent.w);
    if (!std::isfinite(v.position.x) || !std::isfinite(v.position.y) ||
        !std::isfinite(v.position.z))
      throw Fault{"/meshes: the rest pose moves a vertex beyond what a float can hold"};
  }
}

} // namespace lichen::renderer
