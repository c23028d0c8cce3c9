// SPDX-License-Identifier: MIT
// File names of screenshots.
#pragma once

#include <lichen/result.h>

#include <filesystem>

namespace lichen::renderer {

/// FOLDER/SCENE_001.png for a scene SCENE.glb, or the first number whose file does not exist.
/// Errors: environment if all numbers are taken.
[[nodiscard]] Result<std::filesystem::path> screenshotPath(const std::filesystem::path& folder,
                                                           const std::filesystem::path& scene);

} // namespace lichen::renderer
