// SPDX-License-Identifier: MIT
// What an image of a material set is, by its file's name.
#pragma once

#include <optional>
#include <string>
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

/// What a file is whose name without extension is `stem`, by its last words; those of resolution,
/// format, version and number behind them are skipped. Words end at punctuation and before
/// capitals: "rock_nor-gl_2K" and "Rock_2K-PNG_NormalGL" are normal maps. "metal_plate" is none:
/// what a material is called comes first.
[[nodiscard]] std::optional<FileRole> fileRole(std::string_view stem);

/// The words before those that say the role, run together, lower case: "rock" of "Rock_2K_Albedo",
/// nothing of "normal". Those of resolution and format do not count. `stem` has a role.
[[nodiscard]] std::string wordsBeforeRole(std::string_view stem);

} // namespace lichen::exemplar
