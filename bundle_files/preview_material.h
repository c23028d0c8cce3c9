// SPDX-License-Identifier: MIT
// The core glTF material of a noise, for viewers that do not support the extension.
#pragma once

#include "gltf_builder.h"

#include <lichen/bundle_writer.h>

namespace lichen {

/// Adds a material with the extension's object and the preview's textures to `root`.
void addMaterial(nlohmann::ordered_json& root, GltfBuilder& builder, const std::string& name,
                 const Noise& noise, const MaterialNoise& use, const PreviewImages& preview);

} // namespace lichen
