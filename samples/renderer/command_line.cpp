// SPDX-License-Identifier: MIT
// Options of lichen-render, in the words of the lichen command, and the checks that need no device.
#include "command_line.h"

#include "renderer.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <filesystem>
#include <options.h>
#include <sstream>

namespace lichen::renderer {
namespace {

constexpr int kMaxSide = 16384;
constexpr int kMaxFrames = 4096;
constexpr double kMaxExposure = 20.0;

Error usage(const std::string& message) {
  return Error{ErrorKind::usage, message + "; see 'lichen-render --help'"};
}

/// What the parser found wrong, in the words of the command line.
Error usage(const CLI::App& app, const CLI::ParseError& fault) {
  const std::string text = fault.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr) {
    const std::string first = app.remaining().front();
    return usage(first + (first.starts_with("-") ? ": no such option" : ": one argument too many"));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&fault) != nullptr) {
    // "--option: 1 required TYPE missing", "flag was given a disallowed flag override"
    const std::size_t colon = text.find(':');
    return usage(colon != std::string::npos
                     ? text.substr(0, colon) + ": a value is missing"
                     : "--" + text.substr(0, text.find(' ')) + ": takes no value");
  }
  return usage(text);
}

Result<void> check(const Command& command) {
  if (command.listDevices)
    return {};
  if (command.scene.empty() || command.output.empty())
    return usage(std::string(command.scene.empty() ? "the scene" : "the picture") +
                 " is missing; SCENE.glb -o OUT.png is accepted");
  const std::filesystem::path output(command.output);
  const std::string extension = output.extension().string();
  if (extension != ".png" && extension != ".exr")
    return usage(command.output + ": the extension .png or .exr is accepted");
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    return Error{ErrorKind::environment, command.output + ": the folder " + folder.string() +
                                             " does not exist; make it first"};
  return {};
}

void addOptions(CLI::App& app, Command& command) {
  using namespace cli;
  addText(app, "SCENE", command.scene, "", "A .glb or .gltf file");
  addText(app, "-o,--output", command.output, "OUT.png|OUT.exr",
          "The picture: tone-mapped sRGB, or light (required)");
  addValue(app, "--size", command.size, imageSize(kMaxSide), "1280x720", "In pixels");
  addText(app, "--camera", command.camera, "NAME|auto",
          "A camera or camera node of the scene, or one that frames it [default: its first camera, "
          "else "
          "auto]");
  addText(app, "--environment", command.environment, "FILE",
          "Light from a latitude-longitude panorama, EXR, PNG or JPEG [default: a built-in sky]");
  addValue(app, "--exposure", command.exposureEv, number({-kMaxExposure, kMaxExposure}), "0",
           "In stops");
  addValue(app, "--frames", command.frames, wholeNumber(1, kMaxFrames), "16",
           "Frames to average: edges, penumbrae and the sky's light get smoother");
  Choices<std::string> views;
  for (const std::string_view name : debugViewNames())
    views.emplace_back(name, name);
  addValue(app, "--debug-view", command.debugView, oneOf(views), "",
           "One quantity instead of the shaded scene");
  addText(app, "--device", command.device, "INDEX|NAME",
          "A Vulkan device, or part of its name [default: the best]");
  addFlag(app, "--list-devices", command.listDevices, "Print the Vulkan devices there are");
  addFlag(app, "--validate", command.validate,
          "Fail if the Vulkan validation layers have anything to say");
  addFlag(app, "--json", command.json, "One JSON object on standard output, nothing else there");
  addFlag(app, "--quiet", command.quiet, "No notes and no report; errors only");
}

} // namespace

Result<std::variant<Command, std::string>> parseCommandLine(int argc, const char* const* argv) {
  Command command;
  CLI::App app("Renders a glTF scene, its noise materials included, to a picture.",
               "lichen-render");
  app.set_version_flag("--version", "lichen-render " LICHEN_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this page and exit");
  app.formatter(cli::helpFormatter());
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  addOptions(app, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) { // --help and --version
    std::ostringstream text;
    app.exit(success, text);
    return std::variant<Command, std::string>(text.str());
  } catch (const CLI::ParseError& fault) {
    return usage(app, fault);
  }
  if (Result<void> checked = check(command); !checked)
    return checked.error();
  return std::variant<Command, std::string>(std::move(command));
}

} // namespace lichen::renderer
