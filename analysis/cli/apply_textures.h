// SPDX-License-Identifier: MIT
// `lichen apply`: the textures of materials that stay visible beside a noise.
#pragma once

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// Returns one note on the textures that remain, wholly or in part, because the noise does not have
/// all their channels; empty if none remains. They keep their own texture coordinates and do not
/// follow the noise's mapping.
[[nodiscard]] std::vector<std::string>
notesOnTextures(const GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise);

/// Keeps the URI, in a .glb too, of each image that cannot be used and is no longer shown because
/// the noise replaces every texture that uses it. Each such image gets a note. GltfScene::write()
/// of a .glb fails for any other such image. `mix` is the mix weight of the materials.
void leaveReplacedImages(GltfScene& scene, std::span<const std::size_t> materials,
                         const Noise& noise, const MixWeight& mix, std::vector<std::string>& notes);

} // namespace lichen::cli
