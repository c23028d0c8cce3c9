// SPDX-License-Identifier: MIT
// Breaks every glTF rule that the renderer relies on once: the error names the JSON pointer.
#include "framing.h"
#include "loaded_scene.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstring>
#include <functional>
#include <limits>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

/// Skins the triangle to its own node, which leaves it in place.
void addSkin(GltfScene& scene) {
  const std::vector<float> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  json& accessors = scene.json["accessors"];
  accessors.push_back({{"bufferView", scene.addView(std::as_bytes(std::span(identity)))},
                       {"componentType", 5126},
                       {"type", "MAT4"},
                       {"count", 1}});
  scene.json["skins"] = {{{"joints", {0}}, {"inverseBindMatrices", accessors.size() - 1}}};
  scene.json["nodes"][0]["skin"] = 0;
}

/// A scene with one object of every kind that uses indices.
GltfScene fullScene() {
  GltfScene scene = triangleScene();
  const std::size_t texture = scene.addChecker(2, {1, 1, 1}, {0, 0, 0});
  scene.json["samplers"] = {{{"wrapS", 10497}}};
  scene.json["textures"][texture]["sampler"] = 0;
  scene.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
      {"index", texture},
      {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}, {"offset", {0, 0}}}}}}};
  scene.addCamera(3.0f, 0.7f);
  scene.addSun(3.0f);
  scene.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  scene.json["meshes"][0]["weights"] = {0.5};
  addSkin(scene);
  return scene;
}

/// One member of the full scene replaced, or removed where there is no value.
struct Fault {
  const char* what;
  const char* message; ///< a part of it, mostly the JSON pointer
  const char* member;  ///< JSON pointer of what is replaced
  json value = json::value_t::discarded;
};

constexpr const char* kPrimitive = "/meshes/0/primitives/0";

const std::vector<Fault> kFaults{
    {"no asset", "asset", "/asset"},
    {"glTF 1.0", "/asset", "/asset/version", "1.0"},
    {"a version that is a number", "/asset", "/asset/version", 2},
    {"a future minimum version", "/asset", "/asset/minVersion", "2.1"},
    {"an unknown required extension",
     "KHR_draco_mesh_compression",
     "/extensionsRequired",
     {"KHR_draco_mesh_compression"}},
    {"geometry compressed by meshoptimizer",
     "EXT_meshopt_compression",
     "/extensionsRequired",
     {"EXT_meshopt_compression"}},
    {"textures in KTX2", "KHR_texture_basisu", "/extensionsRequired", {"KHR_texture_basisu"}},
    {"nodes that are not an array", "/nodes", "/nodes", 3},
    {"a node that is not an object", "/nodes/0", "/nodes/0", "x"},
    {"a buffer longer than its chunk", "/buffers/0", "/buffers/0/byteLength", 1 << 20},
    {"a buffer of negative length", "/buffers/0", "/buffers/0/byteLength", -4},
    {"a second buffer without uri", "/buffers/1", "/buffers/-", {{"byteLength", 4}}},
    {"a buffer outside the folder",
     "/buffers/1: its file \"../x.bin\" is not in the scene's folder; copy it there",
     "/buffers/-",
     {{"byteLength", 4}, {"uri", "../x.bin"}}},
    {"an absolute buffer",
     "is not in the scene's folder",
     "/buffers/-",
     {{"byteLength", 4}, {"uri", "/etc/passwd"}}},
    {"a truncated data URI",
     "/buffers/1/byteLength: 64 bytes; available: 3",
     "/buffers/-",
     {{"byteLength", 64}, {"uri", "data:application/octet-stream;base64,AAAA"}}},
    {"a bufferView without a buffer", "/bufferViews/0", "/bufferViews/0/buffer", 1},
    {"a bufferView outside its buffer", "/bufferViews/0", "/bufferViews/0/byteOffset", 1u << 30},
    {"a bufferView whose end overflows", "/bufferViews/0", "/bufferViews/0/byteOffset",
     std::uint64_t(-8)},
    {"a stride of 2", "/bufferViews/0/byteStride: 2; expected a multiple of 4",
     "/bufferViews/0/byteStride", 2},
    {"a stride of 6", "/bufferViews/0/byteStride: 6; expected a multiple of 4",
     "/bufferViews/0/byteStride", 6},
    {"an accessor with a missing bufferView", "/accessors/0", "/accessors/0/bufferView", 99},
    {"a bufferView index of -1", "/accessors/0", "/accessors/0/bufferView", -1},
    {"a bufferView index of 4294967295", "/accessors/0", "/accessors/0/bufferView", 4294967295u},
    {"an accessor beyond its bufferView", "/accessors/0", "/accessors/0/count", 4},
    {"an accessor offset beyond its bufferView", "/accessors/0", "/accessors/0/byteOffset", 4},
    {"a count of 0", "/accessors/0", "/accessors/0/count", 0},
    {"a huge count", "/accessors/0", "/accessors/0/count", 4294967295u},
    {"a huge count without a bufferView",
     "/accessors/0",
     "/accessors/0",
     {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4000000000u}}},
    {"a fractional count", "/accessors/0", "/accessors/0/count", 2.5},
    {"an unknown component type", "/accessors/0", "/accessors/0/componentType", 5124},
    {"an unknown type", "/accessors/0", "/accessors/0/type", "VEC5"},
    {"positions of two components",
     "/meshes/0/primitives/0/attributes/POSITION: /accessors/0/type: \"VEC2\"; expected VEC3",
     "/accessors/0/type", "VEC2"},
    {"sparse values outside their bufferView",
     "/accessors/0/sparse",
     "/accessors/0/sparse",
     {{"count", 3},
      {"indices", {{"bufferView", 1}, {"componentType", 5125}}},
      {"values", {{"bufferView", 0}}}}},
    {"floats as indices", kPrimitive, "/meshes/0/primitives/0/indices", 0},
    {"attributes of different counts", "/meshes/0/primitives/0/attributes/NORMAL",
     "/accessors/2/count", 2},
    {"an attribute with a missing accessor", "/meshes/0/primitives/0/attributes",
     "/meshes/0/primitives/0/attributes/TEXCOORD_0", 17},
    {"a mode of 7", kPrimitive, "/meshes/0/primitives/0/mode", 7},
    {"no primitives", "/meshes/0", "/meshes/0/primitives"},
    {"empty primitives", "/meshes/0/primitives", "/meshes/0/primitives", json::array()},
    {"no attributes", kPrimitive, "/meshes/0/primitives/0/attributes"},
    {"a missing material", kPrimitive, "/meshes/0/primitives/0/material", 1},
    {"a missing texture", "/materials/0/pbrMetallicRoughness/baseColorTexture",
     "/materials/0/pbrMetallicRoughness/baseColorTexture/index", 5},
    {"a third set of texture coordinates", "/materials/0/pbrMetallicRoughness/baseColorTexture",
     "/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", 2},
    {"a texture transform of one number",
     "KHR_texture_transform",
     "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/scale",
     {2}},
    {"a rotation of a mix's mask that overflows a float",
     "/extensions/LICHEN_materials_exemplar_noise/mix/texture/extensions/KHR_texture_transform/"
     "rotation: 1e+300 is invalid",
     "/materials/0/extensions/LICHEN_materials_exemplar_noise/mix/texture/extensions/"
     "KHR_texture_transform/rotation",
     1e300},
    {"a base colour of three numbers",
     "/materials/0/pbrMetallicRoughness/baseColorFactor",
     "/materials/0/pbrMetallicRoughness/baseColorFactor",
     {1, 1, 1}},
    {"a roughness of 2", "/materials/0/pbrMetallicRoughness/roughnessFactor",
     "/materials/0/pbrMetallicRoughness/roughnessFactor", 2},
    {"a roughness that is a string", "/materials/0/pbrMetallicRoughness/roughnessFactor",
     "/materials/0/pbrMetallicRoughness/roughnessFactor", "rough"},
    {"an unknown alpha mode", "/materials/0", "/materials/0/alphaMode", "GLASS"},
    {"an image with a missing bufferView", "/images/0", "/images/0/bufferView", 77},
    {"an image without a source", "/images/0", "/images/0", json::object()},
    {"an image that is not an image file", "/images/0", "/images/0/bufferView", 0},
    {"a missing image file",
     "/images/0: its file \"absent.png\" cannot be read",
     "/images/0",
     {{"uri", "absent.png"}}},
    {"an empty image", "/images/0", "/images/0", {{"uri", "data:image/png;base64,"}}},
    {"a texture with a missing image", "/textures/0", "/textures/0/source", 2},
    {"a texture with a missing sampler", "/textures/0", "/textures/0/sampler", 2},
    {"an unknown wrap", "/samplers/0", "/samplers/0/wrapS", 1},
    {"a camera without a projection", "/cameras/0", "/cameras/0/perspective"},
    {"a camera whose near plane is not a number", "/cameras/0/perspective/znear",
     "/cameras/0/perspective/znear", "near"},
    {"a camera without a near plane", "/cameras/0/perspective", "/cameras/0/perspective/znear"},
    {"more materials than any scene has", "/materials", "/materials",
     std::vector<json>((1u << 18) + 1, json::object())},
    {"a light of unknown type", "/extensions/KHR_lights_punctual/lights/0",
     "/extensions/KHR_lights_punctual/lights/0/type", "area"},
    {"a node with a missing light", "/nodes/2/extensions",
     "/nodes/2/extensions/KHR_lights_punctual/light", 1},
    {"a node with a missing mesh", "/nodes/0", "/nodes/0/mesh", 1},
    {"a node with a missing child", "/nodes/0/children/0", "/nodes/0/children", {9}},
    {"a node that is its own child", "/nodes", "/nodes/0/children", {0}},
    {"a cycle of three nodes",
     "/nodes",
     "/nodes",
     {{{"mesh", 0}, {"children", {1}}}, {{"children", {2}}}, {{"children", {0}}}}},
    {"a node with two parents",
     "/nodes/1/children/0",
     "/nodes",
     {{{"mesh", 0}, {"children", {2}}}, {{"children", {2}}}, json::object()}},
    {"a scene whose node is a child", "/scenes/0/nodes/1", "/nodes/0/children", {1}},
    {"a scene with a node twice", "/scenes/0/nodes", "/scenes/0/nodes", {0, 0}},
    {"a scene that does not exist", "scene", "/scene", 1},
    {"a matrix of 15 numbers", "/nodes/0/matrix", "/nodes/0/matrix", std::vector<int>(15, 1)},
    {"a translation too large for a float",
     "/nodes/0/translation",
     "/nodes/0/translation",
     {1e300, 0, 0}},
    {"a missing joint", "/skins/0/joints/0", "/skins/0/joints", {40}},
    {"a skin without joints", "/skins/0", "/skins/0/joints"},
    {"a missing skin", "/nodes/0/skin", "/nodes/0/skin", 3},
    {"a weight that is a string", "/meshes/0/weights/0", "/meshes/0/weights", {"x"}},
    {"nothing to draw", "add a mesh with triangles", "/scenes/0/nodes", {1}},
};

/// Faults of the binary chunk, and those that take several changes.
struct OtherFault {
  const char* what;
  const char* message;
  std::function<void(GltfScene&)> breakIt;
};

/// Overwrites the first bytes of an accessor's bufferView.
template <class Value>
void overwrite(GltfScene& scene, std::size_t accessor, Value value) {
  const auto view = scene.json["accessors"][accessor]["bufferView"].get<std::size_t>();
  std::memcpy(scene.binary.data() +
                  scene.json["bufferViews"][view].value("byteOffset", std::size_t(0)),
              &value, sizeof value);
}

const std::vector<OtherFault> kOtherFaults{
    {"a sparse index outside its accessor", "/accessors/0",
     [](GltfScene& s) {
       const std::size_t view = s.addView(std::as_bytes(std::span("\7\0\0\0", 4)));
       s.json["accessors"][0]["sparse"] = {
           {"count", 1},
           {"indices", {{"bufferView", view}, {"componentType", 5125}}},
           {"values", {{"bufferView", 0}}}};
     }},
    {"an index beyond the vertices", "/accessors/1",
     [](GltfScene& s) { overwrite(s, 1, std::uint16_t(3)); }},
    {"NaN positions", "/accessors/0",
     [](GltfScene& s) { overwrite(s, 0, std::numeric_limits<float>::quiet_NaN()); }},
    {"infinite normals", "/accessors/2",
     [](GltfScene& s) { overwrite(s, 2, std::numeric_limits<float>::infinity()); }},
    {"scales that multiply to infinity", "transform",
     [](GltfScene& s) {
       s.json["nodes"][0]["scale"] = {1e30, 1, 1};
       s.json["nodes"].push_back({{"scale", {1e30, 1, 1}}, {"children", {0}}});
       s.json["scenes"][0]["nodes"] = {s.json["nodes"].size() - 1};
     }},
    {"no scene at all", "no scene",
     [](GltfScene& s) {
       s.json.erase("scenes");
       s.json.erase("scene");
     }},
    {"a joint outside the scene", "/skins/0/joints/0",
     [](GltfScene& s) {
       s.json["skins"][0]["joints"] = {s.json["nodes"].size()};
       s.json["nodes"].push_back(json::object());
     }},
    {"an edge whose squared length overflows a float",
     "a vertex is 1e+20 units from its mesh's origin; the limit is 1e+15",
     [](GltfScene& s) { overwrite(s, 0, 1e20f); }},
};

} // namespace

TEST_CASE("the scene without faults loads") {
  const renderer::Scene scene = loaded(fullScene());
  CHECK(scene.instances.size() == 1);
  CHECK(scene.cameras.size() == 1);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.images.size() == 1);
}

TEST_CASE("each broken scene gives one line with the file and the JSON pointer") {
  const TemporaryFolder folder;
  const auto check = [&](const char* what, const char* message, const GltfScene& broken) {
    INFO(what);
    const auto path = writeInto(folder, "broken.glb", broken.glb());
    const auto scene = renderer::readScene(path);
    REQUIRE_FALSE(scene.ok());
    INFO(scene.error().message);
    CHECK(scene.error().kind == ErrorKind::badInput);
    CHECK(scene.error().message.starts_with(path.string()));
    CHECK(scene.error().message.find(message) != std::string::npos);
    CHECK(scene.error().message.find('\n') == std::string::npos);
  };
  for (const Fault& fault : kFaults) {
    GltfScene broken = fullScene();
    const json::json_pointer member(fault.member);
    if (fault.value.is_discarded())
      broken.json[member.parent_pointer()].erase(member.back());
    else
      broken.json[member] = fault.value;
    check(fault.what, fault.message, broken);
  }
  for (const OtherFault& fault : kOtherFaults) {
    GltfScene broken = fullScene();
    fault.breakIt(broken);
    check(fault.what, fault.message, broken);
  }
}

TEST_CASE("an unusable camera is an error only if it is chosen") {
  const json narrow{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}};
  const json flat{{"type", "orthographic"},
                  {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 1}, {"zfar", 2}}}};
  const auto with = [](json camera, const char* key, double value) {
    camera[camera["type"].get<std::string>()][key] = value;
    return camera;
  };
  const std::array<std::pair<json, std::string>, 8> faults{
      {{with(narrow, "znear", 0.0), "perspective/znear: 0 is out of range; expected 1e-06 or more"},
       {with(narrow, "znear", 1e-9),
        "perspective/znear: 1e-09 is out of range; expected 1e-06 or more"},
       {with(narrow, "zfar", 0.05),
        "perspective/zfar: 0.05 is out of range; expected more than znear (0.1)"},
       {with(narrow, "yfov", 3.2), "perspective/yfov: 3.2 is out of range; expected 1e-06 to 3.1"},
       {with(narrow, "aspectRatio", -1.0),
        "perspective/aspectRatio: -1 is out of range; expected 1e-06 or more"},
       {with(flat, "ymag", 0.0), "orthographic/ymag: 0 is out of range; expected 1e-06 or more"},
       {with(flat, "znear", -1.0), "orthographic/znear: -1 is out of range; expected 0 or more"},
       {with(flat, "zfar", 1.00000000001), "orthographic/zfar: 1.00000000001 is too close to znear "
                                           "(1); expected a distance of at least 1e-6 between "
                                           "the two, as 32-bit floats"}}};
  const TemporaryFolder folder;
  for (const auto& [camera, message] : faults) {
    INFO(message);
    GltfScene source = triangleScene();
    source.addCamera(4.0f, 0.6f);
    source.json["cameras"].push_back(camera);
    source.json["nodes"].push_back({{"camera", 1}, {"name", "odd"}});
    source.json["scenes"][0]["nodes"].push_back(source.json["nodes"].size() - 1);
    const auto path = writeInto(folder, "scene.glb", source.glb());
    const auto scene = renderer::readScene(path);
    REQUIRE(scene.ok());
    const renderer::Sphere subject = renderer::subjectOf(scene.value()).value();
    for (const char* choice : {"", "auto", "front"})
      CHECK(renderer::chooseCamera(scene.value(), subject, choice, 1.0f).ok());
    const auto odd = renderer::chooseCamera(scene.value(), subject, "odd", 1.0f);
    REQUIRE_FALSE(odd.ok());
    CHECK(odd.error().kind == ErrorKind::badInput);
    CHECK(odd.error().message == path.string() + ": /cameras/1/" + message);
  }
}

TEST_CASE("an aspect ratio or far plane of 0 counts as absent, with a note") {
  for (const std::string key : {"aspectRatio", "zfar"}) {
    GltfScene source = triangleScene();
    source.addCamera(4.0f, 0.6f);
    source.json["cameras"][0]["perspective"][key] = 0.0;
    const renderer::Scene scene = loaded(source);
    CHECK(scene.notes ==
          std::vector<std::string>{"/cameras/0/perspective/" + key +
                                   ": 0 is invalid and treated as absent; expected more than 0"});
    CHECK(scene.cameras[0].fault.empty());
  }
}
