// SPDX-License-Identifier: MIT
// Numbered names, of which none is used twice.
#include "screenshot.h"

#include <fmt/format.h>

namespace lichen::renderer {

Result<std::filesystem::path> screenshotPath(const std::filesystem::path& folder,
                                             const std::filesystem::path& scene) {
  constexpr int kMostPictures = 999; // what three digits hold
  for (int number = 1; number <= kMostPictures; ++number) {
    const auto path = folder / fmt::format("{}_{:03}.png", scene.stem().string(), number);
    // Of a dangling link too: a picture would be written through it.
    if (std::error_code error; std::filesystem::symlink_status(path, error).type() ==
                               std::filesystem::file_type::not_found)
      return path;
  }
  return Error{ErrorKind::environment,
               folder.string() + ": holds " + std::to_string(kMostPictures) +
                   " pictures of this scene; remove some, or name another folder by --output"};
}

} // namespace lichen::renderer
