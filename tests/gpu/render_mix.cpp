// SPDX-License-Identifier: MIT
// A mix of textons in the renderer: the same weight from a direction, a mask and vertex colours.
#include "rendered.h"
#include "synthetic_texton.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

constexpr const char* kExtension = "LICHEN_materials_exemplar_noise";
constexpr float kTiles = 4.0f;
constexpr int kSide = 128;

/// A square that fills the picture, four tiles wide, with the weight of its mix from left to right
/// in COLOR_1 and in texture 0.
GltfScene squareOfMix() {
  GltfScene scene(syntheticTextonGlb({.steps = 5, .smoothings = 1}));
  const std::size_t positions = scene.addFloats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3);
  const std::size_t normals = scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const std::size_t texCoords = scene.addFloats({0, kTiles, kTiles, kTiles, kTiles, 0, 0, 0}, 2);
  const std::size_t colors =
      scene.addFloats({1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1}, 4); // green
  scene.addMesh({{"POSITION", positions},
                 {"NORMAL", normals},
                 {"TEXCOORD_0", texCoords},
                 {"COLOR_1", colors}},
                scene.addIndices({0, 1, 2, 0, 2, 3}, 2), 0);
  scene.addCamera(10.0f, 2.0f * std::atan(0.1f));
  constexpr int kTexels = 64;
  SrgbImage mask(kTexels, 1, 1);
  for (int x = 0; x < kTexels; ++x)
    *mask.pixel(x, 0) = (float(x) + 0.5f) / float(kTexels);
  const std::size_t view = scene.addView(encodePng(mask, 16).value());
  constexpr int kClampToEdge = 33071;
  scene.json["samplers"] = {{{"wrapS", kClampToEdge}}};
  scene.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  scene.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  return scene;
}

json& mixOf(GltfScene& scene) {
  return scene.json["materials"][0]["extensions"][kExtension]["mix"];
}

LinearImage baseColor(const GltfScene& scene) {
  renderer::RenderSettings settings = settingsOf(kSide, kSide, 1);
  settings.debugView = "base-color";
  return render(scene.glb(), settings);
}

/// Means of all channels in eighths of the picture, from left to right.
std::array<double, 8> columnMeans(const LinearImage& image) {
  std::array<double, 8> means{};
  constexpr int kWidth = kSide / 8;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        means[std::size_t(x / kWidth)] += double(image.pixel(x, y)[c]) / (3.0 * kWidth * kSide);
  return means;
}

const json kDirection{{"source", "direction"}, {"start", {0, 1}}, {"end", {kTiles, 1}}};
const json kMask{{"source", "texture"},
                 {"texture",
                  {{"index", 0},
                   {"extensions", {{"KHR_texture_transform", {{"scale", {1.0 / kTiles, 1.0}}}}}}}}};
const json kVertexColor{{"source", "vertexColor"}, {"set", 1}, {"channel", 1}};

} // namespace

TEST_CASE("a direction, a mask and vertex colours of one weight draw one picture") {
  GltfScene scene = squareOfMix();
  mixOf(scene) = kDirection;
  const LinearImage along = baseColor(scene);
  const std::array<double, 8> expected = columnMeans(along);
  // Stored means of 0.5 and 0.1: light of 0.21 and, with a deviation of 0.24, about 0.06.
  CHECK(expected.front() > expected.back() + 0.1);
  scene.json["extensionsUsed"].push_back("KHR_texture_transform");
  mixOf(scene) = kMask;
  const LinearImage masked = baseColor(scene);
  double difference = 0.0;
  for (std::size_t i = 0; i < along.values.size(); ++i)
    difference +=
        std::abs(double(along.values[i]) - double(masked.values[i])) / double(along.values.size());
  // Weights of 8 bits put one impact in a hundred on another step; past the borders the mask stays.
  CHECK(difference < 0.01);
  // Of vertex colours all impacts have the point's weight: other textons near the borders of steps,
  // of the same statistics. Some 30 patches of noise an eighth.
  mixOf(scene) = kVertexColor;
  const std::array<double, 8> vertices = columnMeans(baseColor(scene));
  for (std::size_t k = 0; k < vertices.size(); ++k)
    CHECK(vertices[k] == Approx(expected[k]).margin(0.03));
}

TEST_CASE("the channel of a mask counts, and a constant is the same everywhere") {
  GltfScene scene = squareOfMix();
  mixOf(scene) = {{"source", "constant"}, {"weight", 1.0}};
  const std::array<double, 8> last = columnMeans(baseColor(scene));
  CHECK(*std::max_element(last.begin(), last.end()) <
        *std::min_element(last.begin(), last.end()) + 0.06);
  // Alpha of a picture without it, and red of the vertices, is 1.
  json mask = kMask;
  mask["channel"] = 3;
  mixOf(scene) = mask;
  CHECK(columnMeans(baseColor(scene))[0] == Approx(last[0]).margin(1e-6));
  json vertices = kVertexColor;
  vertices["channel"] = 0;
  mixOf(scene) = vertices;
  CHECK(columnMeans(baseColor(scene))[0] == Approx(last[0]).margin(1e-6));
}
