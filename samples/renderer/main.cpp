// SPDX-License-Identifier: MIT
// lichen-render: renders a glTF scene to a picture.
#include "command_line.h"
#include "environment.h"
#include "picture.h"
#include "program.h"
#include "progress_line.h"
#include "renderer.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>

namespace lichen::renderer {
namespace {

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
  if (command.listDevices)
    return listDevices(command.json);
  const auto start = std::chrono::steady_clock::now();
  Result<Scene> scene = readScene(command.scene);
  if (!scene)
    return scene.error();
  note(command, scene.value().notes);

  RenderSettings settings;
  settings.width = std::uint32_t(command.size[0]);
  settings.height = std::uint32_t(command.size[1]);
  settings.frames = std::uint32_t(command.frames);
  settings.camera = command.camera;
  settings.exposureEv = float(command.exposureEv);
  settings.toneMap = std::filesystem::path(command.output).extension() == ".png";
  settings.debugView = command.debugView;
  settings.displacement.depth = float(command.depth);
  if (!command.environment.empty()) {
    std::vector<std::string> notes;
    Result<LinearImage> panorama = readPanorama(command.environment, notes);
    if (!panorama)
      return panorama.error();
    note(command, notes);
    scene.value().notes.insert(scene.value().notes.end(), notes.begin(), notes.end());
    settings.environment = std::move(panorama).value();
  }
  VulkanDeviceOptions options;
  options.choice = command.device;
  options.validation = command.validate;
  Result<std::unique_ptr<VulkanDevice>> device = VulkanDevice::create(options);
  if (!device)
    return device.error();
  Result<Picture> picture = render(command, *device.value(), scene.value(), settings);
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

} // namespace
} // namespace lichen::renderer

int main(int argc, char** argv) {
  using namespace lichen::renderer;
  return runProgram("lichen-render", [&]() -> lichen::Result<void> {
    lichen::Result<std::variant<Command, std::string>> parsed = parseCommandLine(argc, argv);
    if (!parsed)
      return parsed.error();
    if (const auto* text = std::get_if<std::string>(&parsed.value())) {
      std::fputs(text->c_str(), stdout);
      return {};
    }
    return run(std::get<Command>(parsed.value()));
  });
}
