// SPDX-License-Identifier: MIT
// What lichen-view was asked to do.
#pragma once

#include <lichen/result.h>

#include <array>
#include <string>
#include <variant>

namespace lichen::renderer {

/// The defaults stand in the options' declarations.
struct ViewCommand {
  std::string scene;
  std::string output;        ///< folder of screenshots
  std::array<int, 2> size{}; ///< width and height in pixels
  std::string camera;
  std::string environment; ///< empty for the built-in sky
  double exposureEv = 0.0;
  int frames = 0;
  std::string device;
  bool validate = false;
};

/// The command, or the text that --help or --version asked for. Errors: usage; environment for an
/// output folder that does not exist.
[[nodiscard]] Result<std::variant<ViewCommand, std::string>>
parseViewCommand(int argc, const char* const* argv);

} // namespace lichen::renderer
