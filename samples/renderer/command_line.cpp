// SPDX-License-Identifier: MIT
// Options of lichen-render, in the style of the lichen command, and the checks that need no device.
#include "command_line.h"

#include "debug_views.h"
#include "program.h"

#include <lichen/files.h>

#include <CLI/App.hpp>

#include <filesystem>
#include <options.h>

namespace lichen::renderer {
namespace {

constexpr int kMaxSide = 16384;
constexpr int kMaxFrames = 4096;
constexpr double kMaxExposure = 20.0;
constexpr double kMaxDepth = 1e6; // metres, as the largest tile

constexpr const char* kProgram = "lichen-render";

Result<void> check(const Command& command) {
  if (command.listDevices)
    return {};
  if (command.scene.empty() || command.output.empty())
    return usageError(kProgram, std::string(command.scene.empty() ? "the scene" : "--output") +
                                    " is required; for example: " + kProgram +
                                    " SCENE.glb -o OUT.png");
  const std::filesystem::path output(command.output);
  const std::string extension = output.extension().string();
  if (extension != ".png" && extension != ".exr")
    return usageError(kProgram, command.output + ": unknown extension; use .png or .exr");
  return checkFolder(output.parent_path());
}

void addOptions(CLI::App& app, Command& command) {
  using namespace cli;
  addText(app, "SCENE", command.scene, "", "A .glb or .gltf file");
  addText(app, "-o,--output", command.output, "OUT.png|OUT.exr",
          "Picture to write: .png is tone-mapped sRGB, .exr linear light (required)");
  addValue(app, "--size", command.size, imageSize(kMaxSide), "1280x720", "Picture size in pixels");
  addText(app, "--camera", command.camera, "NAME|auto",
          "A camera or camera node of the scene; auto frames the scene [default: the first "
          "camera, else auto]");
  addText(app, "--environment", command.environment, "FILE",
          "Light the scene with a latitude-longitude panorama: EXR, PNG or JPEG [default: a "
          "built-in sky]");
  addValue(app, "--exposure", command.exposureEv, number({-kMaxExposure, kMaxExposure}), "0",
           "Exposure in stops, -20 to 20");
  addValue(app, "--frames", command.frames, wholeNumber(1, kMaxFrames), "16",
           "Frames to average, 1 to 4096: more frames smooth edges, penumbrae and sky light");
  addValue(app, "--displace", command.depth, number({0.0, kMaxDepth}), "0",
           "Move surfaces out along their normals by the height of their noise times so many "
           "metres");
  Choices<std::string> views;
  for (const std::string_view name : debugViewNames())
    views.emplace_back(name, name);
  addValue(app, "--debug-view", command.debugView, oneOf(views), "",
           "Show one quantity instead of the shaded scene");
  addText(app, "--device", command.device, "INDEX|NAME",
          "Vulkan device: its index or part of its name [default: the best]");
  addFlag(app, "--list-devices", command.listDevices, "List the Vulkan devices and exit");
  addFlag(app, "--validate", command.validate,
          "Fail if the Vulkan validation layers report anything");
  addFlag(app, "--json", command.json,
          "Write one JSON object, and nothing else, to standard output");
  addFlag(app, "--quiet", command.quiet, "Print errors only, no notes and no report");
}

} // namespace

Result<std::variant<Command, std::string>> parseCommandLine(int argc, const char* const* argv) {
  Command command;
  CLI::App app("Renders a glTF scene, including its noise materials, to a picture.", kProgram);
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  addOptions(app, command);
  Result<std::optional<std::string>> printed = parseArguments(app, argc, argv);
  if (!printed)
    return printed.error();
  if (printed.value())
    return std::variant<Command, std::string>(*printed.value());
  if (Result<void> checked = check(command); !checked)
    return checked.error();
  return std::variant<Command, std::string>(std::move(command));
}

} // namespace lichen::renderer
