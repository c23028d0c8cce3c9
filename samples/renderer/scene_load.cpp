// SPDX-License-Identifier: MIT
// Loads a validated glTF file with tinygltf into the renderer's scene.
#include "gltf_file.h"
#include "material_load.h"
#include "node_walk.h"
#include "printable.h"
#include "scene.h"
#include "scene_validate.h"

#include <lichen/files.h>

#include <tiny_gltf.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <new>
#include <span>

namespace lichen::renderer {
namespace {

// ---- tinygltf's callbacks --------------------------------------------------------------------

/// Stores the encoded bytes of an image file or data URI, and adds their size to `total`, the sum
/// over all images. Decoding waits until the materials say which images they use, and as what.
/// Images in a bufferView stay there.
bool storeImageBytes(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                     const unsigned char* bytes, int size, void* total) {
  image->as_is = true;
  if (image->bufferView >= 0)
    return true;
  auto& sum = *static_cast<std::size_t*>(total);
  sum += std::size_t(size);
  if (sum > kMaxImageBytes)
    return false;
  image->image.assign(bytes, bytes + size);
  return true;
}

/// The file in the scene's folder that a decoded URI names.
std::optional<std::filesystem::path> fileInSceneFolder(void* scenePath, const std::string& name) {
  return fileInside(folderOf(*static_cast<const std::filesystem::path*>(scenePath)), name);
}

bool fileExists(const std::string& name, void* scenePath) {
  const auto file = fileInSceneFolder(scenePath, name);
  std::error_code ignored;
  return file && std::filesystem::is_regular_file(*file, ignored);
}

std::string sameName(const std::string& name, void*) { return name; }

bool readWholeFile(std::vector<unsigned char>* out, std::string* error, const std::string& name,
                   void* scenePath) {
  const auto file = fileInSceneFolder(scenePath, name);
  // tinygltf's callbacks take sizes as int.
  Result<std::vector<std::byte>> bytes =
      file ? readFile(*file, std::numeric_limits<int>::max())
           : Error{ErrorKind::badInput, printable(name) + ": is outside the scene's folder"};
  if (!bytes) {
    *error += bytes.error().message;
    return false;
  }
  const auto* begin = reinterpret_cast<const unsigned char*>(bytes.value().data());
  out->assign(begin, begin + bytes.value().size());
  return true;
}

/// Converts tinygltf's multi-line error report into one sentence.
std::string loadFailure(std::string report) {
  constexpr std::string_view kAbsent = "File not found : ";
  if (const std::size_t at = report.find(kAbsent); at != std::string::npos) {
    const std::size_t name = at + kAbsent.size();
    return "names the file \"" + printable(report.substr(name, report.find('\n', name) - name)) +
           "\", which is not in the scene's folder";
  }
  while (report.ends_with('\n'))
    report.pop_back();
  for (std::size_t at; (at = report.find('\n')) != std::string::npos;)
    report.replace(at, 1, "; ");
  return "cannot load the scene: " + printable(report, 160);
}

Result<tinygltf::Model> loadModel(GltfFile& file) {
  tinygltf::TinyGLTF loader;
  std::size_t imageBytes = 0;
  loader.SetImageLoader(storeImageBytes, &imageBytes);
  loader.SetFsCallbacks({fileExists, sameName, readWholeFile, nullptr, &file.path});
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const auto size = static_cast<unsigned int>(file.bytes.size());
  const auto* text = reinterpret_cast<const char*>(file.bytes.data());
  const auto* bytes = reinterpret_cast<const unsigned char*>(file.bytes.data());
  // The callbacks resolve file names themselves, so tinygltf gets no base folder.
  const bool loaded = file.container.isGlb
                          ? loader.LoadBinaryFromMemory(&model, &error, &warning, bytes, size, "")
                          : loader.LoadASCIIFromString(&model, &error, &warning, text, size, "");
  if (imageBytes > kMaxImageBytes)
    return Error{ErrorKind::resources, "/images: more than " + std::to_string(kMaxImageBytes) +
                                           " bytes of image files in total; use smaller images"};
  if (!loaded)
    return Error{ErrorKind::badInput, loadFailure(error)};
  for (const tinygltf::BufferView& view : model.bufferViews)
    if (view.byteOffset + view.byteLength > model.buffers[std::size_t(view.buffer)].data.size())
      return Error{ErrorKind::badInput, "a buffer is shorter than its byteLength"};
  return model;
}

/// The bundle for the noise plugin: the file itself if it contains all its buffers, else a GLB of
/// its JSON with all buffers concatenated.
std::vector<std::byte> noiseBundle(GltfFile& file, const tinygltf::Model& model) {
  if (file.container.isGlb && model.buffers.size() == 1 && model.buffers[0].uri.empty())
    return std::move(file.bytes);
  nlohmann::json json = file.container.document;
  std::vector<std::byte> binary;
  std::vector<std::size_t> offsets;
  for (const tinygltf::Buffer& buffer : model.buffers) {
    offsets.push_back(binary.size());
    const auto bytes = std::as_bytes(std::span(buffer.data));
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

Result<Scene> loadScene(GltfFile& file) {
  Scene scene;
  scene.name = file.path.string();
  if (Result<void> valid = validateScene(file, scene.notes); !valid)
    return valid.error();
  const auto named = [&](Error error) {
    error.message = file.path.string() + ": " + error.message;
    return error;
  };
  Result<tinygltf::Model> model = loadModel(file);
  if (!model)
    return named(model.error());
  if (Result<void> materials = readMaterials(model.value(), scene); !materials)
    return named(materials.error());
  if (Result<void> walked = walkNodes(model.value(), scene); !walked)
    return named(walked.error());
  std::sort(scene.notes.begin(), scene.notes.end());
  scene.notes.erase(std::unique(scene.notes.begin(), scene.notes.end()), scene.notes.end());
  const auto hasNoise = [](const Material& material) { return material.hasNoise; };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), hasNoise))
    scene.noiseBundle = noiseBundle(file, model.value());
  return scene;
}

/// Loads the file that `open` returns, and converts exceptions into errors.
Result<Scene> loadFrom(const std::filesystem::path& path,
                       const std::function<Result<GltfFile>()>& open) {
  try {
    Result<GltfFile> file = open();
    if (!file)
      return file.error();
    return loadScene(file.value());
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, path.string() + ": not enough memory for the scene"};
  } catch (const std::exception& fault) { // from nlohmann::json and from containers inside tinygltf
    return Error{ErrorKind::badInput,
                 path.string() + ": cannot load the scene: " + printable(fault.what(), 160)};
  }
}

} // namespace

Result<Scene> readScene(const std::filesystem::path& path) {
  return loadFrom(path, [&] { return readGltfFile(path); });
}

Result<Scene> parseScene(std::vector<std::byte> bytes, const std::filesystem::path& path) {
  return loadFrom(path, [&] { return openGltfFile(std::move(bytes), path); });
}

} // namespace lichen::renderer
