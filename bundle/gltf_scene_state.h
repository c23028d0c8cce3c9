// SPDX-License-Identifier: MIT
// The contents of a GltfScene and the pending changes.
#pragma once

#include "gltf_file.h"
#include "json_changes.h"

#include <lichen/gltf_scene.h>

#include <map>
#include <set>

namespace lichen {

/// A view of added bytes. The offset of `added` in the final buffer is known only when the asset is
/// written.
struct AddedView {
  std::size_t offset = 0;
  std::size_t length = 0;
  bool isVertices = false;
};

/// Number of elements of an array per name; elements without a name count under the empty one.
using NameCounts = std::map<std::string, std::size_t>;

/// Accessors that passed the check.
struct SoundAccessors {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t>
      vectors; ///< element count by accessor and number of components
  std::set<std::pair<std::size_t, std::size_t>> indices; ///< by accessor and limit
};

struct GltfScene::State {
  std::filesystem::path path;
  std::vector<std::byte> bytes; ///< the file's content, borrowed by `file`
  std::optional<GltfFile> file;
  Bundle bundle;                    ///< noises and tables, including added ones
  std::size_t ignoredTables = 0;    ///< tables before those of `bundle`; see readNoises()
  std::size_t ignoredNoises = 0;    ///< likewise
  std::set<std::string> noiseNames; ///< names of all noises of the file

  SoundAccessors soundAccessors; ///< accessors without errors, as checkVertices() found
  std::vector<std::vector<PrimitivePlace>> primitivesOf; ///< indexed by material
  NameCounts materialNames, meshNames;
  bool listsExtension = false; ///< whether extensionsUsed lists the extension

  JsonChange changes;
  std::vector<std::byte> added;
  std::vector<AddedView> addedViews;
  std::size_t addedAccessors = 0;
  std::size_t addedTextures = 0;    ///< number of added textures and images
  std::set<std::size_t> imagesLeft; ///< images that stay external even in a .glb
  /// Accessors set by setAttribute(), by mesh, primitive and attribute name.
  std::map<std::tuple<std::size_t, std::size_t, std::string>, std::size_t> setAttributes;

  [[nodiscard]] const nlohmann::json& document() const { return file->document(); }
  /// Number of elements of an array of the root; 0 if absent.
  [[nodiscard]] std::size_t countOf(const char* array) const;
  [[nodiscard]] const nlohmann::json& primitive(PrimitivePlace place) const;
  void readNoises();
  void sortPrimitives(); ///< fills primitivesOf
  /// Appends bytes at a multiple of `alignment`. Returns the index of their view.
  std::size_t addView(std::span<const std::byte> view, std::size_t alignment, bool isVertices);
};

} // namespace lichen
