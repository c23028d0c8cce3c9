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

} // namespace lichen::cli
