// SPDX-License-Identifier: MIT
// A glTF file -> the renderer's scene. The file is hostile: every value is checked where it is
// read.
#include "material_load.h"
#include "node_walk.h"
#include "printable.h"
#include "scene_file.h"

#include <lichen/files.h>
#include <lichen/gltf_files.h>

#include <algorithm>
#include <array>
#include <new>

namespace lichen::renderer {
namespace {

constexpr std::array<const char*, 5> kSupportedExtensions{
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_mesh_quantization",
    "KHR_texture_transform", kExtensionName.data()};

/// Calls `visit` for each unsupported name of a list of extensions.
void eachUnsupported(const Place& root, const char* list,
                     const std::function<void(const Place&, const std::string&)>& visit) {
  root.each(list, [&](const Place& place, std::size_t) {
    if (!place.json().is_string())
      place.fail("expected a string");
    const auto name = place.json().get<std::string>();
    if (std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), name) ==
        kSupportedExtensions.end())
      visit(place, printable(name));
  });
}

void checkHeader(const Place& root, std::vector<std::string>& notes) {
  if (const auto minimum = root.member("asset").string("minVersion"); minimum && *minimum != "2.0")
    root.member("asset").fail("minVersion " + printable(*minimum) +
                              " is not supported; expected 2.0");
  eachUnsupported(root, "extensionsRequired", [](const Place& place, const std::string& name) {
    std::string list;
    for (const char* supported : kSupportedExtensions)
      list += std::string(list.empty() ? "" : ", ") + supported;
    place.fail("the required extension " + name +
               " is not supported; export without it (supported: " + list + ")");
  });
  eachUnsupported(root, "extensionsUsed", [&](const Place&, const std::string& name) {
    notes.push_back("the extension " + name + " is ignored");
  });
  if (root.find("animations"))
    notes.push_back("animations are ignored; the scene is rendered in its rest pose");
}

/// A GLB for the noise plugin: the file itself if it contains all its buffers, else its JSON with
/// all buffers concatenated.
std::vector<std::byte> noiseBundle(SceneFile& file) {
  const std::size_t count = file.root().countOf("buffers");
  if (file.gltf().container().isGlb && count == 1 && !file.element("buffers", 0).find("uri"))
    return file.takeBytes();
  nlohmann::json json = file.root().json();
  std::vector<std::byte> binary;
  std::vector<std::size_t> offsets;
  FindingList none; // checkBuffers() has found no fault
  for (std::size_t i = 0; i < count; ++i) {
    offsets.push_back(binary.size());
    const std::span<const std::byte> bytes = *file.gltf().wholeBuffer(i, none);
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    constexpr std::size_t kAlignment = 16; // bytes; enough for any type in a bufferView
    binary.resize((binary.size() + kAlignment - 1) / kAlignment * kAlignment);
  }
  for (nlohmann::json& view : json["bufferViews"]) {
    view["byteOffset"] =
        view.value("byteOffset", std::size_t(0)) + offsets[view["buffer"].get<std::size_t>()];
    view["buffer"] = 0;
  }
  json["buffers"] = {{{"byteLength", binary.size()}}};
  return frameGlb(json.dump(), binary);
}

Scene loadScene(SceneFile& file) {
  Scene scene;
  scene.name = file.path().string();
  checkHeader(file.root(), scene.notes);
  (void)file.index(file.root(), "scene", "scenes");
  file.checkBuffers();
  readMaterials(file, scene);
  walkNodes(file, scene);
  std::sort(scene.notes.begin(), scene.notes.end());
  scene.notes.erase(std::unique(scene.notes.begin(), scene.notes.end()), scene.notes.end());
  const auto hasNoise = [](const Material& material) { return material.hasNoise; };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), hasNoise))
    scene.noiseBundle = noiseBundle(file);
  return scene;
}

} // namespace

Result<Scene> readScene(const std::filesystem::path& path) {
  Result<std::vector<std::byte>> bytes = readFile(path);
  return bytes ? parseScene(std::move(bytes).value(), path) : bytes.error();
}

Result<Scene> parseScene(std::vector<std::byte> bytes, const std::filesystem::path& path) {
  try {
    SceneFile file(std::move(bytes), path);
    return loadScene(file);
  } catch (const Fault& fault) {
    return Error{fault.kind, path.string() + ": " + fault.message};
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, path.string() + ": not enough memory for the scene"};
  }
}

} // namespace lichen::renderer
