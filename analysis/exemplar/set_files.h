// SPDX-License-Identifier: MIT
// Which files of a material are its maps.
#pragma once

#include "file_roles.h"

#include <lichen/result.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen::exemplar {

struct SetFile {
  std::filesystem::path path;
  FileRole role = FileRole::baseColor;
  std::vector<FileRole> leftOut; ///< of a packed file: what files of their own have
};

struct SetFiles {
  std::string name;           ///< of the material
  std::vector<SetFile> files; ///< no two of them for one channel; those of a folder by name
  bool isSingleImage = false; ///< its notes then need not name it
  std::vector<std::string> notes;
};

/// Folders are replaced by the images inside, by extension; those whose name has no role are left
/// out with a note, while a file named by itself must have one, unless it is alone: then it may be
/// the base colour without. Of normals in
/// both conventions the OpenGL ones are taken; of a packed map and one of its channels in a file of
/// its own, the latter. A folder without a map stands for its only folder with maps. `plainNormal`
/// is what FileRole::normal stands for. Errors as readMaterialSet().
[[nodiscard]] Result<SetFiles> findSetFiles(std::span<const std::filesystem::path> inputs,
                                            FileRole plainNormal);

/// The glTF channels that a role fills, by their names in messages.
[[nodiscard]] std::vector<std::string_view> slotsOf(FileRole role);

} // namespace lichen::exemplar
