// SPDX-License-Identifier: MIT
// Options of lichen-view, in the style of lichen-render, and the checks that need no device.
#include "command_line.h"

#include "controls.h"
#include "program.h"

#include <lichen/files.h>

#include <CLI/App.hpp>

#include <options.h>

namespace lichen::renderer {
namespace {

constexpr const char* kProgram = "lichen-view";
constexpr int kMaxSide = 16384;
constexpr int kMaxFrames = 4096;
constexpr double kMaxExposure = 20.0;

void addOptions(CLI::App& app, ViewCommand& command) {
  using namespace cli;
  addText(app, "SCENE", command.scene, "", "A .glb or .gltf file; reloaded when it changes");
  addValue(app, "--size", command.size, imageSize(kMaxSide), "1280x720", "Window size in pixels");
  addText(app, "--camera", command.camera, "NAME|auto",
          "Start from a camera or camera node of the scene; auto frames the scene [default: the "
          "first camera, else auto]");
  addText(app, "--environment", command.environment, "FILE",
          "Light the scene with a latitude-longitude panorama: EXR, PNG or JPEG [default: a "
          "built-in sky]");
  addValue(app, "--exposure", command.exposureEv, number({-kMaxExposure, kMaxExposure}), "0",
           "Exposure in stops, -20 to 20");
  addValue(app, "--frames", command.frames, wholeNumber(1, kMaxFrames), "64",
           "Frames to average while nothing changes, 1 to 4096");
  addText(app, "-o,--output", command.output, "FOLDER",
          "Folder for screenshots [default: the current folder]");
  addText(app, "--device", command.device, "INDEX|NAME",
          "Vulkan device: its index or part of its name [default: the best that can present "
          "to this display]");
  addFlag(app, "--validate", command.validate,
          "Fail at exit if the Vulkan validation layers reported anything");
}

} // namespace

Result<std::variant<ViewCommand, std::string>> parseViewCommand(int argc, const char* const* argv) {
  ViewCommand command;
  CLI::App app("Shows a glTF scene, including its noise materials, in a window.", kProgram);
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer("\n" + std::string(Controls::help()));
  addOptions(app, command);
  Result<std::optional<std::string>> printed = parseArguments(app, argc, argv);
  if (!printed)
    return printed.error();
  if (printed.value())
    return std::variant<ViewCommand, std::string>(*printed.value());
  if (command.scene.empty())
    return usageError(kProgram, "the scene is missing; give a .glb or .gltf file");
  if (command.output.empty())
    command.output = ".";
  if (Result<void> exists = checkFolder(command.output); !exists)
    return exists.error();
  return std::variant<ViewCommand, std::string>(std::move(command));
}

} // namespace lichen::renderer
