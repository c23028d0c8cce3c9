// SPDX-License-Identifier: MIT
// A mix of textons in the renderer, with equal weights from a direction, a mask and vertex colours.
#include "rendered.h"
#include "synthetic_texton.h"

#include <lichen/image_io.h>

#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

constexpr const char* kExtension = "LICHEN_materials_exemplar_noise";
constexpr float kTiles = 4.0f;
constexpr int kSide = 64; // pixels per side of a square

/// Squares of four tiles, stacked vertically, each with another source of its mix weight. COLOR_1
/// and texture 0 have the weight in green, increasing from left to right.
class Squares {
public:
  Squares() : scene_(syntheticTextonGlb({.steps = 5, .smoothings = 1})) {
    constexpr int kTexels = 64;
    SrgbImage mask(kTexels, 1, 1);
    for (int x = 0; x < kTexels; ++x)
      *mask.pixel(x, 0) = (float(x) + 0.5f) / float(kTexels);
    const std::size_t view = scene_.addView(encodePng(mask, 16).value());
    constexpr int kClampToEdge = 33071;
    scene_.json["samplers"] = {{{"wrapS", kClampToEdge}}};
    scene_.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    scene_.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    scene_.json["extensionsUsed"].push_back("KHR_texture_transform");
  }

  void add(const json& mix) {
    const float top = -2.0f * float(count_++);
    json material = scene_.json["materials"][0];
    material["extensions"][kExtension]["mix"] = mix;
    const std::size_t positions =
        scene_.addFloats({-1, top - 2, 0, 1, top - 2, 0, 1, top, 0, -1, top, 0}, 3);
    const std::size_t normals = scene_.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    const std::size_t texCoords = scene_.addFloats({0, kTiles, kTiles, kTiles, kTiles, 0, 0, 0}, 2);
    const std::size_t colors =
        scene_.addFloats({1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1}, 4);
    scene_.addMesh({{"POSITION", positions},
                    {"NORMAL", normals},
                    {"TEXCOORD_0", texCoords},
                    {"COLOR_1", colors}},
                   scene_.addIndices({0, 1, 2, 0, 2, 3}, 2), scene_.addMaterial(material));
  }

  /// Renders the base colours of all squares.
  LinearImage baseColors() {
    constexpr float kDistance = 10.0f;
    scene_.addCamera(kDistance, 2.0f * std::atan(float(count_) / kDistance), -float(count_));
    renderer::RenderSettings settings =
        settingsOf(kSide, std::uint32_t(kSide) * std::uint32_t(count_), 1);
    settings.debugView = "base-color";
    return render(scene_.glb(), settings);
  }

private:
  GltfScene scene_;
  int count_ = 0;
};

/// Means of all channels in eight columns of a square, from left to right.
std::array<double, 8> columnMeans(const LinearImage& image, int square) {
  std::array<double, 8> means{};
  constexpr int kWidth = kSide / 8;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        means[std::size_t(x / kWidth)] +=
            double(image.pixel(x, square * kSide + y)[c]) / (3.0 * kWidth * kSide);
  return means;
}

/// The mean difference between two squares.
double differenceOf(const LinearImage& image, int square, int other) {
  double difference = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        difference += std::abs(double(image.pixel(x, square * kSide + y)[c]) -
                               double(image.pixel(x, other * kSide + y)[c])) /
                      (3.0 * kSide * kSide);
  return difference;
}

json maskOf(int channel) {
  return {{"source", "texture"},
          {"channel", channel},
          {"texture",
           {{"index", 0},
            {"extensions", {{"KHR_texture_transform", {{"scale", {1.0 / kTiles, 1.0}}}}}}}}};
}

json verticesOf(int channel) {
  return {{"source", "vertexColor"}, {"set", 1}, {"channel", channel}};
}

} // namespace

TEST_CASE("a direction, a mask and vertex colours with equal weights give the same picture") {
  Squares squares;
  squares.add({{"source", "direction"}, {"start", {0, 1}}, {"end", {kTiles, 1}}});
  squares.add(maskOf(0));
  squares.add(verticesOf(1));
  // A missing alpha channel and the vertices' red are 1 everywhere.
  squares.add({{"source", "constant"}, {"weight", 1.0}});
  squares.add(maskOf(3));
  squares.add(verticesOf(0));
  const LinearImage image = squares.baseColors();
  const std::array<double, 8> expected = columnMeans(image, 0);
  // Stored means of 0.5 and 0.1 are 0.21 and, with a deviation of 0.24, about 0.06 as light.
  CHECK(expected.front() > expected.back() + 0.1);
  // 8-bit weights move one impact in a hundred to another step; the mask clamps at its borders.
  CHECK(differenceOf(image, 0, 1) < 0.01);
  // With vertex colours, all impacts use the weight at the point: other textons near the borders of
  // steps, with the same statistics.
  const std::array<double, 8> vertices = columnMeans(image, 2);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    CHECK(vertices[k] == Approx(expected[k]).margin(0.03));
  CHECK(differenceOf(image, 0, 3) > 0.05);
  CHECK(differenceOf(image, 3, 4) < 1e-6);
  CHECK(differenceOf(image, 3, 5) < 1e-6);
}
