// SPDX-License-Identifier: MIT
// Derives the role of an image in a material set from its file name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

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
/// without its extension. Words
/// for resolution, format, version and number after them are skipped. Words end at punctuation and
/// before capitals: "rock_nor-gl_2K" and "Rock_2K-PNG_NormalGL" are normal maps. "metal_plate" has
/// no role, because the role must come last.
[[nodiscard]] std::optional<FileRole> fileRole(std::string_view stem);

/// Returns the words before the role's, joined, in lower case: "rock" for "Rock_2K_Albedo", nothing
/// for "normal". Words for resolution and format are skipped. `stem` must have a role.
[[nodiscard]] std::string wordsBeforeRole(std::string_view stem);

} // namespace lichen::exemplar
