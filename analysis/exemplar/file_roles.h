// SPDX-License-Identifier: MIT
// What an image of a material set is, by its file's name.
#pragma once

#include <optional>
#include <string_view>

namespace lichen::exemplar {

enum class FileRole {
  baseColor,
  normal, ///< of the convention that the user names
  normalGl,
  normalDx,
  occlusion,
  roughness,
  metallic,
  occlusionRoughnessMetallic, ///< in red, green and blue
  roughnessMetallic,          ///< in green and blue, as a glTF texture has them
  emissive,
  height,
  opacity,
};

/// What a file is whose name without extension is `stem`: the last of its words that mean a role
/// decide. Words end at punctuation and before capitals: "rock_nor-gl_2K" and
/// "Rock_2K-PNG_NormalGL" are normal maps. Others, such as those of resolution and format, are
/// skipped.
[[nodiscard]] std::optional<FileRole> fileRole(std::string_view stem);

} // namespace lichen::exemplar
