// SPDX-License-Identifier: MIT
// Options, messages and exit codes shared by the renderer's programs.
#pragma once

#include "renderer.h"

#include <lichen/result.h>
#include <lichen/vulkan_device.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace lichen::renderer {

/// Which scene is shown, how, and on which device. addSceneOptions() sets the defaults.
struct SceneOptions {
  std::string scene;
  std::array<int, 2> size{}; ///< width and height in pixels
  std::string camera;
  std::string environment; ///< empty for the built-in sky
  double exposureEv = 0.0;
  int frames = 0;
  std::string device;
  bool validate = false;
};

/// Adds these options, each of which may be repeated: the last counts.
void addSceneOptions(CLI::App& app, SceneOptions& options, const char* defaultFrames);

/// What the options say of pictures. Adds notes on the environment. Errors: readPanorama().
[[nodiscard]] Result<RenderSettings> settingsOf(const SceneOptions& options,
                                                std::vector<std::string>& notes);

[[nodiscard]] VulkanDeviceOptions deviceOptionsOf(const SceneOptions& options);

/// Adds --help and --version to `app`, which is named after its program, and parses the arguments.
/// Returns false after printing what --help or --version asks for. Errors: usage.
[[nodiscard]] Result<bool> parseArguments(CLI::App& app, int argc, const char* const* argv);

/// A usage error whose message refers to the program's --help.
[[nodiscard]] Error usageError(const std::string& program, const std::string& message);

/// `text` with control characters escaped, so that it stays on one line.
[[nodiscard]] std::string oneLine(const std::string& text);

/// Writes each note to standard error as a line that starts with "note: ".
void writeNotes(const std::vector<std::string>& notes);

/// Errors: environment if there are any messages, after writing them to standard error.
[[nodiscard]] Result<void> checkMessages(const ValidationMessages& messages);

/// Calls `run` and returns the exit code. Writes one line to standard error if `run` fails or
/// standard output cannot be written.
[[nodiscard]] int runProgram(const char* name, const std::function<Result<void>()>& run);

} // namespace lichen::renderer
