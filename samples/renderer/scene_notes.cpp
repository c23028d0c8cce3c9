// SPDX-License-Identifier: MIT
// Notes to the user about a scene that renders differently than expected.
#include "scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace lichen::renderer {
namespace {

// Smallest useful width of an exemplar on screen; below it, its mip levels have almost no variation
// left.
constexpr double kFewestPixels = 4.0;

/// The largest scale factor of an instance's transform.
double scaleOf(const Instance& instance) {
  const glm::dmat4& world = instance.worldFromObject;
  return std::max({glm::length(world[0]), glm::length(world[1]), glm::length(world[2])});
}

} // namespace

/// Notes noises of all mappings but uv that are too small to be visible from the camera.
void SceneRenderer::noteInvisibleNoise(std::vector<std::string>& notes) const {
  const Camera& camera = inputs_.camera;
  const float aspect = float(inputs_.width) / float(inputs_.height);
  const double wholeHeight = 2.0 * double(halfHeightOf(camera, aspect));
  std::map<std::size_t, double> widest; // largest width of an exemplar in pixels, by material
  for (const Instance& instance : scene_.instances) {
    const std::size_t m = scene_.primitives[instance.primitive].material;
    const double side =
        noises_.tileSide(m) * (noises_.use(m).inObjectSpace ? scaleOf(instance) : 1.0);
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
      widest.size() > 1 ? fmt::format(" (less for {} more materials)", widest.size() - 1) : "";
  notes.push_back(fmt::format("/materials/{}: an exemplar of its noise is at most {:.2g} pixels "
                              "wide{}, so little more than the mean is visible; use a larger "
                              "scale or move the camera closer",
                              first->first, first->second, others));
}

/// Notes noises with uv mapping on a mesh whose texture coordinates are missing or all equal.
void SceneRenderer::noteMissingTexCoords(std::vector<std::string>& notes) const {
  std::set<std::size_t> notedMaterials;
  for (const Primitive& primitive : scene_.primitives) {
    const std::size_t m = primitive.material;
    if (!noises_.hasNoise(m) || noises_.tileSide(m) != 0.0 || notedMaterials.contains(m))
      continue;
    const std::uint32_t set = noises_.use(m).texCoord;
    const auto coordinates = set == 0 ? &Vertex::texCoord0 : &Vertex::texCoord1;
    const glm::vec2 first = primitive.vertices.front().*coordinates;
    if (std::any_of(primitive.vertices.begin(), primitive.vertices.end(),
                    [&](const Vertex& vertex) { return vertex.*coordinates != first; }))
      continue;
    notedMaterials.insert(m);
    notes.push_back(
        fmt::format("/materials/{}: its noise is mapped by TEXCOORD_{}, which a mesh "
                    "does not have, or has with a single value, so the noise is constant "
                    "there; triplanar mapping needs no texture coordinates",
                    m, set));
  }
}

std::vector<std::string> SceneRenderer::notes() const {
  std::vector<std::string> notes = noises_.notes();
  noteInvisibleNoise(notes);
  noteMissingTexCoords(notes);
  std::set<std::string> faults; // several nodes may share a camera
  for (const Camera& camera : scene_.cameras)
    if (!camera.fault.empty() && faults.insert(camera.fault).second)
      notes.push_back(camera.fault + "; the camera is ignored");
  if (inputs_.lighting.dropped > 0)
    notes.push_back("the scene has " +
                    std::to_string(inputs_.lighting.lights.size() + inputs_.lighting.dropped) +
                    " lights; only the " + std::to_string(MAX_LIGHTS) + " strongest are used");
  notes.insert(notes.end(), environmentNotes_.begin(), environmentNotes_.end());
  return notes;
}

} // namespace lichen::renderer
