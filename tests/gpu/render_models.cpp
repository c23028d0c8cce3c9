// SPDX-License-Identifier: MIT
// The glTF files of Debian's assimp-testmodels, valid and broken ones: the loader reads each with
// all its content, or reports an error.
#include "rendered.h"

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
  std::string note = "";     ///< start of the only note; empty for none
};

const std::string kGenerated = "glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_";
const char* const kNoAnimations = "animations are ignored";

// A short script counted instances and triangles in the files' JSON.
const std::map<std::string, Model> kGood{
    {"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", {115, 121496}},
    {"glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb", {1, 12}},
    {"glTF2/BoxTexcoords-glTF/boxTexcoords.gltf", {1, 12}},
    {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", {1, 12}},
    {"glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", {1, 12}},
    {"glTF2/BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf",
     {1, 12, "the extension KHR_materials_pbrSpecularGlossiness is ignored"}},
    {"glTF2/BoxTextured-glTF/BoxTextured.gltf", {1, 12}},
    {"glTF2/ClearCoat-glTF/ClearCoatTest.gltf",
     {27, 37116, "the extension KHR_materials_clearcoat is ignored"}},
    {"glTF2/cameras/Cameras.gltf", {1, 2}},
    {kGenerated + "04.gltf", {1, 2}},
    {kGenerated + "05.gltf", {1, 2}},
    {kGenerated + "06.gltf", {1, 2}},
    {kGenerated + "11.gltf", {1, 2}},
    {kGenerated + "12.gltf", {1, 2}},
    {kGenerated + "13.gltf", {1, 2}},
    {kGenerated + "14.gltf", {1, 2}},
    {kGenerated + "15.gltf", {1, 2}},
    {"glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf",
     {1, 12, kNoAnimations}},
    {"glTF2/issue_3269/texcoord_crash.gltf", {5, 10}},
    {"glTF2/simple_skin/simple_skin.gltf", {1, 8, kNoAnimations}},
    {"glTF2/textureTransform/TextureTransformTest.gltf", {12, 24}},
    {"glTF2/wrongTypes/badString.gltf", {1, 12}}, // an unused scene name
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
