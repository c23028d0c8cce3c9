// SPDX-License-Identifier: MIT
// lichen-render: renders a glTF scene to a picture.
#include "debug_views.h"
#include "picture.h"
#include "program.h"
#include "progress_line.h"
#include "renderer.h"

#include <lichen/files.h>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <options.h>

namespace lichen::renderer {
namespace {

constexpr const char* kProgram = "lichen-render";
constexpr double kMaxDepth = 1e6; // metres, as the largest tile

/// addOptions() sets the defaults.
struct Command : SceneOptions {
  std::string output;
  double depth = 0.0; ///< of displacement, in metres
  std::string debugView;
  bool listDevices = false;
  bool json = false;
  bool quiet = false;
};

void addOptions(CLI::App& app, Command& command) {
  using namespace cli;
  addSceneOptions(app, command, "16");
  addText(app, "-o,--output", command.output, "OUT.png|OUT.exr",
          "Picture to write: .png is tone-mapped sRGB, .exr linear light (required)");
  addValue(app, "--displace", command.depth, number({0.0, kMaxDepth}), "0",
           "Move surfaces out along their normals by the height of their noise times so many "
           "metres");
  Choices<std::string> views;
  for (const std::string_view name : debugViewNames())
    views.emplace_back(name, name);
  addValue(app, "--debug-view", command.debugView, oneOf(views), "",
           "Show one quantity instead of the shaded scene");
  addFlag(app, "--list-devices", command.listDevices, "List the Vulkan devices and exit");
  addFlag(app, "--json", command.json,
          "Write one JSON object, and nothing else, to standard output");
  addFlag(app, "--quiet", command.quiet, "Print errors only, no notes and no report");
}

/// Errors: usage; environment if the output folder does not exist.
Result<void> check(const Command& command) {
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

Result<void> listDevices(bool json) {
  Result<std::vector<std::string>> devices = VulkanDevice::listDevices();
  if (!devices)
    return devices.error();
  if (json)
    std::printf("%s\n", nlohmann::json{{"devices", devices.value()}}.dump().c_str());
  else
    for (std::size_t i = 0; i < devices.value().size(); ++i)
      std::printf("%zu %s\n", i, devices.value()[i].c_str());
  return {};
}

void note(const Command& command, const std::vector<std::string>& lines) {
  if (!command.quiet && !command.json) // the JSON report contains them
    writeNotes(lines);
}

std::size_t triangleCount(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Instance& instance : scene.instances)
    triangles += scene.primitives[instance.primitive].indices.size() / 3;
  return triangles;
}

void report(const Command& command, const std::string& device, const Scene& scene,
            const Picture& picture, double seconds) {
  if (command.json) {
    std::vector<std::string> notes = scene.notes;
    notes.insert(notes.end(), picture.notes.begin(), picture.notes.end());
    const nlohmann::ordered_json object{{"output", command.output},
                                        {"width", command.size[0]},
                                        {"height", command.size[1]},
                                        {"frames", command.frames},
                                        {"device", device},
                                        {"triangles", triangleCount(scene)},
                                        {"notes", notes},
                                        {"setupSeconds", picture.setupSeconds},
                                        {"medianFrameSeconds", picture.medianFrameSeconds},
                                        {"seconds", seconds}};
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
    std::printf("%s\n", object.dump(2, ' ', false, kReplace).c_str());
  } else if (!command.quiet) {
    std::printf("%s: %d x %d, %d frame%s on %s, %.2f s\n", oneLine(command.output).c_str(),
                command.size[0], command.size[1], command.frames, command.frames == 1 ? "" : "s",
                device.c_str(), seconds);
  }
}

Result<Picture> render(const Command& command, VulkanDevice& device, const Scene& scene,
                       RenderSettings settings) {
  cli::SharedOptions shared;
  shared.quiet = command.quiet;
  cli::ProgressLine progress("render", shared);
  settings.frameDone = [&](std::uint32_t frames) {
    progress.show(double(frames) / double(settings.frames));
  };
  return renderScene(device, scene, settings);
}

Result<void> run(const Command& command) {
  const auto start = std::chrono::steady_clock::now();
  Result<Scene> scene = readScene(command.scene);
  if (!scene)
    return scene.error();
  std::vector<std::string>& notes = scene.value().notes;
  const std::size_t ofScene = notes.size();
  note(command, notes);
  Result<RenderSettings> settings = settingsOf(command, notes);
  if (!settings)
    return settings.error();
  note(command, {notes.begin() + std::ptrdiff_t(ofScene), notes.end()});
  settings.value().toneMap = std::filesystem::path(command.output).extension() == ".png";
  settings.value().debugView = command.debugView;
  settings.value().displacement.depth = float(command.depth);
  Result<std::unique_ptr<VulkanDevice>> device = VulkanDevice::create(deviceOptionsOf(command));
  if (!device)
    return device.error();
  Result<Picture> picture =
      render(command, *device.value(), scene.value(), std::move(settings).value());
  if (!picture)
    return picture.error();
  note(command, picture.value().notes);
  if (Result<void> written = writePicture(command.output, picture.value().pixels); !written)
    return written;
  const std::string deviceName = device.value()->properties().deviceName;
  const std::shared_ptr<const ValidationMessages> messages = device.value()->keptMessages();
  device.value().reset(); // so that the layers report leaked objects
  if (Result<void> checked = checkMessages(*messages); !checked)
    return checked;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(command, deviceName, scene.value(), picture.value(), seconds.count());
  return {};
}

Result<void> parseAndRun(int argc, char** argv) {
  Command command;
  CLI::App app("Renders a glTF scene, including its noise materials, to a picture.", kProgram);
  addOptions(app, command);
  const Result<bool> parsed = parseArguments(app, argc, argv);
  if (!parsed)
    return parsed.error();
  if (!parsed.value())
    return {};
  if (command.listDevices)
    return listDevices(command.json);
  if (Result<void> checked = check(command); !checked)
    return checked;
  return run(command);
}

} // namespace
} // namespace lichen::renderer

int main(int argc, char** argv) {
  using namespace lichen::renderer;
  return runProgram(kProgram, [&] { return parseAndRun(argc, argv); });
}
