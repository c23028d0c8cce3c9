// SPDX-License-Identifier: MIT
// The contents of a GltfScene and the pending changes.
#pragma once

#include "gltf_builder.h"
#include "gltf_file.h"

#include <lichen/gltf_scene.h>

#include <map>
#include <set>

namespace lichen {

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
  std::size_t ignoredTables = 0;    ///< tables before the bundle's; see readNoises()
  std::size_t ignoredNoises = 0;    ///< noises before the bundle's
  std::set<std::string> noiseNames; ///< names of all noises of the file

  SoundAccessors soundAccessors; ///< accessors without errors, as checkVertices() found
  std::vector<std::vector<PrimitivePlace>> primitivesOf; ///< indexed by material
  NameCounts materialNames, meshNames;

  nlohmann::ordered_json edited; ///< the document with all changes except `added`
  GltfBuilder added; ///< views have offsets in its own buffer until the asset is written

  [[nodiscard]] const nlohmann::json& document() const { return file->document(); }
  /// Number of elements of an array of the root; 0 if absent.
  [[nodiscard]] std::size_t countOf(const char* array) const;
  [[nodiscard]] const nlohmann::json& primitive(PrimitivePlace place) const;
  /// The attributes of a primitive, with changes.
  [[nodiscard]] nlohmann::ordered_json& attributes(PrimitivePlace place) {
    return edited["meshes"][place.mesh]["primitives"][place.primitive]["attributes"];
  }
  void readNoises();
  void sortPrimitives(); ///< fills primitivesOf
};

} // namespace lichen
