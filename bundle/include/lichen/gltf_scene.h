// SPDX-License-Identifier: MIT
// A glTF asset of anyone's, to whose materials noises are given. All else of it stays as it is.
#pragma once

#include <lichen/bundle.h>

#include <nlohmann/json_fwd.hpp>

#include <memory>

namespace lichen {

/// One primitive of a mesh.
struct PrimitivePlace {
  std::size_t mesh = 0;
  std::size_t primitive = 0;
};

/// The triangles of a primitive: three indices each, of strips and fans too.
struct PrimitiveGeometry {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals; ///< as many as positions, or none
  std::vector<std::uint32_t> triangles;
};

/// What putting a noise on materials has come to.
struct AppliedNoise {
  std::string name; ///< in the asset
  bool isNew = false;
  std::size_t newTables = 0;
};

/// The JSON text keeps every byte but for what is added or, at the places that say so below,
/// replaced; the bytes of buffers stay where they are, new ones follow them.
class GltfScene {
public:
  /// Reads a .glb or .gltf. Errors: badInput where it is none, where materials, meshes, primitives
  /// or attributes are not what glTF says, or where its own noises are at fault; resources.
  [[nodiscard]] static Result<GltfScene> open(const std::filesystem::path& path);
  GltfScene(GltfScene&&) noexcept;
  GltfScene& operator=(GltfScene&&) noexcept;
  ~GltfScene();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] const nlohmann::json& document() const; ///< as it was read
  [[nodiscard]] std::size_t materialCount() const;
  /// "material 2", "material 'wood'", or "material 2 'wood'" where another is called so; for
  /// messages.
  [[nodiscard]] std::string materialTitle(std::size_t material) const;
  [[nodiscard]] std::string meshTitle(std::size_t mesh) const;
  [[nodiscard]] std::string primitiveTitle(PrimitivePlace place) const;

  [[nodiscard]] const std::vector<PrimitivePlace>& primitivesOf(std::size_t material) const;
  /// The accessor of an attribute such as "TANGENT"; of an added one the new one.
  [[nodiscard]] std::optional<std::size_t> attribute(PrimitivePlace place,
                                                     const std::string& name) const;

  /// Errors: badInput, naming the primitive, for what is at fault in it, for points and lines, and
  /// for vertices that are compressed by an extension; resources.
  [[nodiscard]] Result<PrimitiveGeometry> geometry(PrimitivePlace place);

  /// Reads positions, normals, texture coordinates and indices, of points and lines too, without
  /// keeping them. Returns the extension by which they are compressed, then unread, or nothing.
  /// Errors: badInput, naming the primitive and the accessor, where no viewer can draw it;
  /// resources.
  [[nodiscard]] Result<std::optional<std::string>> checkVertices(PrimitivePlace place);

  /// The least and the greatest value of an attribute of two components, such as "TEXCOORD_0", that
  /// the primitive has; nothing where its vertices are compressed, which are then unread. Errors as
  /// checkVertices().
  struct Range2 {
    std::array<float, 2> least{}, most{};
  };
  [[nodiscard]] Result<std::optional<Range2>> rangeOf(PrimitivePlace place,
                                                      const std::string& attribute);

  /// Adds vertices as an accessor of floats, and returns its index. Throws std::bad_alloc.
  std::size_t addVertices(std::span<const std::array<float, 3>> values);
  std::size_t addVertices(std::span<const std::array<float, 4>> values);
  /// Adds or replaces an attribute. Throws std::bad_alloc.
  void setAttribute(PrimitivePlace place, const std::string& name, std::size_t accessor);

  /// Adds or replaces a factor of a material, a number or several, in the object `parent` of it, or
  /// in the material itself where that is empty. Throws std::bad_alloc.
  void setFactor(std::size_t material, std::string_view parent, std::string_view key,
                 const std::vector<double>& value);

  /// Adds a PNG or JPEG file as an image of `mediaType` and a texture of it, which ends at its
  /// borders and does not repeat; returns the texture's index. Throws std::bad_alloc.
  std::size_t addTexture(std::span<const std::byte> file, std::string_view mediaType);
  [[nodiscard]] std::size_t textureCount() const; ///< with those that were added

  /// Images whose files are not there; a .glb made of a .gltf cannot take them into itself. Throws
  /// std::bad_alloc.
  [[nodiscard]] std::vector<std::size_t> absentImages() const;
  /// Has an image stay in its file in a .glb too. Throws std::bad_alloc.
  void leaveImage(std::size_t image);

  /// Gives materials a noise of a bundle with the parameters of `use`, whose index of a noise is
  /// not used. A noise that the asset has already, from an earlier call too, is shared, and so are
  /// tables; a name that another noise has gets a number. What a material said about a noise is
  /// replaced. Errors: resources.
  [[nodiscard]] Result<AppliedNoise> applyNoise(const Bundle& bundle, std::size_t noise,
                                                const MaterialNoise& use,
                                                std::span<const std::size_t> materials);

  /// Writes .glb, or .gltf with new bytes in STEM.HASH.bin beside it; either kind becomes either. A
  /// .glb made of a .gltf takes the first buffer and the images into itself. Errors as
  /// replaceFile; usage where the asset names files beside it and `path` is in another folder, or
  /// for another extension; badInput for changes that the document has no place for.
  [[nodiscard]] Result<void> write(const std::filesystem::path& path);

private:
  friend class SceneWriter;

  struct State;
  explicit GltfScene(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

} // namespace lichen
