// SPDX-License-Identifier: MIT
// Rendered triplanar noise: each pixel against C++ at its position, in world or object
// space, for normals along all axes and oblique ones, on meshes with different transforms.
#include "rendered.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/noise_evaluator.h>

#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;

namespace {

using Vec3 = std::array<float, 3>;

constexpr int kCell = 16, kColumns = 4, kRows = 2;
constexpr int kWidth = kColumns * kCell, kHeight = kRows * kCell;
constexpr float kDistance = 3.0f, kFieldOfView = 0.3f;
constexpr float kUnit = 1.0f / 3.0f;
constexpr float kDiagonal = 0.70710678f;

/// Normals of the cells, row by row.
constexpr std::array<Vec3, kColumns * kRows> kNormals{{{1, 0, 0},
                                                       {-1, 0, 0},
                                                       {0, 1, 0},
                                                       {0, -1, 0},
                                                       {0, 0, 1},
                                                       {0, 0, -1},
                                                       {kDiagonal, 0, -kDiagonal},
                                                       {-2 * kUnit, 2 * kUnit, kUnit}}};

/// Half the picture's height and the side of a pixel in the plane of the squares, in metres.
float halfHeight() { return kDistance * std::tan(kFieldOfView / 2); }
float pixelSide() { return 2.0f * halfHeight() / kHeight; }

/// Squares that face the camera, side by side, with arbitrary normals. Each row is a mesh; the
/// second one is moved and scaled so that it continues the first.
LinearImage picture(BundleFile file, const char* view) {
  MaterialNoise& use = *file.bundle.materials[0];
  use.mapping = Mapping::triplanar;
  GltfScene scene(encodeGlb(file).value());
  constexpr float kScale = 0.5f;
  constexpr Vec3 kMove{0.3f, -0.2f, 0.1f};
  const float side = float(kCell) * pixelSide();
  for (int row = 0; row < kRows; ++row) {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
    for (int column = 0; column < kColumns; ++column) {
      const auto first = std::uint32_t(4 * column);
      for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        indices.push_back(first + corner);
      for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        Vec3 position{float(column + right - kColumns / 2) * side,
                      float(kRows / 2 - row - 1 + up) * side, 0.0f};
        for (std::size_t k = 0; k < 3; ++k)
          positions.push_back(row == 0 ? position[k] : (position[k] - kMove[k]) / kScale);
        const Vec3& normal = kNormals[std::size_t(row * kColumns + column)];
        normals.insert(normals.end(), normal.begin(), normal.end());
      }
    }
    const std::size_t at = scene.addFloats(positions, 3), along = scene.addFloats(normals, 3);
    nlohmann::json node = nlohmann::json::object();
    if (row == 1)
      node = {{"translation", kMove}, {"scale", {kScale, kScale, kScale}}};
    scene.addMesh({{"POSITION", at}, {"NORMAL", along}}, scene.addIndices(indices, 2), 0, node);
  }
  scene.addCamera(kDistance, kFieldOfView);
  renderer::RenderSettings settings = settingsOf(kWidth, kHeight, 1);
  settings.debugView = view;
  return render(scene.glb(), settings);
}

/// The footprint of a pixel on its square, in the world.
TriplanarFootprint footprint(int x, int y) {
  const float pixel = pixelSide();
  TriplanarFootprint at;
  at.position = {(float(x) + 0.5f - kWidth / 2) * pixel, (kHeight / 2 - float(y) - 0.5f) * pixel,
                 0.0f};
  at.dx = {pixel, 0.0f, 0.0f};
  at.dy = {0.0f, -pixel, 0.0f};
  at.normal = kNormals[std::size_t(y / kCell * kColumns + x / kCell)];
  return at;
}

/// Sets every parameter of the mapping.
void setParameters(BundleFile& file) {
  MaterialNoise& use = *file.bundle.materials[0];
  use.mapping = Mapping::triplanar;
  use.rotation = 0.4;
  use.scale = 0.6;
  use.seed = 3;
  use.planeSharpness = 3.0;
}

/// The transform of a mesh: rotated around an axis through opposite corners of a cube, then scaled
/// along its own axes, then moved.
struct ObjectTransform {
  float turn = 0.0f;
  Vec3 scale{1.0f, 1.0f, 1.0f};
  std::array<double, 3> move{};

  /// The linear part, row by row.
  [[nodiscard]] std::array<std::array<double, 3>, 3> linear() const {
    const double c = std::cos(double(turn)), s = std::sin(double(turn)) / std::sqrt(3.0);
    const double rest = (1.0 - c) / 3.0;
    std::array<std::array<double, 3>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        m[i][j] = double(scale[j]) * (i == j ? c + rest : rest + ((j + 3 - i) % 3 == 1 ? -s : s));
    return m;
  }
};

/// Solves m x = v by Cramer's rule.
Vec3 solved(const std::array<std::array<double, 3>, 3>& m, const std::array<double, 3>& v) {
  const auto determinant = [](const auto& a) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
           a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  };
  Vec3 x{};
  for (std::size_t k = 0; k < 3; ++k) {
    auto replaced = m;
    for (std::size_t i = 0; i < 3; ++i)
      replaced[i][k] = v[i];
    x[k] = float(determinant(replaced) / determinant(m));
  }
  return x;
}

nlohmann::json matrixOf(const ObjectTransform& transform) {
  nlohmann::json matrix = nlohmann::json::array();
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row)
      matrix.push_back(transform.linear()[row][column]);
    matrix.push_back(0.0);
  }
  for (const double along : transform.move)
    matrix.push_back(along);
  matrix.push_back(1.0);
  return matrix;
}

/// A picture of a plane that faces the camera at `origin`. Its left and right halves are meshes
/// with these transforms that meet in the middle.
LinearImage halves(const BundleFile& file, const std::array<ObjectTransform, 2>& transforms,
                   const std::array<double, 3>& origin) {
  constexpr Vec3 kNormal{6.0f / 11.0f, 6.0f / 11.0f, 7.0f / 11.0f}; // all three planes contribute
  GltfScene scene(encodeGlb(file).value());
  const double half = 2.0 * double(halfHeight());
  for (std::size_t side = 0; side < 2; ++side) {
    const auto m = transforms[side].linear();
    std::vector<float> positions, normals;
    for (const auto& [right, up] : {std::pair{0, -1}, {1, -1}, {1, 1}, {0, 1}}) {
      const std::array<double, 3> position{(double(side) - 1.0 + right) * half, 0.5 * up * half,
                                           0.0};
      std::array<double, 3> moved{};
      for (std::size_t k = 0; k < 3; ++k)
        moved[k] = origin[k] + position[k] - transforms[side].move[k];
      const Vec3 own = solved(m, moved);
      positions.insert(positions.end(), own.begin(), own.end());
      // Normals transform by the inverse transpose.
      for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
          sum += m[i][k] * double(kNormal[i]);
        normals.push_back(float(sum));
      }
      double squares = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        squares += std::pow(double(normals[normals.size() - 3 + k]), 2);
      for (std::size_t k = 0; k < 3; ++k)
        normals[normals.size() - 3 + k] /= float(std::sqrt(squares));
    }
    const std::size_t at = scene.addFloats(positions, 3), along = scene.addFloats(normals, 3);
    scene.addMesh({{"POSITION", at}, {"NORMAL", along}}, scene.addIndices({0, 1, 2, 0, 2, 3}, 1), 0,
                  {{"matrix", matrixOf(transforms[side])}});
  }
  scene.addCamera(kDistance, kFieldOfView);
  scene.json["nodes"].back()["translation"] = {origin[0], origin[1], origin[2] + double(kDistance)};
  renderer::RenderSettings settings = settingsOf(kWidth, kHeight, 1);
  settings.debugView = "base-color";
  return render(scene.glb(), settings);
}

/// What transforms an object.
enum class Mover { node, skin, morphTarget };

/// The footprint of a pixel, in object space, on a plane that faces the camera with this transform.
TriplanarFootprint onObject(const ObjectTransform& transform, int x, int y) {
  const auto m = transform.linear();
  const double pixel = double(pixelSide());
  TriplanarFootprint at;
  at.position =
      solved(m, {(x + 0.5 - kWidth / 2) * pixel - transform.move[0],
                 (kHeight / 2 - y - 0.5) * pixel - transform.move[1], -transform.move[2]});
  at.dx = solved(m, {pixel, 0.0, 0.0});
  at.dy = solved(m, {0.0, -pixel, 0.0});
  const double length = std::hypot(m[2][0], m[2][1], m[2][2]);
  for (std::size_t k = 0; k < 3; ++k) // the inverse transpose maps it to (0, 0, 1)
    at.normal[k] = float(m[2][k] / length);
  return at;
}

/// Adds a skin with one joint with this transform for all four vertices of a mesh.
void addSkin(GltfScene& scene, const ObjectTransform& transform) {
  const std::vector<std::uint8_t> joints(16, 0);
  scene.json["accessors"].push_back(
      {{"bufferView", scene.addView(std::as_bytes(std::span(joints)))},
       {"componentType", 5121},
       {"type", "VEC4"},
       {"count", 4}});
  auto& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = scene.json["accessors"].size() - 1;
  attributes["WEIGHTS_0"] = scene.addFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
  scene.json["nodes"][0]["skin"] = 0;
  scene.json["nodes"].push_back({{"matrix", matrixOf(transform)}});
  const std::size_t joint = scene.json["nodes"].size() - 1;
  scene.json["scenes"][0]["nodes"].push_back(joint);
  scene.json["skins"] = {{{"joints", {joint}}}};
}

/// A picture of a plane that faces the camera, with noise in object space.
LinearImage onObject(BundleFile file, const ObjectTransform& transform, Mover mover,
                     const char* view) {
  file.bundle.materials[0]->space = NoiseSpace::object;
  GltfScene scene(encodeGlb(file).value());
  const auto& [a, b] = std::pair{2.0 * double(halfHeight()), double(halfHeight())};
  std::vector<float> positions, normals, moves, turns;
  for (const auto& [x, y] : {std::pair{-a, -b}, {a, -b}, {a, b}, {-a, b}}) {
    const Vec3 own = solved(transform.linear(),
                            {x - transform.move[0], y - transform.move[1], -transform.move[2]});
    const Vec3 normal = onObject(transform, 0, 0).normal;
    const Vec3 world{float(x), float(y), 0.0f};
    for (std::size_t k = 0; k < 3; ++k) {
      positions.push_back(own[k]);
      normals.push_back(normal[k]);
      moves.push_back(world[k] - own[k]);
      turns.push_back((k == 2 ? 1.0f : 0.0f) - normal[k]);
    }
  }
  const bool mirrors = transform.scale[0] * transform.scale[1] * transform.scale[2] < 0.0f;
  const std::vector<std::uint32_t> corners = mirrors && mover != Mover::morphTarget
                                                 ? std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2}
                                                 : std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
  const std::size_t at = scene.addFloats(positions, 3), along = scene.addFloats(normals, 3);
  nlohmann::json node = nlohmann::json::object();
  if (mover == Mover::node)
    node["matrix"] = matrixOf(transform);
  scene.addMesh({{"POSITION", at}, {"NORMAL", along}}, scene.addIndices(corners, 1), 0, node);
  if (mover == Mover::skin)
    addSkin(scene, transform);
  if (mover == Mover::morphTarget) {
    scene.json["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", scene.addFloats(moves, 3)}, {"NORMAL", scene.addFloats(turns, 3)}}};
    scene.json["meshes"][0]["weights"] = {1.0};
  }
  scene.addCamera(kDistance, kFieldOfView);
  renderer::RenderSettings settings = settingsOf(kWidth, kHeight, 1);
  settings.debugView = view;
  return render(scene.glb(), settings);
}

const std::array<ObjectTransform, 5> kStands{{{},
                                              {1.1f, {1.0f, 1.0f, 1.0f}, {0.4, -0.3, 0.2}},
                                              {-0.8f, {2.0f, 2.0f, 2.0f}, {0.0, 1.0, -0.5}},
                                              {0.7f, {0.5f, 1.6f, 1.0f}, {0.1, 0.2, 0.3}},
                                              {2.3f, {-1.0f, 0.7f, 1.5f}, {-0.2, 0.0, 0.6}}}};

/// The normal of a relief on the plane, in the world, from the transforms of two directions on the
/// relief.
Vec3 reliefNormal(const ObjectTransform& transform, const Vec3& normal,
                  const std::array<float, 4>& gradient) {
  const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                 a[0] * b[1] - a[1] * b[0]};
  };
  const std::array<double, 3> n{double(normal[0]), double(normal[1]), double(normal[2])};
  const std::array<double, 3> first = cross(n, {0.3, -0.5, 0.8}), second = cross(n, first);
  const auto m = transform.linear();
  const auto moved = [&](const std::array<double, 3>& along) {
    double rise = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      rise += along[k] * double(gradient[k]);
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        result[i] += m[i][k] * (along[k] + rise * n[k]);
    return result;
  };
  const std::array<double, 3> out = cross(moved(first), moved(second));
  const double length = std::hypot(out[0], out[1], out[2]) * (out[2] < 0.0 ? -1.0 : 1.0);
  return {float(out[0] / length), float(out[1] / length), float(out[2] / length)};
}

} // namespace

TEST_CASE("colours in object space follow the object's transform") {
  const SyntheticMap map{3, 64, 48};
  BundleFile file = syntheticBundle(std::span(&map, 1));
  setParameters(file);
  const auto noise = NoiseEvaluator::create(file.bundle, *file.bundle.materials[0]).value();
  for (const Mover mover : {Mover::node, Mover::skin, Mover::morphTarget})
    for (std::size_t i = mover == Mover::node ? 0 : 3; i < kStands.size(); ++i) {
      const LinearImage drawn = onObject(file, kStands[i], mover, "base-color");
      double spread = 0.0;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const auto expected = noise->evaluate(0, onObject(kStands[i], x, y));
          INFO("mover " << int(mover) << ", transform " << i << ", pixel " << x << ", " << y);
          for (std::size_t c = 0; c < 3; ++c)
            REQUIRE(drawn.pixel(x, y)[c] == Approx(expected[c]).margin(1.0 / 255.0));
          spread += std::pow(double(expected[0]) - 0.5, 2) / (kWidth * kHeight);
        }
      CHECK(spread > 1e-3); // the noise is not constant
    }
}

TEST_CASE("relief in object space rotates, stretches and mirrors with the object") {
  BundleFile file = syntheticTextonBundle({.channels = 2, .wholeFloats = true});
  setParameters(file);
  const auto noise = NoiseEvaluator::create(file.bundle, *file.bundle.materials[0]).value();
  for (const Mover mover : {Mover::node, Mover::skin})
    for (std::size_t i = mover == Mover::node ? 0 : 2; i < kStands.size(); ++i) {
      const LinearImage drawn = onObject(file, kStands[i], mover, "normals");
      double tilt = 0.0;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const TriplanarFootprint at = onObject(kStands[i], x, y);
          const auto gradient = noise->evaluate(0, at);
          const Vec3 expected = reliefNormal(kStands[i], at.normal, gradient);
          // A vertex stores how far its skin stretches its normal, but not a sideways component.
          const bool isSkewed = mover == Mover::skin && i >= 3;
          const float margin = isSkewed ? 0.05f : 1.0f / 255.0f;
          INFO("mover " << int(mover) << ", transform " << i << ", pixel " << x << ", " << y);
          for (std::size_t k = 0; k < 3; ++k)
            REQUIRE(drawn.pixel(x, y)[k] == Approx(0.5f + 0.5f * expected[k]).margin(margin));
          tilt += double(1.0f - expected[2]) / (kWidth * kHeight);
        }
      CHECK(tilt > 0.002); // 3.6 degrees: the relief is visible
    }
}

TEST_CASE("when object and camera rotate together, noise looks the same in object space, but not "
          "in world space") {
  BundleFile file = syntheticTextonBundle({.channels = 3});
  for (const Mapping mapping : {Mapping::triplanar, Mapping::surface})
    for (const NoiseSpace space : {NoiseSpace::object, NoiseSpace::world}) {
      file.bundle.materials[0]->mapping = mapping;
      file.bundle.materials[0]->space = space;
      std::array<LinearImage, 2> drawn;
      for (std::size_t turned = 0; turned < 2; ++turned) {
        GltfScene scene(encodeGlb(file).value());
        scene.addBox(0, {{"rotation", {0.5, 0.1, 0.1, 0.85}}});
        scene.addCamera(6.0f, 0.5f);
        const std::size_t nodes = scene.json["nodes"].size();
        if (turned == 1) { // all of the picture
          scene.json["nodes"].push_back(
              {{"matrix", matrixOf(kStands[1])}, {"children", scene.json["scenes"][0]["nodes"]}});
          scene.json["scenes"][0]["nodes"] = {nodes};
        }
        renderer::RenderSettings settings = settingsOf(64, 64, 1);
        settings.debugView = "base-color";
        drawn[turned] = render(scene.glb(), settings);
      }
      int different = 0, all = 0;
      for (std::size_t i = 0; i < drawn[0].values.size(); ++i) {
        all += drawn[0].values[i] > 0.0f;
        different += std::abs(drawn[0].values[i] - drawn[1].values[i]) > 4.0f / 255.0f;
      }
      INFO(nameOf(mapping) << ", " << nameOf(space) << ": " << different << " of " << all);
      CHECK(all > 3 * 64 * 64 / 8);
      if (space == NoiseSpace::object)
        CHECK(different < all / 100); // edge pixels that only one of the two covers
      else
        CHECK(different > all / 2);
    }
}

TEST_CASE("triplanar colours follow the world position, whatever the mesh") {
  const SyntheticMap map{3, 64, 48};
  BundleFile file = syntheticBundle(std::span(&map, 1));
  setParameters(file);
  const LinearImage drawn = picture(file, "base-color");
  const auto noise = NoiseEvaluator::create(file.bundle, *file.bundle.materials[0]).value();
  double spread = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto expected = noise->evaluate(0, footprint(x, y));
      INFO("pixel " << x << ", " << y);
      for (std::size_t c = 0; c < 3; ++c) // half floats, and positions through two matrices
        REQUIRE(drawn.pixel(x, y)[c] == Approx(expected[c]).margin(1.0 / 255.0));
      spread += std::pow(double(expected[0]) - 0.5, 2) / (kWidth * kHeight);
    }
  CHECK(spread > 1e-3); // the noise is not constant
}

TEST_CASE("triplanar slopes tilt the normals of all six faces, and oblique ones, outwards") {
  BundleFile file = syntheticTextonBundle({.channels = 2, .wholeFloats = true});
  setParameters(file);
  const LinearImage drawn = picture(file, "normals");
  const auto noise = NoiseEvaluator::create(file.bundle, *file.bundle.materials[0]).value();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const TriplanarFootprint at = footprint(x, y);
      const auto gradient = noise->evaluate(0, at);
      // The gradient of a height over the surface, derived from the normal.
      double outward = 0.0, squares = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        outward += double(gradient[k]) * double(at.normal[k]);
      std::array<double, 3> normal{};
      for (std::size_t k = 0; k < 3; ++k) {
        normal[k] = double(at.normal[k]) - (double(gradient[k]) - outward * double(at.normal[k]));
        squares += normal[k] * normal[k];
      }
      INFO("pixel " << x << ", " << y);
      for (std::size_t k = 0; k < 3; ++k)
        REQUIRE(double(drawn.pixel(x, y)[k]) ==
                Approx(0.5 + 0.5 * normal[k] / std::sqrt(squares)).margin(1.0 / 255.0));
    }
}

TEST_CASE("the planes view shows each plane's share of the variance") {
  const SyntheticMap map{1, 16, 16};
  BundleFile file = syntheticBundle(std::span(&map, 1));
  setParameters(file);
  const LinearImage drawn = picture(file, "planes");
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const Vec3 normal = kNormals[std::size_t(y / kCell * kColumns + x / kCell)];
      const float greatest =
          std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
      Vec3 squares{};
      float sum = 0.0f;
      for (std::size_t k = 0; k < 3; ++k) { // decision 13, with the sharpness of setParameters()
        const float weight = std::pow(std::abs(normal[k]) / greatest, 3.0f) - 1.0f / 64.0f;
        squares[k] = std::pow(std::max(weight, 0.0f), 2.0f);
        sum += squares[k];
      }
      INFO("pixel " << x << ", " << y);
      for (std::size_t k = 0; k < 3; ++k)
        REQUIRE(drawn.pixel(x, y)[k] == Approx(squares[k] / sum).margin(1.0 / 255.0));
    }
}

TEST_CASE("two meshes that meet show one pattern without a seam, whatever their transforms") {
  const SyntheticMap map{3, 64, 48};
  BundleFile file = syntheticBundle(std::span(&map, 1));
  setParameters(file);
  for (const double far : {0.0, 1e7}) {
    INFO(far << " m away");
    const std::array<double, 3> origin{far, -0.5 * far, 0.25 * far};
    const ObjectTransform still{0.0f, {1.0f, 1.0f, 1.0f}, origin}; // vertices are floats
    const LinearImage whole = halves(file, {still, still}, origin);
    const ObjectTransform turned{
        1.1f, {0.5f, 0.5f, 0.5f}, {origin[0] - 2.0, origin[1] + 1.0, origin[2]}};
    const ObjectTransform stretched{
        -0.6f, {3.0f, 0.7f, 1.4f}, {origin[0], origin[1], origin[2] + 5.0}};
    const LinearImage parts = halves(file, {turned, stretched}, origin);
    double spread = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        INFO("pixel " << x << ", " << y);
        for (std::size_t c = 0; c < 3; ++c)
          REQUIRE(parts.pixel(x, y)[c] == Approx(whole.pixel(x, y)[c]).margin(1.0 / 255.0));
        spread += std::pow(double(whole.pixel(x, y)[0]) - 0.5, 2) / (kWidth * kHeight);
      }
    CHECK(spread > 1e-3); // the noise is not constant
  }
}
