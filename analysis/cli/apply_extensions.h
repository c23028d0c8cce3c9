// SPDX-License-Identifier: MIT
// `lichen apply`: the material extensions that would hide a noise.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// The extension that describes a material by diffuse and specular textures instead of the core's.
inline constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

/// Whether the material is described by that extension alone, so that removing it moves its diffuse
/// texture to baseColorTexture.
[[nodiscard]] bool isSpecularGlossy(const nlohmann::json& material);

/// Removes the extensions that replace the shading by core textures, and so by noise, each with one
/// note: KHR_materials_unlit and KHR_materials_pbrSpecularGlossiness. A specular-glossy material
/// without pbrMetallicRoughness gets in its core material what the noise does not bring: the
/// diffuse colour, the glossiness factor as roughness, and no metal. All other extensions stay.
void removeCompetingExtensions(GltfScene& scene, std::span<const std::size_t> materials,
                               const Noise& noise, std::vector<std::string>& notes);

} // namespace lichen::cli
