// SPDX-License-Identifier: MIT
// Finds which files of a material are its maps, by the role that a file name states.
#pragma once

#include <lichen/result.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen::exemplar {

enum class FileRole {
  baseColor,
  normal, ///< in the convention that the user names
  normalGl,
  normalDx,
  occlusion,
  roughness,
  metallic,
  occlusionRoughnessMetallic, ///< in red, green and blue
  roughnessMetallic,          ///< in green and blue, as in a glTF texture
  emissive,
  height,
  opacity,
};

/// Returns the role that the last words of a file name state, such as "normal". `stem` is the name
/// without its extension. Words for resolution, format, version and number after them are skipped.
/// Words end at punctuation and before capitals: "rock_nor-gl_2K" and "Rock_2K-PNG_NormalGL" are
/// normal maps. "metal_plate" has no role, because the role must come last.
[[nodiscard]] std::optional<FileRole> fileRole(std::string_view stem);

struct SetFile {
  std::filesystem::path path;
  FileRole role = FileRole::baseColor;
  std::vector<FileRole> leftOut; ///< in a packed file: roles that other files provide
};

struct SetFiles {
  std::string name;           ///< of the material
  std::vector<SetFile> files; ///< at most one per channel; a folder's are sorted by name
  bool isSingleImage = false; ///< if so, notes need not name it
  std::vector<std::string> notes;
};

/// Replaces each folder by the images inside, selected by extension. Images in a folder whose name
/// has no role are skipped, with a note. A file named by itself must have a role, unless it is the
/// only one: then it may be the base colour.
/// If there are normals in both conventions, the OpenGL ones are used. If a packed map and a
/// separate file have the same channel, the separate file is used. A folder without a map stands
/// for its only subfolder with maps. `plainNormal` replaces FileRole::normal. Errors as
/// readMaterialSet().
[[nodiscard]] Result<SetFiles> findSetFiles(std::span<const std::filesystem::path> inputs,
                                            FileRole plainNormal);
/// The same for files that are not looked for: each is named by itself.
[[nodiscard]] Result<SetFiles> chooseSetFiles(std::span<const std::filesystem::path> files,
                                              FileRole plainNormal);

/// Returns the glTF channels that a role fills, by their names in messages.
[[nodiscard]] std::vector<std::string_view> slotsOf(FileRole role);

} // namespace lichen::exemplar
