// SPDX-License-Identifier: MIT
// A glTF scene as the renderer draws it: plain arrays in world units, no Vulkan, no JSON. World
// positions are doubles, as in the file; the device gets floats relative to an origin near the
// camera.
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
  glm::vec4 tangent{
      0.0f}; ///< xyz unit, w the sign of the bitangent; 0 where the file has none of use
  glm::vec2 texCoord0{0.0f};
  glm::vec2 texCoord1{0.0f};
  glm::vec4 color{1.0f};  ///< linear
  float mixWeight = 0.0f; ///< weight of a noise's mix, if its material takes it from vertex colours
};

/// How displacement moves a vertex. Coincident vertices of a primitive have the same values, so
/// that the displaced surface has no cracks.
struct VertexDisplacement {
  glm::vec3 direction{0.0f}; ///< unit vector: the mean of the coincident vertices' normals
  /// 1, or 0 where the coincident vertices take the height at different places of the noise: there
  /// the surface has the mean height.
  float weight = 1.0f;
  float texCoordsPerUnit = 0.0f; ///< of the noise, per unit of the mesh's space; 0 without them
};

/// Triangles of one material. Never empty; every index is below vertices.size().
struct Primitive {
  std::vector<Vertex> vertices;
  std::vector<VertexDisplacement> displacement; ///< by vertex; empty unless the material displaces
  std::vector<std::uint32_t> indices;           ///< three per triangle
  std::size_t material = 0;                     ///< into Scene::materials
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

/// 8-bit RGBA as stored in the file, row 0 at the top. The texture slot decides whether the bytes
/// are sRGB or data.
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
  /// The material has the extension LICHEN_materials_exemplar_noise; NoiseHost::hasNoise() says
  /// whether it renders with a noise.
  bool hasNoise = false;
  /// Source of the weight of the noise's mix: the mask mixTexture, or the vertex colours COLOR_n
  /// with n = mixColorSet. Without an image and a set, the uniform block holds the weight.
  TextureSlot mixTexture;
  std::optional<int> mixColorSet;
  int mixChannel = 0; ///< channel of the mask or the vertex colours, 0 to 3
  /// Texture coordinate set of the noise, if the noise has normals and uses uv mapping.
  std::optional<int> noiseNormalTexCoord;
  bool noiseNeedsTangents = false; ///< surface mapping, which follows the mesh's tangents
  bool noiseHasHeight = false;
  std::optional<int> noiseTexCoord; ///< set of texture coordinates of a noise with uv mapping
  /// World units by which the height 1 of the noise moves the surface; see displacedScene().
  float displacement = 0.0f;
};

enum class LightKind { directional, point, spot };

/// KHR_lights_punctual in world space. Directional lights are in lux, the others in candela.
struct Light {
  LightKind kind = LightKind::directional;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;
  float range = 0.0f;                     ///< 0 for unlimited
  glm::dvec3 position{0.0};               ///< not for directional
  glm::vec3 direction{0.0f, 0.0f, -1.0f}; ///< unit vector in which the light travels; not for point
  float innerConeCosine = 1.0f;
  float outerConeCosine = 0.0f;
};

struct Camera {
  std::string name;
  /// name of the node that holds the camera; this is the name that Blender users set
  std::string nodeName;
  glm::dmat4 worldFromCamera{1.0}; ///< rigid; the camera looks along -z, with +y up
  bool perspective = true;
  float verticalFieldOfView = 0.7f; ///< radians; perspective
  float aspectRatio = 0.0f;         ///< 0 if the file does not state one
  float halfHeight = 1.0f;          ///< world units; orthographic
  float near = 0.1f;
  float far = 0.0f;  ///< 0 for infinite; perspective only
  std::string fault; ///< why the camera is unusable; empty if it is usable
};

struct Scene {
  std::string name; ///< the file's path, for messages
  std::vector<Primitive> primitives;
  std::vector<Instance> instances;
  std::vector<Material> materials; ///< glTF's, in order, then glTF's default material
  std::vector<TextureImage> images;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  /// A GLB for the noise plugin; empty if no material has a noise.
  std::vector<std::byte> noiseBundle;
  std::vector<std::string> notes; ///< what was ignored, one sentence each, for the user
};

/// Reads and validates a .gltf or .glb. Errors: badInput for every fault in the file, with its JSON
/// pointer; resources if the scene exceeds the bounds below.
[[nodiscard]] Result<Scene> readScene(const std::filesystem::path& path);
/// Like readScene(), but from bytes in memory. Messages name `path`, and files that the scene
/// refers to are read from its folder.
[[nodiscard]] Result<Scene> parseScene(std::vector<std::byte> bytes,
                                       const std::filesystem::path& path);

/// Maximum of vertices and indices of all primitives after expansion: 64 Mi, at most 5 GiB of
/// memory.
inline constexpr std::size_t kMaxSceneVertices = std::size_t(1) << 26;
/// Maximum distance of vertices from the origin of their mesh and of the world. Sums of a few
/// squared distances must fit a float.
inline constexpr float kMaxSceneReach = 1e15f;
/// Maximum number of instances; each is one draw call per pass.
inline constexpr std::size_t kMaxSceneInstances = std::size_t(1) << 18;
/// Maximum of vertices and indices of all instances: a small file may instance one mesh many times.
inline constexpr std::size_t kMaxDrawnVertices = std::size_t(1) << 28;
/// Maximum of texels of all images: 1 GiB of memory before mip levels.
inline constexpr std::size_t kMaxSceneTexels = std::size_t(1) << 28;
/// Maximum of bytes of all buffers, even if several refer to the same file. This is what one GLB,
/// such as the noise bundle, can hold.
inline constexpr std::size_t kMaxBufferBytes = (std::size_t(1) << 32) - 1;
/// Maximum of bytes of all image files and data URIs: two per texel of kMaxSceneTexels.
inline constexpr std::size_t kMaxImageBytes = std::size_t(1) << 29;

} // namespace lichen::renderer
