// SPDX-License-Identifier: MIT
// Rendered noise on surfaces without texture coordinates: each pixel against C++ at the world
// position of the pixel.
#include "rendered.h"
#include "synthetic_texton.h"

#include <lichen/noise_evaluator.h>

#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kSide = 48;
constexpr float kDistance = 3.0f, kFieldOfView = 0.4f;

/// A rotated, moved and scaled square without texture coordinates that fills the picture. The
/// exemplar's x runs along (4, 3, 0) / 5 of the object.
struct Square {
  explicit Square(const SyntheticTexton& texton) : file(syntheticTextonBundle(texton)) {
    MaterialNoise& use = *file.bundle.materials[0];
    use.mapping = Mapping::surface;
    use.rotation = 0.4;
    use.scale = 0.6;
    use.seed = 3;
  }

  [[nodiscard]] GltfScene scene(bool fromBehind = false) const {
    GltfScene scene(encodeGlb(file).value());
    scene.json["materials"][0]["doubleSided"] = fromBehind;
    const std::size_t positions = scene.addFloats({-4, -4, 0, 4, -4, 0, 4, 4, 0, -4, 4, 0}, 3);
    const std::size_t normals = scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    std::vector<float> tangents;
    for (int vertex = 0; vertex < 4; ++vertex)
      tangents.insert(tangents.end(), {0.8f, 0.6f, 0.0f, 1.0f});
    const std::size_t indices = fromBehind ? scene.addIndices({0, 2, 1, 0, 3, 2}, 2)
                                           : scene.addIndices({0, 1, 2, 0, 2, 3}, 2);
    scene.addMesh(
        {{"POSITION", positions}, {"NORMAL", normals}, {"TANGENT", scene.addFloats(tangents, 4)}},
        indices, 0,
        {{"translation", {0.3, -0.2, 0.1}},
         {"rotation", {0, 0, std::sin(kTurn / 2), std::cos(kTurn / 2)}},
         {"scale", {0.5, 0.5, 0.5}}});
    scene.addCamera(kDistance, kFieldOfView);
    return scene;
  }

  [[nodiscard]] LinearImage picture(const char* view, bool fromBehind = false) const {
    renderer::RenderSettings settings = settingsOf(kSide, kSide, 1);
    settings.debugView = view;
    return render(scene(fromBehind).glb(), settings);
  }

  /// The footprint of a pixel on the square, in the world.
  [[nodiscard]] SurfaceFootprint footprint(int x, int y) const {
    const float half = (kDistance - kHeight) * std::tan(kFieldOfView / 2);
    const float pixel = 2.0f * half / kSide;
    SurfaceFootprint at;
    at.position = {(float(x) + 0.5f) * pixel - half, half - (float(y) + 0.5f) * pixel, kHeight};
    at.dx = {pixel, 0.0f, 0.0f};
    at.dy = {0.0f, -pixel, 0.0f};
    at.normal = {0.0f, 0.0f, 1.0f};
    at.tangent = {0.8f * std::cos(kTurn) - 0.6f * std::sin(kTurn),
                  0.8f * std::sin(kTurn) + 0.6f * std::cos(kTurn), 0.0f, 1.0f};
    return at;
  }

  static constexpr float kTurn = 0.7f, kHeight = 0.1f;
  BundleFile file;
};

std::unique_ptr<const NoiseEvaluator> noiseOf(const Square& square) {
  return NoiseEvaluator::create(square.file.bundle, *square.file.bundle.materials[0]).value();
}

} // namespace

TEST_CASE("colours on a surface follow the world position, and are the same from behind") {
  const Square square({.wholeFloats = true});
  const LinearImage picture = square.picture("base-color", true);
  const auto noise = noiseOf(square);
  double spread = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto expected = noise->evaluate(0, square.footprint(x, y));
      for (std::size_t c = 0; c < 3; ++c) // half floats, and positions through two matrices
        REQUIRE(picture.pixel(x, y)[c] == Approx(expected[c]).margin(1.0 / 255.0));
      spread += std::pow(double(expected[0]) - 0.222, 2) / (kSide * kSide);
    }
  CHECK(spread > 1e-4); // the noise is not constant
}

TEST_CASE("slopes on a surface tilt the normal along its tangent and bitangent") {
  const Square square({.channels = 2, .wholeFloats = true});
  const LinearImage picture = square.picture("normals");
  const auto noise = noiseOf(square);
  const double turn = square.file.bundle.materials[0]->rotation;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto slopes = noise->evaluate(0, square.footprint(x, y));
      const auto tangent = square.footprint(x, y).tangent;
      // From the exemplar's frame, with y up, to the tangent's frame.
      const double along = std::cos(turn) * double(slopes[0]) + std::sin(turn) * double(slopes[1]);
      const double up = std::cos(turn) * double(slopes[1]) - std::sin(turn) * double(slopes[0]);
      const double tangentX = double(tangent[0]), tangentY = double(tangent[1]);
      const double length = std::sqrt(1.0 + along * along + up * up);
      const std::array<double, 3> normal{(-along * tangentX + up * tangentY) / length,
                                         (-along * tangentY - up * tangentX) / length,
                                         1.0 / length};
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(double(picture.pixel(x, y)[c]) ==
                Approx(0.5 + 0.5 * normal[c]).margin(1.0 / 255.0));
    }
}

TEST_CASE("a note names a mesh once if its noise needs tangents that it lacks") {
  GltfScene scene = Square({.wholeFloats = true}).scene();
  scene.json["meshes"][0]["name"] = "wall";
  scene.json["materials"][0]["name"] = "moss";
  const auto notesOf = [&] {
    const TemporaryFolder folder;
    const auto read = renderer::readScene(writeInto(folder, "scene.glb", scene.glb()));
    REQUIRE(read.ok());
    return read.value().notes;
  };
  CHECK(notesOf().empty());
  nlohmann::json& primitives = scene.json["meshes"][0]["primitives"];
  primitives[0]["attributes"].erase("TANGENT");
  primitives.push_back(primitives[0]);
  CHECK(notesOf() == std::vector<std::string>{
                         "/meshes/0 \"wall\" has no TANGENT attribute, which the noise of its "
                         "material \"moss\" follows; an arbitrary direction is used; add "
                         "tangents with lichen apply"});
  // The loader generates tangents from the texture coordinates of a normal texture.
  const auto texture = scene.addChecker(2, {0.5f, 0.5f, 1.0f}, {0.5f, 0.5f, 1.0f});
  scene.json["materials"][0]["normalTexture"] = {{"index", texture}};
  CHECK(notesOf().size() == 1);
  for (nlohmann::json& primitive : primitives)
    primitive["attributes"]["TEXCOORD_0"] = scene.addFloats({0, 1, 1, 1, 1, 0, 0, 0}, 2);
  CHECK(notesOf().empty());
}
