// SPDX-License-Identifier: MIT
// The command line of lichen-render.
#pragma once

#include <lichen/result.h>

#include <array>
#include <string>
#include <variant>

namespace lichen::renderer {

/// The option declarations in command_line.cpp set the defaults.
struct Command {
  std::string scene;
  std::string output;
  std::array<int, 2> size{}; ///< width and height in pixels
  std::string camera;
  std::string environment; ///< empty for the built-in sky
  double exposureEv = 0.0;
  int frames = 0;
  double depth = 0.0; ///< of displacement, in metres
  std::string debugView;
  std::string device;
  bool listDevices = false;
  bool validate = false;
  bool json = false;
  bool quiet = false;
};

/// The command, or the text to print for --help or --version. Errors: usage; environment if the
/// output folder does not exist.
[[nodiscard]] Result<std::variant<Command, std::string>> parseCommandLine(int argc,
                                                                          const char* const* argv);

} // namespace lichen::renderer
