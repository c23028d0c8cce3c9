// SPDX-License-Identifier: MIT
// lichen-render: a glTF scene -> a picture.
#include "command_line.h"
#include "picture.h"
#include "renderer.h"

#include <lichen/image_io.h>

#include <nlohmann/json.hpp>

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

Result<void> checkMessages(HeadlessDevice& device) {
  const std::vector<std::string> texts = device.messages().texts();
  if (texts.empty())
    return {};
  for (const std::string& text : texts)
    std::fprintf(stderr, "%s\n", text.c_str());
  return Error{ErrorKind::environment, std::to_string(texts.size()) +
                                           " messages of the Vulkan validation layers; please "
                                           "report them"};
}

void report(const Command& command, HeadlessDevice& device, const Scene& scene,
            const Picture& picture) {
  if (!command.json)
    return;
  std::size_t triangles = 0;
  for (const Instance& instance : scene.instances)
    triangles += scene.primitives[instance.primitive].indices.size() / 3;
  const nlohmann::json object{{"output", command.output.string()},
                              {"width", command.width},
                              {"height", command.height},
                              {"frames", command.frames},
                              {"device", device.properties().deviceName},
                              {"triangles", triangles},
                              {"setupSeconds", picture.setupSeconds},
                              {"medianFrameSeconds", picture.medianFrameSeconds},
                              {"notes", scene.notes}};
  std::printf("%s\n",
              object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

Result<void> run(const Command& command) {
  if (command.listDevices)
    return listDevices(command.json);
  Result<Scene> scene = readScene(command.scene);
  if (!scene)
    return scene.error();
  if (!command.json)
    for (const std::string& note : scene.value().notes)
      std::fprintf(stderr, "note: %s\n", note.c_str());

  RenderSettings settings;
  settings.width = command.width;
  settings.height = command.height;
  settings.frames = command.frames;
  settings.camera = command.camera;
  settings.exposureEv = command.exposureEv;
  settings.toneMap = command.output.extension() == ".png";
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
  Result<Picture> picture = renderScene(*device.value(), scene.value(), settings);
  if (!picture)
    return picture.error();
  if (Result<void> written = writePicture(command.output, picture.value().pixels); !written)
    return written;
  report(command, *device.value(), scene.value(), picture.value());
  return checkMessages(*device.value());
}

int fail(const Error& error) {
  std::fprintf(stderr, "lichen-render: %s\n", error.message.c_str());
  return int(error.kind);
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
      return 0;
    }
    const lichen::Result<void> done = run(std::get<Command>(parsed.value()));
    return done ? 0 : fail(done.error());
  } catch (const std::bad_alloc&) {
    return fail({lichen::ErrorKind::resources, "not enough memory"});
  } catch (const std::exception& fault) {
    return fail({lichen::ErrorKind::environment, fault.what()});
  }
}
