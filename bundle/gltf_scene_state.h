// SPDX-License-Identifier: MIT
// What a GltfScene has read and what is to be changed in it.
#pragma once

#include "gltf_file.h"
#include "json_changes.h"

#include <lichen/gltf_scene.h>

#include <map>
#include <set>

namespace lichen {

/// A view of bytes that are added. Where their buffer begins is known when it is written.
struct AddedView {
  std::size_t offset = 0;
  std::size_t length = 0;
  bool isVertices = false;
};

/// How many elements of an array have a name; those without have the empty one.
using NameCounts = std::map<std::string, std::size_t>;

/// Accessors without a fault.
struct SoundAccessors {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t>
      vectors;                                           ///< elements, by accessor and components
  std::set<std::pair<std::size_t, std::size_t>> indices; ///< by accessor and limit
};

struct GltfScene::State {
  std::filesystem::path path;
  std::vector<std::byte> bytes; ///< of the file, which `file` borrows
  std::optional<GltfFile> file;
  Bundle bundle;                    ///< its noises and tables, and those that were added
  std::size_t ignoredTables = 0;    ///< tables in front of those of `bundle`; see readNoises()
  std::size_t ignoredNoises = 0;    ///< likewise
  std::set<std::string> noiseNames; ///< of all noises of the file

  SoundAccessors soundAccessors;                         ///< those that checkVertices() has read
  std::vector<std::vector<PrimitivePlace>> primitivesOf; ///< each material
  NameCounts materialNames, meshNames;
  bool listsExtension = false; ///< in extensionsUsed

  JsonChange changes;
  std::vector<std::byte> added;
  std::vector<AddedView> addedViews;
  std::size_t addedAccessors = 0;
  std::size_t addedTextures = 0;    ///< and images
  std::set<std::size_t> imagesLeft; ///< to their URIs, whatever is made of the asset
  /// Attributes that were set, by mesh, primitive and name.
  std::map<std::tuple<std::size_t, std::size_t, std::string>, std::size_t> setAttributes;

  [[nodiscard]] const nlohmann::json& document() const { return file->document(); }
  /// Elements of an array of the root; 0 where it is absent.
  [[nodiscard]] std::size_t countOf(const char* array) const;
  [[nodiscard]] const nlohmann::json& primitive(PrimitivePlace place) const;
  void readNoises();
  void sortPrimitives(); ///< by material
  /// Appends bytes at a multiple of `alignment`; returns the index of their view.
  std::size_t addView(std::span<const std::byte> view, std::size_t alignment, bool isVertices);
};

} // namespace lichen
