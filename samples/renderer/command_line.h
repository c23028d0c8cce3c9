// SPDX-License-Identifier: MIT
// What lichen-render was asked to do.
#pragma once

#include <lichen/result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

namespace lichen::renderer {

struct Command {
  std::filesystem::path scene;
  std::filesystem::path output;
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  std::string camera;
  std::filesystem::path environment; ///< empty for the built-in sky
  float exposureEv = 0.0f;
  std::uint32_t frames = 16;
  std::string debugView;
  std::string device;
  bool validate = false;
  bool json = false;
  bool quiet = false;
  bool listDevices = false;
};

/// The command, or the text that --help or --version asked for. Errors: usage; environment for an
/// output folder that does not exist.
[[nodiscard]] Result<std::variant<Command, std::string>> parseCommandLine(int argc,
                                                                          const char* const* argv);

} // namespace lichen::renderer
