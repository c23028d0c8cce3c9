// SPDX-License-Identifier: MIT
// Numbered file names that never overwrite a file.
#include "screenshot.h"

#include <fmt/format.h>

namespace lichen::renderer {

Result<std::filesystem::path> screenshotPath(const std::filesystem::path& folder,
                                             const std::filesystem::path& scene) {
  constexpr int kMostPictures = 999; // what three digits hold
  for (int number = 1; number <= kMostPictures; ++number) {
    const auto path = folder / fmt::format("{}_{:03}.png", scene.stem().string(), number);
    // symlink_status also detects a dangling link, through which the picture would be written.
    if (std::error_code error; std::filesystem::symlink_status(path, error).type() ==
                               std::filesystem::file_type::not_found)
      return path;
  }
  return Error{ErrorKind::environment,
               folder.string() + ": already has " + std::to_string(kMostPictures) +
                   " screenshots of this scene; remove some or choose another --output folder"};
}

} // namespace lichen::renderer
