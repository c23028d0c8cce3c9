// SPDX-License-Identifier: MIT
// lichen-render: a glTF scene -> a picture.
#include "command_line.h"
#include "picture.h"
#include "printable.h"
#include "progress_line.h"
#include "renderer.h"

#include <lichen/image_io.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <exception>

namespace lichen::renderer {
namespace {

Result<LinearImage> readPanorama(const std::filesystem::path& path) {
  Result<ImageFile> file = readImage(path);
  if (!file)
    return file.error();
  if (const auto* code = std::get_if<SrgbImage>(&file.value().pixels))
    return toLinear(*code);
  return std::get<LinearImage>(std::move(file.value().pixels));
}

Result<void> listDevices(bool json) {
  Result<std::vector<std::string>> devices = HeadlessDevice::listDevices();
  if (!devices)
    return devices.error();
  if (json)
    std::printf("%s\n", nlohmann::json{{"devices", devices.value()}}.dump().c_str());
  else
    for (std::size_t i = 0; i < devices.value().size(); ++i)
      std::printf("%zu %s\n", i, devices.value()[i].c_str());
  return {};
}

Result<void> checkMessages(const ValidationMessages& messages) {
  const std::vector<std::string> texts = messages.texts();
  if (texts.empty())
    return {};
  for (const std::string& text : texts)
    std::fprintf(stderr, "%s\n", text.c_str());
  return Error{ErrorKind::environment, std::to_string(texts.size()) +
                                           " messages of the Vulkan validation layers; please "
                                           "report them"};
}

/// Of a message that names files, of any length.
std::string oneLine(const std::string& text) { return printable(text, std::string::npos); }

void note(const Command& command, const std::vector<std::string>& lines) {
  if (!command.quiet && !command.json) // there they are part of the report
    for (const std::string& line : lines)
      std::fprintf(stderr, "note: %s\n", oneLine(line).c_str());
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

Result<Picture> drawn(const Command& command, HeadlessDevice& device, const Scene& scene,
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
  if (!command.environment.empty()) {
    Result<LinearImage> panorama = readPanorama(command.environment);
    if (!panorama)
      return panorama.error();
    settings.environment = std::move(panorama).value();
  }
  HeadlessDeviceOptions options;
  options.choice = command.device;
  options.validation = command.validate;
  Result<std::unique_ptr<HeadlessDevice>> device = HeadlessDevice::create(options);
  if (!device)
    return device.error();
  Result<Picture> picture = drawn(command, *device.value(), scene.value(), settings);
  if (!picture)
    return picture.error();
  note(command, picture.value().notes);
  if (Result<void> written = writePicture(command.output, picture.value().pixels); !written)
    return written;
  const std::string deviceName = device.value()->properties().deviceName;
  const std::shared_ptr<const ValidationMessages> messages = device.value()->keptMessages();
  device.value().reset(); // the layers report what was never destroyed
  if (Result<void> silent = checkMessages(*messages); !silent)
    return silent;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(command, deviceName, scene.value(), picture.value(), seconds.count());
  return {};
}

int fail(const Error& error) {
  std::fprintf(stderr, "lichen-render: %s\n", oneLine(error.message).c_str());
  return int(error.kind);
}

int succeed() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail({ErrorKind::resources, "standard output: cannot be written"});
  return 0;
}

} // namespace
} // namespace lichen::renderer

int main(int argc, char** argv) {
  using namespace lichen::renderer;
  try {
    lichen::Result<std::variant<Command, std::string>> parsed = parseCommandLine(argc, argv);
    if (!parsed)
      return fail(parsed.error());
    if (const auto* help = std::get_if<std::string>(&parsed.value())) {
      std::fputs(help->c_str(), stdout);
      return succeed();
    }
    const lichen::Result<void> done = run(std::get<Command>(parsed.value()));
    return done ? succeed() : fail(done.error());
  } catch (const std::bad_alloc&) {
    std::fputs("lichen-render: not enough memory\n", stderr); // needs none itself
    return int(lichen::ErrorKind::resources);
  } catch (const std::exception& fault) {
    return fail({lichen::ErrorKind::environment, fault.what()});
  }
}
