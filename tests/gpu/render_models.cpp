// SPDX-License-Identifier: MIT
// The glTF files of Debian's assimp-testmodels, valid and broken ones: the loader reads each with
// all its content, or reports an error. One picture shows all valid ones side by side.
#include "rendered.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

using namespace lichen;
using namespace lichen::test;
using renderer::Scene;

namespace {

const std::filesystem::path kModels = "/usr/share/assimp/models";

/// Ends the program, as without a device, if the package is not installed.
void requireModels() {
  if (std::filesystem::is_directory(kModels))
    return;
  std::fprintf(stderr, "%s is not there; Debian's package assimp-testmodels has it\n",
               kModels.c_str());
  std::exit(kSkipped);
}

struct Model {
  std::size_t instances = 0; ///< instances of primitives
  std::size_t triangles = 0; ///< in all instances
  glm::vec3 color{0.0f};     ///< mean of the base colour in a cell of the sheet
  std::string note = "";     ///< start of the only note; empty for none
};

// A short script counted instances and triangles in the files' JSON. Colours are the material's
// colour times the share of its cell that the model covers; the model's longest side is kFill of
// the cell, and the rest is black. Colours given as plain numbers were measured, after inspecting
// the pictures.
constexpr float kFill = 0.9f;
constexpr float kSquare = kFill * kFill;
constexpr float kTilted = kSquare * 0.7071f; // tilted by 45 degrees
const std::string kGenerated = "glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_";
const char* const kNoAnimations = "animations are ignored";

/// Mean linear colour of CesiumLogoFlat.png, which fills the front of a cube.
constexpr glm::vec3 kLogo{0.404f, 0.524f, 0.564f};
constexpr glm::vec3 kWhite{1.0f};

glm::vec3 over(float share, glm::vec3 color = kWhite) { return share * color; }

const std::map<std::string, Model> kGood{
    {"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
     {115, 121496, {0.124f, 0.147f, 0.161f}}},
    {"glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb", {1, 12, over(kSquare, {0.8f, 0, 0})}},
    {"glTF2/BoxTexcoords-glTF/boxTexcoords.gltf", {1, 12, {0.513f, 0.684f, 0.512f}}},
    {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", {1, 12, over(kSquare, kLogo)}},
    {"glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", {1, 12, over(kSquare, kLogo)}},
    {"glTF2/BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf",
     {1, 12, over(kSquare, kLogo), "the extension KHR_materials_pbrSpecularGlossiness is ignored"}},
    {"glTF2/BoxTextured-glTF/BoxTextured.gltf", {1, 12, over(kSquare, kLogo)}},
    {"glTF2/ClearCoat-glTF/ClearCoatTest.gltf",
     {27, 37116, {0.021f, 0.005f, 0.021f}, "the extension KHR_materials_clearcoat is ignored"}},
    {"glTF2/cameras/Cameras.gltf", {1, 2, over(kTilted)}},
    {kGenerated + "04.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "05.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "06.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "11.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "12.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "13.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "14.gltf", {1, 2, over(kSquare)}},
    {kGenerated + "15.gltf", {1, 2, over(kSquare)}},
    {"glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf",
     {1, 12, over(kSquare, {0.6038f, 0.6038f, 0.6038f}), kNoAnimations}},
    {"glTF2/issue_3269/texcoord_crash.gltf", {5, 10, {0.252f, 0.279f, 0.139f}}},
    {"glTF2/simple_skin/simple_skin.gltf", {1, 8, over(kSquare / 2), kNoAnimations}},
    {"glTF2/textureTransform/TextureTransformTest.gltf", {12, 24, {0.219f, 0.293f, 0.291f}}},
    {"glTF2/wrongTypes/badString.gltf", {1, 12, over(kSquare, kLogo)}}, // an unused scene name
};

/// render_hostile_scenes.cpp has the messages.
const std::set<std::string> kBroken{kGenerated + "00.gltf",
                                    kGenerated + "01.gltf",
                                    kGenerated + "02.gltf",
                                    kGenerated + "03.gltf",
                                    kGenerated + "07.gltf",
                                    kGenerated + "08.gltf",
                                    kGenerated + "09.gltf",
                                    kGenerated + "10.gltf", // points and lines alone
                                    "glTF/BoxTextured-glTF-Binary/BoxTextured.glb",
                                    "glTF/BoxTextured-glTF-Embedded/BoxTextured.gltf",
                                    "glTF/BoxTextured-glTF-MaterialsCommon/BoxTextured.gltf",
                                    "glTF/BoxTextured-glTF/BoxTextured.gltf",
                                    "glTF/CesiumMilkTruck/CesiumMilkTruck.gltf",
                                    "glTF/IncorrectVertexArrays/Cube_v1.gltf",
                                    "glTF/TwoBoxes/TwoBoxes.gltf",
                                    "glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf",
                                    "glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb",
                                    "glTF2/IncorrectVertexArrays/Cube.gltf",
                                    "glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf",
                                    "glTF2/IndexOutOfRange/IndexOutOfRange.gltf",
                                    "glTF2/MissingBin/BoxTextured.gltf",
                                    "glTF2/RecursiveNodes/RecursiveNodes.gltf",
                                    "glTF2/SchemaFailures/sceneWrongType.gltf",
                                    "glTF2/TestNoRootNode/NoScene.gltf",
                                    "glTF2/TestNoRootNode/SceneWithoutNodes.gltf",
                                    "glTF2/draco/2CylinderEngine.gltf",
                                    "glTF2/wrongTypes/badArray.gltf",
                                    "glTF2/wrongTypes/badExtension.gltf",
                                    "glTF2/wrongTypes/badNumber.gltf",
                                    "glTF2/wrongTypes/badObject.gltf",
                                    "glTF2/wrongTypes/badUint.gltf"};

Scene modelOf(const std::string& name) {
  auto scene = renderer::readScene(kModels / name);
  if (!scene)
    FAIL(scene.error().message);
  return std::move(scene).value();
}

std::size_t triangleCount(const Scene& scene) {
  std::size_t indices = 0;
  for (const renderer::Instance& instance : scene.instances)
    indices += scene.primitives[instance.primitive].indices.size();
  return indices / 3;
}

/// Transform that centres a scene's bounding box in a cell of side 1 around (x, y, 0).
glm::mat4 cellFromWorld(const Scene& scene, glm::vec2 cell) {
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high = -low;
  for (const renderer::Instance& instance : scene.instances)
    for (const renderer::Vertex& v : scene.primitives[instance.primitive].vertices) {
      const glm::vec3 position(instance.worldFromObject * glm::dvec4(v.position, 1.0));
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
  const glm::vec3 size = high - low;
  const float scale = kFill / std::max(size.x, std::max(size.y, size.z));
  glm::mat4 matrix(scale);
  matrix[3] = glm::vec4(glm::vec3(cell, 0.0f) - scale * 0.5f * (low + high), 1.0f);
  return matrix;
}

void append(Scene& sheet, const Scene& scene, const glm::mat4& placed) {
  const std::size_t images = sheet.images.size();
  const std::size_t materials = sheet.materials.size();
  const std::size_t primitives = sheet.primitives.size();
  sheet.images.insert(sheet.images.end(), scene.images.begin(), scene.images.end());
  for (renderer::Material material : scene.materials) {
    for (renderer::TextureSlot* slot :
         {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
          &material.occlusionTexture, &material.emissiveTexture})
      if (slot->image)
        *slot->image += images;
    sheet.materials.push_back(material);
  }
  for (renderer::Primitive primitive : scene.primitives) {
    primitive.material += materials;
    sheet.primitives.push_back(std::move(primitive));
  }
  for (const renderer::Instance& instance : scene.instances)
    sheet.instances.push_back(
        {primitives + instance.primitive, glm::dmat4(placed) * instance.worldFromObject});
}

constexpr int kColumns = 6;
constexpr int kCellPixels = 40;

/// The base colours of all valid models, one per cell, in the order of their names.
LinearImage sheetOf(int rows) {
  Scene sheet;
  int index = 0;
  for (const auto& [name, model] : kGood) {
    const Scene scene = modelOf(name);
    const glm::vec2 cell(float(index % kColumns) + 0.5f, float(rows - index / kColumns) - 0.5f);
    append(sheet, scene, cellFromWorld(scene, cell));
    ++index;
  }
  renderer::Camera camera;
  camera.perspective = false;
  camera.halfHeight = float(rows) / 2;
  camera.aspectRatio = float(kColumns) / float(rows);
  camera.worldFromCamera[3] = glm::dvec4(kColumns / 2.0, rows / 2.0, 2, 1);
  camera.far = 4.0f;
  sheet.cameras.push_back(camera);
  renderer::RenderSettings settings =
      settingsOf(kColumns * kCellPixels, std::uint32_t(rows * kCellPixels), 4);
  settings.debugView = "base-color";
  testDevice().messages().clear();
  auto picture = renderer::renderScene(testDevice(), sheet, settings);
  if (!picture)
    FAIL(picture.error().message);
  for (const std::string& text : testDevice().messages().texts())
    FAIL_CHECK(text);
  return std::move(picture.value().pixels);
}

glm::vec3 meanOfCell(const LinearImage& sheet, int index) {
  glm::vec3 sum(0.0f);
  for (int y = 0; y < kCellPixels; ++y)
    for (int x = 0; x < kCellPixels; ++x) {
      const std::size_t row = std::size_t(index / kColumns * kCellPixels + y);
      const std::size_t column = std::size_t(index % kColumns * kCellPixels + x);
      const float* pixel = &sheet.values[3 * (row * std::size_t(sheet.width) + column)];
      sum += glm::vec3(pixel[0], pixel[1], pixel[2]);
    }
  return sum / float(kCellPixels * kCellPixels);
}

} // namespace

TEST_CASE("this test covers every file of the package") {
  requireModels();
  std::set<std::string> found;
  for (const char* folder : {"glTF", "glTF2"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kModels / folder))
      if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
        found.insert(std::filesystem::relative(entry.path(), kModels).string());
  for (const std::string& name : found) {
    INFO(name);
    CHECK(kGood.count(name) + kBroken.count(name) == 1);
  }
  CHECK(found.size() == kGood.size() + kBroken.size());
}

TEST_CASE("each valid file loads completely, with a note for everything that is ignored") {
  requireModels();
  for (const auto& [name, model] : kGood) {
    INFO(name);
    const Scene scene = modelOf(name);
    CHECK(scene.instances.size() == model.instances);
    CHECK(triangleCount(scene) == model.triangles);
    CHECK(scene.notes.size() == (model.note.empty() ? 0 : 1));
    if (!scene.notes.empty())
      CHECK(scene.notes[0].starts_with(model.note));
  }
}

TEST_CASE("each broken file gives one line that names it") {
  requireModels();
  for (const std::string& name : kBroken) {
    INFO(name);
    const auto scene = renderer::readScene(kModels / name);
    REQUIRE_FALSE(scene.ok());
    CHECK(scene.error().kind == ErrorKind::badInput);
    CHECK(scene.error().message.starts_with((kModels / name).string() + ": "));
    CHECK(scene.error().message.find('\n') == std::string::npos);
  }
}

TEST_CASE("the valid files, rendered side by side, have the expected colours") {
  requireModels();
  const int rows = (int(kGood.size()) + kColumns - 1) / kColumns;
  const LinearImage sheet = sheetOf(rows);
  // A model's edge may lie anywhere in one of 36 pixels; four frames locate it to a quarter of a
  // pixel.
  constexpr float kTolerance = 0.01f;
  int index = 0;
  for (const auto& [name, model] : kGood) {
    INFO(name);
    const glm::vec3 mean = meanOfCell(sheet, index++);
    for (int c = 0; c < 3; ++c)
      CHECK(mean[c] == Approx(model.color[c]).margin(kTolerance));
  }
}
