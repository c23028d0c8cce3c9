// SPDX-License-Identifier: MIT
#include "scene_promises.h"

#include <cmath>

namespace lichen::test {
namespace {

/// As floats, which are what is drawn.
bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(float(matrix[column][row])))
        return false;
  return true;
}

} // namespace

std::string brokenPromise(const renderer::Scene& scene) {
  for (const renderer::Primitive& primitive : scene.primitives) {
    if (primitive.indices.empty() || primitive.indices.size() % 3 != 0)
      return "three indices per triangle";
    for (const std::uint32_t index : primitive.indices)
      if (index >= primitive.vertices.size())
        return "indices below the number of vertices";
    for (const renderer::Vertex& vertex : primitive.vertices)
      for (int k = 0; k < 3; ++k)
        if (!std::isfinite(vertex.position[k]) || !std::isfinite(vertex.normal[k]))
          return "finite vertices";
    if (primitive.material >= scene.materials.size())
      return "a material for each primitive";
  }
  for (const renderer::Instance& instance : scene.instances)
    if (instance.primitive >= scene.primitives.size() || !isFinite(instance.worldFromObject))
      return "instances of primitives, with finite transforms";
  for (const renderer::Camera& camera : scene.cameras)
    if (!isFinite(camera.worldFromCamera))
      return "cameras with finite transforms";
  for (const renderer::TextureImage& image : scene.images)
    if (image.rgba.size() != std::size_t(image.width) * std::size_t(image.height) * 4)
      return "four bytes per texel";
  return scene.instances.empty() ? "something to draw" : "";
}

} // namespace lichen::test
