// SPDX-License-Identifier: MIT
// Any bytes -> parseScene(): a scene that satisfies the loader's contract, or a one-line error.
// Needs no Vulkan device, only lichen::scene. To run a campaign with Clang:
//   export CC=clang CXX=clang++
//   cmake -B build/fuzz -G Ninja -DLICHEN_FUZZ=ON -DLICHEN_SANITIZE=address,undefined
//   ninja -C build/fuzz fuzz_scene fuzz_scene_replay
//   mkdir corpus && build/fuzz/bin/fuzz_scene_replay corpus corpus
//   build/fuzz/bin/fuzz_scene corpus -timeout=10 -rss_limit_mb=2500 -max_len=120000
// Fixed findings go to tests/fuzz/regressions/scene/.
#include "contract.h"
#include "scene.h"

#include <lichen/escaped.h>

#include <cmath>
#include <cstdint>

using namespace lichen;
using fuzz::require;

namespace {

/// As floats, which are what is drawn.
bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(float(matrix[column][row])))
        return false;
  return true;
}

/// What the renderer relies on in a scene that the loader gives it.
void checkContract(const renderer::Scene& scene) {
  for (const renderer::Primitive& primitive : scene.primitives) {
    require(!primitive.indices.empty() && primitive.indices.size() % 3 == 0,
            "three indices per triangle");
    for (const std::uint32_t index : primitive.indices)
      require(index < primitive.vertices.size(), "indices below the number of vertices");
    for (const renderer::Vertex& vertex : primitive.vertices)
      for (int k = 0; k < 3; ++k)
        require(std::isfinite(vertex.position[k]) && std::isfinite(vertex.normal[k]),
                "finite vertices");
    require(primitive.material < scene.materials.size(), "a material for each primitive");
  }
  for (const renderer::Instance& instance : scene.instances)
    require(instance.primitive < scene.primitives.size() && isFinite(instance.worldFromObject),
            "instances of primitives, with finite transforms");
  for (const renderer::Camera& camera : scene.cameras)
    require(isFinite(camera.worldFromCamera), "cameras with finite transforms");
  for (const renderer::TextureImage& image : scene.images)
    require(image.rgba.size() == std::size_t(image.width) * std::size_t(image.height) * 4,
            "four bytes per texel");
  require(!scene.instances.empty(), "something to draw");
}

/// The message may quote the file, escaped.
bool isOneLine(const std::string& text) { return !text.empty() && escaped(text) == text; }

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  // The folder does not exist, so files that the scene refers to are not read.
  const Result<renderer::Scene> scene =
      renderer::parseScene({bytes, bytes + size}, "absent-folder/scene.glb");
  if (!scene) {
    require(isOneLine(scene.error().message), "an error message that is not one line");
    return 0;
  }
  checkContract(scene.value());
  for (const std::string& note : scene.value().notes)
    require(isOneLine(note), "a note of more or less than one line");
  return 0;
}
