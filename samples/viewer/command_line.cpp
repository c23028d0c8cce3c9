// SPDX-License-Identifier: MIT
// Options of lichen-view, in the words of lichen-render, and the checks that need no device.
#include "command_line.h"

#include "controls.h"
#include "program.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <options.h>

namespace lichen::renderer {
namespace {

constexpr const char* kProgram = "lichen-view";
constexpr int kMaxSide = 16384;
constexpr int kMaxFrames = 4096;
constexpr double kMaxExposure = 20.0;

void addOptions(CLI::App& app, ViewCommand& command) {
  using namespace cli;
  addText(app, "SCENE", command.scene, "", "A .glb or .gltf file; drawn anew when it changes");
  addValue(app, "--size", command.size, imageSize(kMaxSide), "1280x720",
           "Of the window, in pixels");
  addText(app, "--camera", command.camera, "NAME|auto",
          "Where the view starts: a camera or camera node of the scene, or one that frames it "
          "[default: its first camera, else auto]");
  addText(app, "--environment", command.environment, "FILE",
          "Light from a latitude-longitude panorama, EXR, PNG or JPEG [default: a built-in sky]");
  addValue(app, "--exposure", command.exposureEv, number({-kMaxExposure, kMaxExposure}), "0",
           "In stops, -20 to 20");
  addValue(app, "--frames", command.frames, wholeNumber(1, kMaxFrames), "64",
           "Frames to average while nothing moves, 1 to 4096");
  addText(app, "-o,--output", command.output, "FOLDER",
          "Where pictures are written [default: the current folder]");
  addText(app, "--device", command.device, "INDEX|NAME",
          "A Vulkan device, or part of its name [default: the best that presents here]");
  addFlag(app, "--validate", command.validate,
          "Fail in the end if the Vulkan validation layers have had anything to say");
}

} // namespace

Result<std::variant<ViewCommand, std::string>> parseViewCommand(int argc, const char* const* argv) {
  ViewCommand command;
  CLI::App app("Shows a glTF scene, its noise materials included, in a window.", kProgram);
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer("\n" + std::string(Controls::help()));
  addOptions(app, command);
  Result<std::optional<std::string>> asked = parseArguments(app, argc, argv);
  if (!asked)
    return asked.error();
  if (asked.value())
    return std::variant<ViewCommand, std::string>(*asked.value());
  if (command.scene.empty())
    return usageError(kProgram, "the scene is missing; SCENE.glb or SCENE.gltf is accepted");
  if (command.output.empty())
    command.output = ".";
  std::error_code ignored;
  if (!std::filesystem::is_directory(command.output, ignored))
    return Error{ErrorKind::environment,
                 command.output + ": the folder does not exist; make it first"};
  return std::variant<ViewCommand, std::string>(std::move(command));
}

} // namespace lichen::renderer
