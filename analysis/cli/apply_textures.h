// SPDX-License-Identifier: MIT
// What textures of materials are still seen beside a noise.
#pragma once

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// A note on the textures that stay, in part too, since the noise lacks channels of theirs; none
/// where none does. They lie as before, not as the noise does.
[[nodiscard]] std::vector<std::string>
notesOnTextures(const GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise);

/// An image whose file is absent and that nothing shows, since the noise takes the place of all
/// textures that use it, keeps its URI in a .glb too, with a note. For another absent image
/// GltfScene::write() fails. `mix` is that of the materials.
void leaveReplacedImages(GltfScene& scene, std::span<const std::size_t> materials,
                         const Noise& noise, const MixWeight& mix, std::vector<std::string>& notes);

} // namespace lichen::cli
