// SPDX-License-Identifier: MIT
// Adds noises to the materials of an existing glTF asset and preserves the rest of the asset.
#pragma once

#include <lichen/bundle.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>

namespace lichen {

/// One primitive of a mesh.
struct PrimitivePlace {
  std::size_t mesh = 0;
  std::size_t primitive = 0;
};

/// The triangles of a primitive, three indices each. Strips and fans are converted.
struct PrimitiveGeometry {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals; ///< as many as positions, or empty
  std::vector<std::uint32_t> triangles;
};

/// The result of GltfScene::applyNoise().
struct AppliedNoise {
  std::string name; ///< the noise's name in the asset
  bool isNew = false;
  std::size_t newTables = 0;
};

/// An asset and its pending changes. Writing keeps the members of the JSON, their order, their
/// values and the indentation, except for additions and the replacements and removals documented
/// below; numbers and strings may be spelled differently. Existing buffer bytes keep their offsets;
/// new bytes follow them. The functions that change or write the asset report that memory does not
/// suffice for a large allocation; if not even a small one succeeds, the process may end.
class GltfScene {
public:
  /// Reads a .glb or .gltf. Errors: badInput if the file is neither, if its materials, meshes,
  /// primitives, attributes or extensions violate glTF, if a JSON object has two members of one
  /// name, or if its existing noises are invalid; resources when memory does not suffice.
  [[nodiscard]] static Result<GltfScene> open(const std::filesystem::path& path);
  GltfScene(GltfScene&&) noexcept;
  GltfScene& operator=(GltfScene&&) noexcept;
  ~GltfScene();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] const nlohmann::json& document() const; ///< as read, without pending changes
  [[nodiscard]] std::size_t materialCount() const;
  /// For messages: "material 2", "material 'wood'", or "material 2 'wood'" if another material has
  /// the same name.
  [[nodiscard]] std::string materialTitle(std::size_t material) const;
  [[nodiscard]] std::string meshTitle(std::size_t mesh) const;
  [[nodiscard]] std::string primitiveTitle(PrimitivePlace place) const;

  [[nodiscard]] const std::vector<PrimitivePlace>& primitivesOf(std::size_t material) const;
  /// The accessor of an attribute such as "TANGENT", including one set by setAttribute(); nothing
  /// if the primitive has no such attribute.
  [[nodiscard]] std::optional<std::size_t> attribute(PrimitivePlace place,
                                                     const std::string& name) const;

  /// Reads a primitive's triangles. Errors: badInput, naming the primitive, for invalid data,
  /// points, lines, or vertices compressed by an extension; resources when memory does not suffice.
  [[nodiscard]] Result<PrimitiveGeometry> geometry(PrimitivePlace place);

  /// Validates positions, normals, texture coordinates and indices, of points and lines too,
  /// without storing them. If an extension compresses them, returns its name and skips the check.
  /// Errors: badInput, naming the primitive and the accessor, if no viewer can draw the primitive;
  /// resources when memory does not suffice.
  [[nodiscard]] Result<std::optional<std::string>> checkVertices(PrimitivePlace place);

  /// Adds a float accessor and returns its index. Throws std::bad_alloc.
  std::size_t addVertices(std::span<const std::array<float, 3>> values);
  std::size_t addVertices(std::span<const std::array<float, 4>> values);
  /// Adds or replaces an attribute. Throws std::bad_alloc.
  void setAttribute(PrimitivePlace place, const std::string& name, std::size_t accessor);

  /// Adds or replaces a material factor of one or more numbers. `parent` names the object that
  /// holds the factor; the material itself if empty. Throws std::bad_alloc.
  void setFactor(std::size_t material, std::string_view parent, std::string_view key,
                 const std::vector<double>& value);

  /// Removes an extension from materials, and from the lists of used and required extensions if
  /// nothing else in the asset has it. Throws std::bad_alloc.
  void removeExtension(std::span<const std::size_t> materials, const std::string& extension);

  /// Adds a PNG or JPEG file as an image of `mediaType`, and a texture that clamps to its edges.
  /// Returns the texture's index. Throws std::bad_alloc.
  std::size_t addTexture(std::span<const std::byte> file, std::string_view mediaType);
  [[nodiscard]] std::size_t textureCount() const; ///< including added textures

  /// Assigns a noise of a bundle to materials, with the parameters of `use`; ignores use.noise.
  /// Reuses equal noises and tables that the asset already has, including those from earlier calls.
  /// Appends a number to a name that another noise has. Replaces the materials' previous noise.
  /// Errors: resources.
  [[nodiscard]] Result<AppliedNoise> applyNoise(const Bundle& bundle, std::size_t noise,
                                                const MaterialNoise& use,
                                                std::span<const std::size_t> materials);

  /// Writes a .glb, or a .gltf with the new bytes in STEM.HASH.bin beside it. Converts between the
  /// two according to the extension of `path`; converting to .glb embeds the first buffer and the
  /// images. Errors: as of replaceFile(); usage if `path` has another extension, or lies in another
  /// folder while the asset refers to external files; badInput if a file to be embedded is invalid.
  [[nodiscard]] Result<void> write(const std::filesystem::path& path);

private:
  friend class SceneWriter;

  struct State;
  explicit GltfScene(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

} // namespace lichen
