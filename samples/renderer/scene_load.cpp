// SPDX-License-Identifier: MIT
// A validated glTF file through tinygltf into the renderer's scene: nodes, meshes, cameras, lights.
#include "geometry.h"
#include "gltf_file.h"
#include "material_load.h"
#include "orthonormal_frame.h"
#include "printable.h"
#include "scene.h"
#include "scene_validate.h"

#include <lichen/files.h>

#include <glm/gtc/quaternion.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <span>

namespace lichen::renderer {
namespace {

// ---- tinygltf's callbacks --------------------------------------------------------------------

/// Keeps the bytes of a file or data URI, whose sum over all images is `total`: which of them are
/// decoded, and as what, is decided by the materials. Those of a bufferView stay in their buffer.
bool keepImageBytes(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
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

/// The file beside the scene that a decoded URI names.
std::optional<std::filesystem::path> fileBeside(void* scenePath, const std::string& name) {
  return fileInside(folderOf(*static_cast<const std::filesystem::path*>(scenePath)), name);
}

bool fileExists(const std::string& name, void* scenePath) {
  const auto file = fileBeside(scenePath, name);
  std::error_code ignored;
  return file && std::filesystem::is_regular_file(*file, ignored);
}

std::string sameName(const std::string& name, void*) { return name; }

bool readWholeFile(std::vector<unsigned char>* out, std::string* error, const std::string& name,
                   void* scenePath) {
  const auto file = fileBeside(scenePath, name);
  // tinygltf counts bytes with int in its callbacks.
  Result<std::vector<std::byte>> bytes =
      file ? readFile(*file, std::numeric_limits<int>::max())
           : Error{ErrorKind::badInput, printable(name) + ": leads out of the scene's folder"};
  if (!bytes) {
    *error += bytes.error().message;
    return false;
  }
  const auto* begin = reinterpret_cast<const unsigned char*>(bytes.value().data());
  out->assign(begin, begin + bytes.value().size());
  return true;
}

/// tinygltf's report of why it could not load a scene, lines of text, as one sentence.
std::string whyNotLoaded(std::string report) {
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
  return "cannot be loaded: " + printable(report, 160);
}

Result<tinygltf::Model> loadModel(GltfFile& file) {
  tinygltf::TinyGLTF loader;
  std::size_t imageBytes = 0;
  loader.SetImageLoader(keepImageBytes, &imageBytes);
  loader.SetFsCallbacks({fileExists, sameName, readWholeFile, nullptr, &file.path});
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const auto size = static_cast<unsigned int>(file.bytes.size());
  const auto* text = reinterpret_cast<const char*>(file.bytes.data());
  const auto* bytes = reinterpret_cast<const unsigned char*>(file.bytes.data());
  // The callbacks find files beside the scene, so tinygltf is given no folder of its own.
  const bool loaded = file.container.isGlb
                          ? loader.LoadBinaryFromMemory(&model, &error, &warning, bytes, size, "")
                          : loader.LoadASCIIFromString(&model, &error, &warning, text, size, "");
  if (imageBytes > kMaxImageBytes)
    return Error{ErrorKind::resources, "/images: more than " + std::to_string(kMaxImageBytes) +
                                           " bytes of files in all; smaller images are accepted"};
  if (!loaded)
    return Error{ErrorKind::badInput, whyNotLoaded(error)};
  for (const tinygltf::BufferView& view : model.bufferViews)
    if (view.byteOffset + view.byteLength > model.buffers[std::size_t(view.buffer)].data.size())
      return Error{ErrorKind::badInput, "a buffer is shorter than its byteLength"};
  return model;
}

// ---- nodes -----------------------------------------------------------------------------------

glm::mat4 localMatrix(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    glm::mat4 matrix(1.0f);
    for (int i = 0; i < 16; ++i)
      matrix[i / 4][i % 4] = float(node.matrix[std::size_t(i)]);
    return matrix;
  }
  const auto vec3 = [](const std::vector<double>& v, glm::vec3 absent) {
    return v.size() == 3 ? glm::vec3(v[0], v[1], v[2]) : absent;
  };
  const glm::vec3 scale = vec3(node.scale, glm::vec3(1.0f));
  glm::mat4 matrix(1.0f);
  if (node.rotation.size() == 4) {
    const glm::quat q{float(node.rotation[3]), float(node.rotation[0]), float(node.rotation[1]),
                      float(node.rotation[2])};
    if (glm::length(q) > 0.0f)
      matrix = glm::mat4_cast(glm::normalize(q));
  }
  for (int i = 0; i < 3; ++i)
    matrix[i] *= scale[i];
  matrix[3] = glm::vec4(vec3(node.translation, glm::vec3(0.0f)), 1.0f);
  return matrix;
}

/// Position and rotation of a node, without its scale: cameras and lights ignore that.
glm::mat4 rigid(const glm::mat4& m) {
  const glm::vec3 back = glm::vec3(m[2]);
  const glm::vec3 z = glm::length(back) > 0.0f ? glm::normalize(back) : glm::vec3(0, 0, 1);
  const glm::vec3 up = glm::vec3(m[1]) - z * glm::dot(z, glm::vec3(m[1]));
  const glm::vec3 y = glm::length(up) > 0.0f ? glm::normalize(up) : frameAlong(z)[1];
  return glm::mat4(glm::vec4(glm::cross(y, z), 0), glm::vec4(y, 0), glm::vec4(z, 0), m[3]);
}

Camera readCamera(const tinygltf::Camera& source, const glm::mat4& world) {
  Camera camera;
  camera.name = source.name;
  camera.worldFromCamera = rigid(world);
  camera.perspective = source.type == "perspective";
  if (camera.perspective) {
    camera.verticalFieldOfView = float(source.perspective.yfov);
    camera.aspectRatio = float(source.perspective.aspectRatio);
    camera.near = float(source.perspective.znear);
    camera.far = float(source.perspective.zfar);
  } else {
    camera.halfHeight = float(source.orthographic.ymag);
    camera.aspectRatio = float(source.orthographic.xmag / source.orthographic.ymag);
    camera.near = float(source.orthographic.znear);
    camera.far = float(source.orthographic.zfar);
  }
  return camera;
}

Light readLight(const tinygltf::Light& source, const glm::mat4& world) {
  Light light;
  const glm::mat4 frame = rigid(world);
  if (source.type == "point")
    light.kind = LightKind::point;
  else if (source.type == "spot")
    light.kind = LightKind::spot;
  if (source.color.size() == 3)
    light.color = glm::vec3(source.color[0], source.color[1], source.color[2]);
  light.intensity = float(source.intensity);
  light.range = float(source.range);
  light.position = glm::vec3(frame[3]);
  light.direction = -glm::vec3(frame[2]);
  light.innerConeCosine = float(std::cos(source.spot.innerConeAngle));
  light.outerConeCosine = float(std::cos(source.spot.outerConeAngle));
  return light;
}

/// Walks the default scene's forest with a stack of its own, so that depth costs no call stack.
class NodeWalk {
public:
  NodeWalk(const tinygltf::Model& model, Scene& scene)
      : model_(model), scene_(scene), primitivesOfMesh_(model.meshes.size()) {}

  Result<void> run() {
    if (model_.scenes.empty())
      return Error{ErrorKind::badInput, "has no scene; a scene with a mesh is accepted"};
    const int chosen = model_.defaultScene >= 0 ? model_.defaultScene : 0;
    push(model_.scenes[std::size_t(chosen)].nodes, glm::mat4(1.0f));
    while (!pending_.empty()) {
      const auto [index, parent] = pending_.back();
      pending_.pop_back();
      if (Result<void> visited = visit(model_.nodes[std::size_t(index)], parent); !visited)
        return visited;
    }
    if (scene_.instances.empty())
      return Error{ErrorKind::badInput, "its scene has no triangles; at least one is accepted"};
    return {};
  }

private:
  Result<void> visit(const tinygltf::Node& node, const glm::mat4& parent) {
    const glm::mat4 world = parent * localMatrix(node);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        if (!std::isfinite(world[column][row]))
          return Error{ErrorKind::badInput, "/nodes: the transform of node \"" +
                                                printable(node.name) + "\" is not finite"};
    if (node.camera >= 0)
      addCamera(node, world);
    if (const auto light = node.extensions.find("KHR_lights_punctual");
        light != node.extensions.end() && light->second.Has("light"))
      scene_.lights.push_back(readLight(
          model_.lights[std::size_t(light->second.Get("light").GetNumberAsInt())], world));
    if (node.mesh >= 0)
      if (Result<void> added = addMesh(std::size_t(node.mesh), world); !added)
        return added;
    push(node.children, world);
    return {};
  }

  /// The first is visited next.
  void push(const std::vector<int>& nodes, const glm::mat4& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
      pending_.push_back({*node, parent});
  }

  void addCamera(const tinygltf::Node& node, const glm::mat4& world) {
    Camera camera = readCamera(model_.cameras[std::size_t(node.camera)], world);
    camera.nodeName = node.name;
    scene_.cameras.push_back(std::move(camera));
  }

  Result<void> addMesh(std::size_t mesh, const glm::mat4& world) {
    if (!primitivesOfMesh_[mesh]) {
      primitivesOfMesh_[mesh].emplace();
      for (const tinygltf::Primitive& source : model_.meshes[mesh].primitives)
        if (Result<void> loaded = loadPrimitive(mesh, source); !loaded)
          return loaded;
    }
    for (const std::size_t primitive : *primitivesOfMesh_[mesh]) {
      const Primitive& p = scene_.primitives[primitive];
      drawn_ += p.vertices.size() + p.indices.size();
      if (scene_.instances.size() == kMaxSceneInstances || drawn_ > kMaxDrawnVertices)
        return Error{ErrorKind::resources,
                     "/nodes: the scene draws more than " + std::to_string(kMaxSceneInstances) +
                         " primitives, or " + std::to_string(kMaxDrawnVertices) +
                         " vertices and indices; a smaller scene is accepted"};
      scene_.instances.push_back({primitive, world});
    }
    return {};
  }

  Result<void> loadPrimitive(std::size_t mesh, const tinygltf::Primitive& source) {
    const std::size_t material =
        source.material >= 0 ? std::size_t(source.material) : scene_.materials.size() - 1;
    vertices_ += expandedSize(model_, source);
    if (vertices_ > kMaxSceneVertices)
      return Error{ErrorKind::resources, "/meshes: more than " + std::to_string(kMaxSceneVertices) +
                                             " vertices and indices; a smaller scene is accepted"};
    Result<std::optional<Primitive>> primitive =
        readPrimitive(model_, source, scene_.materials[material]);
    if (!primitive)
      return primitive.error();
    if (!primitive.value()) {
      scene_.notes.push_back("a primitive of mesh " + std::to_string(mesh) +
                             " without triangles is ignored");
      return {};
    }
    noteMissingTangents(mesh, source, scene_.materials[material]);
    primitive.value()->material = material;
    primitivesOfMesh_[mesh]->push_back(scene_.primitives.size());
    scene_.primitives.push_back(std::move(*primitive.value()));
    return {};
  }

  void noteMissingTangents(std::size_t mesh, const tinygltf::Primitive& source,
                           const Material& material) {
    const TextureSlot& normals = material.normalTexture; // from which tangents are made
    const bool makesTangents =
        normals.image && source.attributes.contains("TEXCOORD_" + std::to_string(normals.texCoord));
    if (material.noiseNeedsTangents && !makesTangents && !source.attributes.contains("TANGENT"))
      scene_.notes.push_back(
          "/meshes/" + std::to_string(mesh) + " \"" + printable(model_.meshes[mesh].name) +
          "\" has no TANGENT, along which the noise of its material \"" + printable(material.name) +
          "\" lies; any direction is taken, lichen apply finds good ones");
  }

  struct Pending {
    int node;
    glm::mat4 parent;
  };
  const tinygltf::Model& model_;
  Scene& scene_;
  std::vector<std::optional<std::vector<std::size_t>>> primitivesOfMesh_;
  std::vector<Pending> pending_;
  std::size_t vertices_ = 0; ///< and indices, of the primitives loaded so far
  std::size_t drawn_ = 0;    ///< the same, of the instances
};

/// What the noise plugin reads: the file itself when it holds all its buffers, or else a GLB of its
/// JSON and its buffers one behind the other.
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
    constexpr std::size_t kAlignment = 16; // of anything that a view may hold
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
  if (Result<void> walked = NodeWalk(model.value(), scene).run(); !walked)
    return named(walked.error());
  std::sort(scene.notes.begin(), scene.notes.end());
  scene.notes.erase(std::unique(scene.notes.begin(), scene.notes.end()), scene.notes.end());
  const auto hasNoise = [](const Material& material) { return material.hasNoise; };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), hasNoise))
    scene.noiseBundle = noiseBundle(file, model.value());
  return scene;
}

} // namespace

Result<Scene> readScene(const std::filesystem::path& path) {
  try {
    Result<GltfFile> file = readGltfFile(path);
    if (!file)
      return file.error();
    return loadScene(file.value());
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, path.string() + ": not enough memory for the scene"};
  } catch (const std::exception& fault) { // nlohmann's and the containers' inside tinygltf
    return Error{ErrorKind::badInput,
                 path.string() + ": cannot be loaded: " + printable(fault.what(), 160)};
  }
}

} // namespace lichen::renderer
