// SPDX-License-Identifier: MIT
// Options in the style of the lichen command, one-line messages, and the exit codes of result.h.
#include "program.h"

#include "environment.h"
#include "failure.h"
#include "printable.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <options.h>

namespace lichen::renderer {
namespace {

constexpr int kMaxSide = 16384;
constexpr int kMaxFrames = 4096;
constexpr double kMaxExposure = 20.0;

int fail(const char* program, const Error& error) {
  std::fprintf(stderr, "%s: %s\n", program, oneLine(error.message).c_str());
  return int(error.kind);
}

} // namespace

void addSceneOptions(CLI::App& app, SceneOptions& options, const char* defaultFrames) {
  using namespace cli;
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  addText(app, "SCENE", options.scene, "", "A .glb or .gltf file");
  addValue(app, "--size", options.size, imageSize(kMaxSide), "1280x720", "Size in pixels");
  addText(app, "--camera", options.camera, "NAME|auto",
          "A camera or camera node of the scene; auto frames the scene [default: the first "
          "camera, else auto]");
  addText(app, "--environment", options.environment, "FILE",
          "Light the scene with a latitude-longitude panorama: EXR, PNG or JPEG [default: a "
          "built-in sky]");
  addValue(app, "--exposure", options.exposureEv, number({-kMaxExposure, kMaxExposure}), "0",
           "Exposure in stops, -20 to 20");
  addValue(app, "--frames", options.frames, wholeNumber(1, kMaxFrames), defaultFrames,
           "Frames to average, 1 to 4096: more frames smooth edges, penumbrae and sky light");
  addText(app, "--device", options.device, "INDEX|NAME",
          "Vulkan device: its index or part of its name [default: the best]");
  addFlag(app, "--validate", options.validate,
          "Fail if the Vulkan validation layers report anything");
}

Result<RenderSettings> settingsOf(const SceneOptions& options, std::vector<std::string>& notes) {
  RenderSettings settings;
  settings.width = std::uint32_t(options.size[0]);
  settings.height = std::uint32_t(options.size[1]);
  settings.frames = std::uint32_t(options.frames);
  settings.camera = options.camera;
  settings.exposureEv = float(options.exposureEv);
  if (!options.environment.empty()) {
    Result<LinearImage> panorama = readPanorama(options.environment, notes);
    if (!panorama)
      return panorama.error();
    settings.environment = std::move(panorama).value();
  }
  return settings;
}

VulkanDeviceOptions deviceOptionsOf(const SceneOptions& options) {
  VulkanDeviceOptions device;
  device.choice = options.device;
  device.validation = options.validate;
  return device;
}

Result<bool> parseArguments(CLI::App& app, int argc, const char* const* argv) {
  app.set_version_flag("--version", app.get_name() + " " LICHEN_VERSION,
                       "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this page and exit");
  app.formatter(cli::helpFormatter());
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) { // --help and --version
    app.exit(success);
    return false;
  } catch (const CLI::ParseError& fault) {
    return usageError(app.get_name(), cli::parseFault(app, fault));
  }
  return true;
}

Error usageError(const std::string& program, const std::string& message) {
  return Error{ErrorKind::usage, message + "; see '" + program + " --help'"};
}

std::string oneLine(const std::string& text) { return printable(text, std::string::npos); }

void writeNotes(const std::vector<std::string>& notes) {
  for (const std::string& line : notes)
    std::fprintf(stderr, "note: %s\n", oneLine(line).c_str());
}

Result<void> checkMessages(const ValidationMessages& messages) {
  const std::vector<std::string> texts = messages.texts();
  if (texts.empty())
    return {};
  for (const std::string& text : texts)
    std::fprintf(stderr, "%s\n", text.c_str());
  const bool isOne = texts.size() == 1;
  return Error{ErrorKind::environment,
               std::to_string(texts.size()) + (isOne ? " message" : " messages") +
                   " from the Vulkan validation layers; please report " + (isOne ? "it" : "them")};
}

int runProgram(const char* name, const std::function<Result<void>()>& run) {
  try {
    if (const Result<void> done = run(); !done)
      return fail(name, done.error());
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return fail(name, {ErrorKind::resources, "standard output: cannot be written"});
    return 0;
  } catch (const Failure& failure) {
    return fail(name, failure.error);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: not enough memory\n", name); // allocates nothing
    return int(ErrorKind::resources);
  } catch (const std::exception& fault) {
    return fail(name, {ErrorKind::environment, fault.what()});
  }
}

} // namespace lichen::renderer
