// SPDX-License-Identifier: MIT
// Rendered noise without texture coordinates: each pixel against C++ at its position, for triplanar
// and surface mapping, in world and object space, for normals along all axes and oblique ones, on
// objects of any transform, near the world's origin and far from it.
#include "rendered.h"
#include "scene_renderer.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/noise_evaluator.h>

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;

namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;

constexpr int kCell = 16, kColumns = 4, kRows = 2; // cells of a picture, in pixels and in number
constexpr int kWidth = kColumns * kCell, kHeight = kRows * kCell;
constexpr float kDistance = 3.0f, kFieldOfView = 0.3f;
constexpr double kLevel = 1.0 / 255.0; // half floats, and positions through two matrices
const double kPixel = 2.0 * double(kDistance) * std::tan(double(kFieldOfView) / 2.0) / kHeight;

const std::vector<dvec3> kHome{dvec3(0.0)};
const std::vector<dvec3> kPlaces{{0, 0, 0},
                                 {12.3, -45.6, 7.8},
                                 {1e5 + 0.3, 2e5 - 0.7, -3e5 + 0.1},
                                 {-1234567.8, 1e6, 7654.3},
                                 {1e7 + 0.1, -2e7 + 0.2, 3e7 + 0.3}};

/// Rotates around an axis through opposite corners of a cube, after scaling, and then moves.
dmat4 standing(double turn, dvec3 scale, dvec3 move) {
  return glm::scale(glm::rotate(glm::translate(dmat4(1.0), move), turn, dvec3(1.0)), scale);
}

const std::array<dmat4, 5> kStands{dmat4(1.0), standing(1.1, dvec3(1.0), {0.4, -0.3, 0.2}),
                                   standing(-0.8, dvec3(2.0), {0.0, 1.0, -0.5}),
                                   standing(0.7, {0.5, 1.6, 1.0}, {0.1, 0.2, 0.3}),
                                   standing(2.3, {-1.0, 0.7, 1.5}, {-0.2, 0.0, 0.6})};

/// What transforms an object.
enum class Mover { node, skin };

/// A square that faces the camera, with a normal of its own.
struct Cell {
  dvec3 normal{0.0, 0.0, 1.0};
  std::size_t stand = 0; ///< index of its object's transform
  Mover mover = Mover::node;
};

/// Normals along all axes and oblique ones, on objects of different transforms that meet.
std::vector<Cell> normalsOnObjects() {
  const std::array<dvec3, 8> normals{{{1, 0, 0},
                                      {-1, 0, 0},
                                      {0, 1, 0},
                                      {0, -1, 0},
                                      {0, 0, 1},
                                      {0, 0, -1},
                                      {std::sqrt(0.5), 0, -std::sqrt(0.5)},
                                      {-2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0}}};
  std::vector<Cell> cells;
  for (std::size_t k = 0; k < normals.size(); ++k)
    cells.push_back({normals[k], k % 4});
  return cells;
}

/// A direction on the surface.
dvec3 tangentOf(const dvec3& normal) {
  return glm::normalize(glm::cross(normal, dvec3(0.3, -0.5, 0.8)));
}

struct Drawing {
  const char* what;
  Mapping mapping = Mapping::triplanar;
  NoiseSpace space = NoiseSpace::world;
  bool hasSlopes = false; ///< else colours
  std::vector<Cell> cells;
  std::vector<dvec3> places = kHome; ///< where the cells are, each time
  bool fromBehind = false;

  [[nodiscard]] BundleFile file() const {
    const SyntheticMap colors{3, 64, 48};
    BundleFile made =
        hasSlopes || mapping == Mapping::surface
            ? syntheticTextonBundle({.channels = hasSlopes ? 2 : 3, .wholeFloats = true})
            : syntheticBundle(std::span(&colors, 1));
    MaterialNoise& use = *made.bundle.materials[0];
    use.mapping = mapping;
    use.space = space;
    use.rotation = 0.4;
    use.scale = 2.0;
    use.seed = 3;
    use.planeSharpness = 3.0;
    made.bundle.noises[0].tileSizeMetres = 0.3; // not exactly representable as a float
    return made;
  }
};

std::vector<float> floats(const std::vector<dvec3>& values) {
  std::vector<float> result;
  for (const dvec3& value : values)
    result.insert(result.end(), {float(value.x), float(value.y), float(value.z)});
  return result;
}

nlohmann::json matrixOf(const dmat4& matrix) {
  return std::vector<double>(&matrix[0][0], &matrix[0][0] + 16);
}

/// Adds a skin with one joint, with this transform, to the last mesh.
void addSkin(GltfScene& scene, const dmat4& transform) {
  scene.json["nodes"].back()["skin"] = scene.json["skins"].size();
  scene.json["nodes"].push_back({{"matrix", matrixOf(transform)}});
  const std::size_t joint = scene.json["nodes"].size() - 1;
  scene.json["scenes"][0]["nodes"].push_back(joint);
  scene.json["skins"].push_back({{"joints", {joint}}});
}

/// Adds the square whose lower left corner is here in the world.
void addCell(GltfScene& scene, const Drawing& drawing, const Cell& cell, const dmat4& stand,
             const dvec3& corner) {
  const dmat3 linear(stand);
  const dmat4 back = glm::inverse(stand);
  const std::vector<dvec3> normals(4, glm::normalize(glm::transpose(linear) * cell.normal));
  std::vector<dvec3> positions;
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    const dvec3 world = corner + kCell * kPixel * dvec3(right, up, 0.0);
    positions.emplace_back(back * glm::dvec4(world, 1.0));
  }
  nlohmann::json attributes{{"POSITION", scene.addFloats(floats(positions), 3)},
                            {"NORMAL", scene.addFloats(floats(normals), 3)}};
  if (drawing.mapping == Mapping::surface) {
    const dvec3 tangent = glm::normalize(glm::inverse(linear) * tangentOf(cell.normal));
    std::vector<float> tangents;
    for (int vertex = 0; vertex < 4; ++vertex)
      tangents.insert(tangents.end(), {float(tangent.x), float(tangent.y), float(tangent.z), 1.0f});
    attributes["TANGENT"] = scene.addFloats(tangents, 4);
  }
  const bool isMirrored = glm::determinant(linear) < 0.0;
  const std::vector<std::uint32_t> corners = isMirrored != drawing.fromBehind
                                                 ? std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2}
                                                 : std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
  nlohmann::json node = nlohmann::json::object();
  if (cell.mover == Mover::node)
    node["matrix"] = matrixOf(stand);
  scene.addMesh(attributes, scene.addIndices(corners, 1), 0, node);
  if (cell.mover == Mover::skin)
    addSkin(scene, stand);
}

/// A picture of the cells at each place, by one camera that moves between them.
std::vector<LinearImage> draw(const Drawing& drawing, const char* view) {
  GltfScene source(encodeGlb(drawing.file()).value());
  source.json["materials"][0]["doubleSided"] = drawing.fromBehind;
  for (const dvec3& place : drawing.places) {
    for (std::size_t k = 0; k < drawing.cells.size(); ++k) {
      const int column = int(k) % kColumns, row = int(k) / kColumns;
      const Cell& cell = drawing.cells[k];
      addCell(source, drawing, cell, glm::translate(dmat4(1.0), place) * kStands[cell.stand],
              place + kCell * kPixel * dvec3(column - kColumns / 2, kRows / 2 - row - 1, 0));
    }
    source.addCamera(kDistance, kFieldOfView);
    source.json["nodes"].back()["translation"] = {place.x, place.y, place.z + double(kDistance)};
  }
  source.addSun(3.0f); // same sun as in the other scenes, so that the cached sky is reused
  const renderer::Scene scene = loaded(source);
  renderer::RenderSettings settings = settingsOf(kWidth, kHeight, 1);
  settings.debugView = view;
  testDevice().messages().clear();
  renderer::SceneRenderer sceneRenderer(testDevice(), scene, settings);
  CHECK(sceneRenderer.notes().empty());
  std::vector<LinearImage> pictures;
  for (const renderer::Camera& camera : scene.cameras) {
    sceneRenderer.setCamera(camera);
    sceneRenderer.drawFrame(0);
    pictures.push_back(sceneRenderer.average(1));
  }
  for (const std::string& text : testDevice().messages().texts())
    FAIL_CHECK(text);
  return pictures;
}

std::array<float, 3> narrow(const dvec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// The footprint of a pixel at `position`, as its object or the world sees it.
template <class Footprint>
Footprint footprintAt(const Cell& cell, const dvec3& position, const dmat4& seen) {
  const dmat3 linear(seen);
  Footprint at;
  at.position = narrow(seen * glm::dvec4(position, 1.0));
  at.dx = narrow(linear * dvec3(kPixel, 0.0, 0.0));
  at.dy = narrow(linear * dvec3(0.0, -kPixel, 0.0));
  at.normal = narrow(glm::normalize(glm::transpose(glm::inverse(linear)) * cell.normal));
  if constexpr (requires { at.tangent; }) {
    const auto along = narrow(glm::normalize(linear * tangentOf(cell.normal)));
    at.tangent = {along[0], along[1], along[2], 1.0f};
  }
  return at;
}

/// The noise's value at a pixel of a cell. `rest` is what the placement leaves of the place.
std::array<float, 4> valueAt(const NoiseEvaluator& noise, const Drawing& drawing, const Cell& cell,
                             const dvec3& rest, int x, int y) {
  const dvec3 position((x + 0.5 - kWidth / 2) * kPixel, (kHeight / 2 - y - 0.5) * kPixel, 0.0);
  const bool inObject = drawing.space == NoiseSpace::object;
  const dmat4 seen =
      inObject ? glm::inverse(kStands[cell.stand]) : glm::translate(dmat4(1.0), rest);
  return drawing.mapping == Mapping::surface
             ? noise.evaluate(0, footprintAt<SurfaceFootprint>(cell, position, seen))
             : noise.evaluate(0, footprintAt<TriplanarFootprint>(cell, position, seen));
}

/// The normal of the relief in the world, from the transforms of two directions on the relief.
dvec3 reliefNormal(const Drawing& drawing, const Cell& cell, const std::array<float, 4>& value) {
  if (drawing.mapping == Mapping::surface) {
    const double turn = drawing.file().bundle.materials[0]->rotation;
    // From the exemplar's frame, with y up, to the tangent's frame.
    const double along = std::cos(turn) * double(value[0]) + std::sin(turn) * double(value[1]);
    const double up = std::cos(turn) * double(value[1]) - std::sin(turn) * double(value[0]);
    const dvec3 tangent = tangentOf(cell.normal);
    return glm::normalize(cell.normal - along * tangent - up * glm::cross(cell.normal, tangent));
  }
  const dmat3 linear =
      drawing.space == NoiseSpace::object ? dmat3(kStands[cell.stand]) : dmat3(1.0);
  const dvec3 normal = glm::normalize(glm::transpose(linear) * cell.normal);
  const dvec3 gradient(value[0], value[1], value[2]);
  const dvec3 first = tangentOf(normal), second = glm::cross(normal, first);
  const auto moved = [&](const dvec3& way) {
    return linear * (way + glm::dot(way, gradient) * normal);
  };
  const dvec3 out = glm::cross(moved(first), moved(second));
  return glm::normalize(glm::dot(out, cell.normal) < 0.0 ? -out : out);
}

void checkDrawing(const Drawing& drawing) {
  const std::vector<LinearImage> pictures =
      draw(drawing, drawing.hasSlopes ? "normals" : "base-color");
  const BundleFile file = drawing.file();
  const MaterialNoise& use = *file.bundle.materials[0];
  const double side = use.scale * file.bundle.noises[0].tileSizeMetres;
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    const dvec3 whole = glm::floor(drawing.places[p] / side);
    Placement origin;
    if (drawing.space == NoiseSpace::world) {
      origin.tileOriginX = std::int64_t(whole.x);
      origin.tileOriginY = std::int64_t(whole.y);
      origin.tileOriginZ = std::int64_t(whole.z);
    }
    const dvec3 rest = drawing.places[p] - side * whole;
    const auto noise = NoiseEvaluator::create(file.bundle, use, origin).value();
    origin.tileOriginX += 1;
    const auto nextTile = NoiseEvaluator::create(file.bundle, use, origin).value();
    double sum = 0.0, squares = 0.0, toNextTile = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const std::size_t k = std::size_t(y / kCell * kColumns + x / kCell);
        if (k >= drawing.cells.size())
          continue;
        const Cell& cell = drawing.cells[k];
        const auto value = valueAt(*noise, drawing, cell, rest, x, y);
        const dvec3 expected = drawing.hasSlopes ? 0.5 + 0.5 * reliefNormal(drawing, cell, value)
                                                 : dvec3(value[0], value[1], value[2]);
        INFO("place " << p << ", cell " << k << ", pixel " << x << ", " << y);
        for (int c = 0; c < 3; ++c)
          REQUIRE(double(pictures[p].pixel(x, y)[c]) == Approx(expected[c]).margin(kLevel));
        sum += double(value[0]);
        squares += std::pow(double(value[0]), 2);
        toNextTile +=
            std::abs(double(valueAt(*nextTile, drawing, cell, rest, x, y)[0]) - double(value[0]));
      }
    const double count = double(drawing.cells.size()) * kCell * kCell;
    CHECK(squares / count - std::pow(sum / count, 2) > 1e-4); // the noise is not constant
    CHECK(toNextTile / count > 2.0 * kLevel);
  }
}

const std::vector<Cell> kMovedByAll{{.stand = 0},
                                    {.stand = 1},
                                    {.stand = 2},
                                    {.stand = 3},
                                    {.stand = 4},
                                    {.stand = 2, .mover = Mover::skin},
                                    {.stand = 3, .mover = Mover::skin},
                                    {.stand = 4, .mover = Mover::skin}};

} // namespace

TEST_CASE("noise has the pattern of its position in the world or its object, at any distance") {
  using enum Mapping;
  using enum NoiseSpace;
  const Drawing drawings[] = {
      {"triplanar colours in the world", triplanar, world, false, normalsOnObjects(), kPlaces},
      {"triplanar relief in the world", triplanar, world, true, normalsOnObjects()},
      {"triplanar colours on objects", triplanar, object, false, kMovedByAll},
      {"colours of far objects", triplanar, object, false, {{.stand = 1}, {.stand = 3}}, kPlaces},
      {"triplanar relief on objects", triplanar, object, true, kMovedByAll},
      {"colours of surfaces in the world", surface, world, false, normalsOnObjects(), kPlaces},
      {"colours of surfaces from behind", surface, world, false, normalsOnObjects(), kHome, true},
      {"relief of surfaces in the world", surface, world, true, normalsOnObjects()},
      {"colours of surfaces on objects", surface, object, false, {{.stand = 1}, {.stand = 2}}}};
  for (const Drawing& drawing : drawings) {
    INFO(drawing.what);
    checkDrawing(drawing);
  }
}

TEST_CASE("the planes view shows each plane's share of the variance") {
  const Drawing drawing{.what = "planes", .cells = normalsOnObjects()};
  const LinearImage drawn = draw(drawing, "planes").front();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const dvec3 normal =
          glm::abs(drawing.cells[std::size_t(y / kCell * kColumns + x / kCell)].normal);
      const double greatest = std::max({normal.x, normal.y, normal.z});
      dvec3 squares;
      for (int k = 0; k < 3; ++k) // decision 13, with the sharpness of the material
        squares[k] = std::pow(std::max(std::pow(normal[k] / greatest, 3.0) - 1.0 / 64.0, 0.0), 2.0);
      INFO("pixel " << x << ", " << y);
      for (int k = 0; k < 3; ++k)
        REQUIRE(double(drawn.pixel(x, y)[k]) ==
                Approx(squares[k] / (squares.x + squares.y + squares.z)).margin(kLevel));
    }
}

TEST_CASE("a note names a mesh once if its noise needs tangents that it lacks") {
  const Drawing drawing{.what = "wall", .mapping = Mapping::surface};
  GltfScene scene(encodeGlb(drawing.file()).value());
  addCell(scene, drawing, {}, dmat4(1.0), dvec3(0.0));
  scene.json["meshes"][0]["name"] = "wall";
  scene.json["materials"][0]["name"] = "moss";
  CHECK(loaded(scene).notes.empty());
  nlohmann::json& primitives = scene.json["meshes"][0]["primitives"];
  primitives[0]["attributes"].erase("TANGENT");
  primitives.push_back(primitives[0]);
  CHECK(loaded(scene).notes ==
        std::vector<std::string>{"/meshes/0 \"wall\" has no TANGENT attribute, which the noise of "
                                 "its material \"moss\" follows; an arbitrary direction is used; "
                                 "add tangents with lichen apply"});
}
