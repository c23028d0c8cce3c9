// SPDX-License-Identifier: MIT
// What a user is told about a scene that is drawn otherwise than they may expect.
#include "scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace lichen::renderer {
namespace {

// A vertex this many tiles from its node is rounded by half a texel of tiles of 512.
constexpr double kMostTilesFromNode = 16384.0;
// Of an exemplar's width: in fewer, its mips have next to no variation left.
constexpr double kFewestPixels = 4.0;

/// The farthest vertex from the origin of its mesh, of those that place the noise.
float reachOf(const Primitive& primitive, bool inObjectSpace) {
  float reach = 0.0f;
  const bool isUndeformed = inObjectSpace && !primitive.undeformed.empty();
  for (const Vertex& vertex : isUndeformed ? primitive.undeformed : primitive.vertices)
    reach = std::max(reach, glm::length(vertex.position));
  return reach;
}

/// The most that an instance's node stretches its mesh.
double scaleOf(const Instance& instance) {
  const glm::dmat4& world = instance.worldFromObject;
  return std::max({glm::length(world[0]), glm::length(world[1]), glm::length(world[2])});
}

} // namespace

/// Where vertices themselves are far from their node, in floats, no origin helps.
void SceneRenderer::noteCoarseVertices(std::vector<std::string>& notes) const {
  std::map<std::size_t, float> reaches; // of primitives
  std::set<std::size_t> noted;
  for (const Instance& instance : scene_.instances) {
    const std::size_t m = scene_.primitives[instance.primitive].material;
    const double side = noises_.tileSide(m);
    if (side == 0.0 || noted.contains(m))
      continue;
    const bool inObjectSpace = noises_.roles(m).inObjectSpace;
    const auto [known, isNew] = reaches.try_emplace(instance.primitive, 0.0f);
    if (isNew)
      known->second = reachOf(scene_.primitives[instance.primitive], inObjectSpace);
    const double scale = inObjectSpace ? 1.0 : scaleOf(instance);
    const double reach = scale * double(known->second);
    if (reach <= kMostTilesFromNode * side)
      continue;
    noted.insert(m);
    const double spacing =
        std::exp2(std::floor(std::log2(reach))) * double(std::numeric_limits<float>::epsilon());
    notes.push_back(fmt::format(
        "/materials/{}: vertices are {:.3g} units from their node, where floats are "
        "{:.2g} apart, in tiles of {:.2g}: its noise may be coarse there; vertices near "
        "their node are drawn fine wherever it is",
        m, reach, spacing, side));
  }
}

/// Of a noise that lies in space, as the camera stands.
void SceneRenderer::noteUnseenNoise(std::vector<std::string>& notes) const {
  const Camera& camera = inputs_.camera;
  const float aspect = float(inputs_.width) / float(inputs_.height);
  const double wholeHeight = 2.0 * double(halfHeightOf(camera, aspect));
  std::map<std::size_t, double> widest; // pixels of an exemplar, by material
  for (const Instance& instance : scene_.instances) {
    const std::size_t m = scene_.primitives[instance.primitive].material;
    const double side =
        noises_.tileSide(m) * (noises_.roles(m).inObjectSpace ? scaleOf(instance) : 1.0);
    if (side == 0.0)
      continue;
    const double height =
        camera.perspective ? wholeHeight * depthOf(scene_, instance, camera) : wholeHeight;
    const double pixels = height > 0.0 ? side / height * double(inputs_.height) : kFewestPixels;
    double& most = widest.try_emplace(m, 0.0).first->second;
    most = std::max(most, pixels);
  }
  std::erase_if(widest, [](const auto& each) { return each.second >= kFewestPixels; });
  if (widest.empty())
    return;
  const auto first =
      std::max_element(widest.begin(), widest.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  const std::string others =
      widest.size() > 1 ? fmt::format(", and of {} more materials less", widest.size() - 1) : "";
  notes.push_back(fmt::format("/materials/{}: an exemplar's width of its noise is {:.2g} pixels at "
                              "most{}: little but the mean is seen; a larger scale or a nearer "
                              "camera shows the noise",
                              first->first, first->second, others));
}

/// A noise by texture coordinates that a mesh does not have, or that are all alike.
void SceneRenderer::noteMissingTexCoords(std::vector<std::string>& notes) const {
  std::set<std::size_t> noted;
  for (const Primitive& primitive : scene_.primitives) {
    const std::size_t m = primitive.material;
    if (!noises_.hasNoise(m) || noises_.tileSide(m) != 0.0 || noted.contains(m))
      continue;
    const std::uint32_t set = noises_.roles(m).texCoord;
    const auto coordinates = set == 0 ? &Vertex::texCoord0 : &Vertex::texCoord1;
    const glm::vec2 first = primitive.vertices.front().*coordinates;
    if (std::any_of(primitive.vertices.begin(), primitive.vertices.end(),
                    [&](const Vertex& vertex) { return vertex.*coordinates != first; }))
      continue;
    noted.insert(m);
    notes.push_back(fmt::format("/materials/{}: its noise lies by TEXCOORD_{}, of which a mesh has "
                                "none or one value, so that one value of the noise is seen; the "
                                "mapping triplanar needs none",
                                m, set));
  }
}

std::vector<std::string> SceneRenderer::notes() const {
  std::vector<std::string> notes = noises_.notes();
  noteCoarseVertices(notes);
  noteUnseenNoise(notes);
  noteMissingTexCoords(notes);
  std::set<std::string> faults; // one camera may stand in several places
  for (const Camera& camera : scene_.cameras)
    if (!camera.fault.empty() && faults.insert(camera.fault).second)
      notes.push_back(camera.fault + "; this camera is not looked through");
  if (inputs_.lighting.dropped > 0)
    notes.push_back("the scene has " +
                    std::to_string(inputs_.lighting.lights.size() + inputs_.lighting.dropped) +
                    " lights; the " + std::to_string(MAX_LIGHTS) + " that light it most are drawn");
  notes.insert(notes.end(), environmentNotes_.begin(), environmentNotes_.end());
  return notes;
}

} // namespace lichen::renderer
