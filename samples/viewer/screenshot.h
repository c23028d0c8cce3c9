// SPDX-License-Identifier: MIT
// Where a picture of the window goes.
#pragma once

#include <lichen/result.h>

#include <filesystem>

namespace lichen::renderer {

/// FOLDER/SCENE_001.png for a scene of any SCENE.glb, or the first number without a file. Errors:
/// environment where all are taken.
[[nodiscard]] Result<std::filesystem::path> screenshotPath(const std::filesystem::path& folder,
                                                           const std::filesystem::path& scene);

} // namespace lichen::renderer
