// SPDX-License-Identifier: MIT
// A glTF scene as the renderer draws it: plain arrays in world units, no Vulkan, no JSON. Places in
// the world are doubles, as they are in the file; what is drawn is relative to one near the camera.
#pragma once

#include <lichen/result.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lichen::renderer {

struct Vertex {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};
  glm::vec4 tangent{0.0f}; ///< xyz unit, w the sign of the bitangent; unset without a normal map
  glm::vec2 texCoord0{0.0f};
  glm::vec2 texCoord1{0.0f};
  glm::vec4 color{1.0f};    ///< linear
  float mixWeight = 0.0f;   ///< of a noise's mix, where its material takes it from vertex colours
  std::uint32_t stored = 0; ///< its place among those of the file's accessors
};

/// Triangles of one material. Never empty; every index is below vertices.size().
struct Primitive {
  std::vector<Vertex> vertices;
  /// As many, before morph targets and skins, where these move them and the material has a noise;
  /// else none. The length of a normal is by how much the skin stretches space along it.
  std::vector<Vertex> undeformed;
  std::vector<std::uint32_t> indices; ///< three per triangle
  std::size_t material = 0;           ///< into Scene::materials
};

/// A primitive placed in the world.
struct Instance {
  std::size_t primitive = 0;
  glm::dmat4 worldFromObject{1.0};
};

enum class Filter { nearest, linear };
enum class Wrap { repeat, clampToEdge, mirroredRepeat };

struct Sampler {
  Filter magnification = Filter::linear;
  Filter minification = Filter::linear;
  Filter mip = Filter::linear;
  bool mipmapped = true;
  Wrap wrapU = Wrap::repeat;
  Wrap wrapV = Wrap::repeat;
  [[nodiscard]] bool operator==(const Sampler&) const = default;
};

/// 8-bit RGBA, row 0 at the top, as the file stores it: whether the bytes are sRGB code or data is
/// decided by the slot that samples them.
struct TextureImage {
  int width = 1;
  int height = 1;
  std::vector<std::uint8_t> rgba;
};

/// One texture slot of a material. The transform is KHR_texture_transform's, applied to texCoord.
struct TextureSlot {
  std::optional<std::size_t> image; ///< into Scene::images
  Sampler sampler;
  int texCoord = 0; ///< 0 or 1
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation = 0.0f; ///< radians
};

enum class AlphaMode { opaque, mask, blend };

struct Material {
  std::string name;
  glm::vec4 baseColor{1.0f}; ///< linear
  float metallic = 1.0f;
  float roughness = 1.0f;
  glm::vec3 emissive{0.0f}; ///< linear, KHR_materials_emissive_strength multiplied in
  float normalScale = 1.0f;
  float occlusionStrength = 1.0f;
  AlphaMode alphaMode = AlphaMode::opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  TextureSlot baseColorTexture;
  TextureSlot metallicRoughnessTexture;
  TextureSlot normalTexture;
  TextureSlot occlusionTexture;
  TextureSlot emissiveTexture;
  /// Carries LICHEN_materials_exemplar_noise; NoiseHost tells whether it is drawn with a noise.
  bool hasNoise = false;
  /// Where the noise's mix has its weight, if from a mask or from vertex colours COLOR_n: the
  /// image is then none, or nothing is here.
  TextureSlot mixTexture;
  std::optional<int> mixColorSet;
  int mixChannel = 0; ///< of either, 0 to 3
  /// Texture coordinates of the noise, where it lies along them and has normals.
  std::optional<int> noiseNormalTexCoord;
  bool noiseNeedsTangents = false; ///< of the mesh: it is noise on the surface
};

enum class LightKind { directional, point, spot };

/// KHR_lights_punctual in world space. Directional lights are in lux, the others in candela.
struct Light {
  LightKind kind = LightKind::directional;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;
  float range = 0.0f;                     ///< 0 for unlimited
  glm::dvec3 position{0.0};               ///< not for directional
  glm::vec3 direction{0.0f, 0.0f, -1.0f}; ///< the way the light travels, unit; not for point
  float innerConeCosine = 1.0f;
  float outerConeCosine = 0.0f;
};

struct Camera {
  std::string name;
  std::string nodeName; ///< of the node that holds it, which is what Blender's users named
  glm::dmat4 worldFromCamera{1.0}; ///< rigid: looks along -z, +y up
  bool perspective = true;
  float verticalFieldOfView = 0.7f; ///< radians; perspective
  float aspectRatio = 0.0f;         ///< of the file, 0 when it leaves it to the viewer
  float halfHeight = 1.0f;          ///< world units; orthographic
  float near = 0.1f;
  float far = 0.0f;  ///< 0 for infinite; perspective only
  std::string fault; ///< why it cannot be looked through, or empty
};

struct Scene {
  std::string name; ///< of the file, for messages
  std::vector<Primitive> primitives;
  std::vector<Instance> instances;
  std::vector<Material> materials; ///< glTF's, in order, then glTF's default material
  std::vector<TextureImage> images;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  /// A GLB for the noise plugin, empty when no material has a noise.
  std::vector<std::byte> noiseBundle;
  std::vector<std::string> notes; ///< what was ignored, one sentence each, for the user
};

/// Reads and checks a .gltf or .glb. Errors: badInput for every fault of the file, with the JSON
/// pointer of the place; resources when the scene is larger than the bounds below.
[[nodiscard]] Result<Scene> readScene(const std::filesystem::path& path);
/// As above of bytes in memory, which stand for the file at `path`: messages name it, and what the
/// scene refers to is looked for beside it.
[[nodiscard]] Result<Scene> parseScene(std::vector<std::byte> bytes,
                                       const std::filesystem::path& path);

/// Vertices and indices of all primitives after their expansion: 64 Mi, at most 5 GiB of memory.
inline constexpr std::size_t kMaxSceneVertices = std::size_t(1) << 26;
/// Of vertices from the origin of their mesh and of the world: squares, times a few, are floats.
inline constexpr float kMaxSceneReach = 1e15f;
/// Primitives placed in the world, each a draw call a pass.
inline constexpr std::size_t kMaxSceneInstances = std::size_t(1) << 18;
/// Vertices and indices of all instances together: a small file may ask for a mesh many times.
inline constexpr std::size_t kMaxDrawnVertices = std::size_t(1) << 28;
/// Texels of all images together, 1 GiB of memory before mip levels.
inline constexpr std::size_t kMaxSceneTexels = std::size_t(1) << 28;
/// Bytes of all buffers together, however many of them name one file: what one GLB can hold, which
/// the noise bundle is.
inline constexpr std::size_t kMaxBufferBytes = (std::size_t(1) << 32) - 1;
/// Bytes of all image files and data URIs together: two for each of kMaxSceneTexels.
inline constexpr std::size_t kMaxImageBytes = std::size_t(1) << 29;

} // namespace lichen::renderer
