// SPDX-License-Identifier: MIT
// A glTF file whose scene is being loaded: its document, and the numbers in its accessors. Private
// to scene loading. Every fault throws a Fault, whose message names the place that refers to it.
#pragma once

#include "json_place.h"

#include <glm/glm.hpp>

#include <accessor_reader.h>

namespace lichen::renderer {

class SceneFile {
public:
  /// `path` names the file in messages and locates the files it refers to.
  SceneFile(std::vector<std::byte> bytes, std::filesystem::path path);

  void checkBuffers(); ///< and bufferViews; reads the files of buffers

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::vector<std::byte> takeBytes() { return std::move(bytes_); }
  [[nodiscard]] GltfFile& gltf() { return *gltf_; }
  [[nodiscard]] Place root() const { return {gltf_->document(), ""}; }
  /// An element of an array of the document's root.
  [[nodiscard]] Place element(const char* array, std::size_t index) const;
  /// The element of such an array that the member `key` of `from` refers to, or nothing.
  [[nodiscard]] std::optional<std::size_t> index(const Place& from, const char* key,
                                                 const char* array) const;
  [[nodiscard]] std::optional<Place> follow(const Place& from, const char* key,
                                            const char* array) const;

  /// The stated number of elements, and the type, such as "VEC3", of the accessor that `place`, an
  /// index, refers to.
  [[nodiscard]] std::size_t countOf(const Place& place) const;
  [[nodiscard]] std::string typeOf(const Place& place) const;

  /// The values of an accessor of `count` elements.
  template <std::size_t kComponents>
  [[nodiscard]] std::vector<std::array<float, kComponents>>
  vectors(const Place& place, std::size_t count,
          std::initializer_list<std::uint64_t> types = {kByte, kUnsignedByte, kShort,
                                                        kUnsignedShort, kFloat}) {
    if (const std::size_t stated = countOf(place); stated != count)
      place.fail("has " + std::to_string(stated) + " elements; expected " + std::to_string(count));
    FindingList findings;
    auto values = readVectors<kComponents>(*gltf_, accessorOf(place), findings, types);
    check(place, findings);
    return std::move(*values);
  }
  /// The values of an accessor of indices below `limit`.
  [[nodiscard]] std::vector<std::uint32_t> indices(const Place& place, std::size_t limit);
  /// The bytes of the bufferView that `place`, an index, refers to.
  [[nodiscard]] std::span<const std::byte> view(const Place& place);

private:
  [[nodiscard]] std::size_t accessorOf(const Place& place) const;
  void loadBuffer(const Place& buffer, std::size_t index);
  void checkView(const Place& view, std::size_t index);
  /// Throws the first error, if any. It names `place` if the fault is that the accessor does not
  /// suit it.
  static void check(const Place& place, const FindingList& findings);

  std::filesystem::path path_;
  std::vector<std::byte> bytes_; ///< borrowed by gltf_
  std::optional<GltfFile> gltf_;
};

} // namespace lichen::renderer
