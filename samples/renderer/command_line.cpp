// SPDX-License-Identifier: MIT
#include "command_line.h"

#include "printable.h"
#include "renderer.h"

#include <CLI/CLI.hpp>

#include <charconv>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kMaxSide = 16384;
constexpr std::uint32_t kMaxFrames = 4096;
constexpr float kMaxExposure = 20.0f;

Error usage(const std::string& message) { return Error{ErrorKind::usage, message}; }

Result<void> parseSize(const std::string& text, Command& command) {
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, command.width);
  bool fits = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  if (fits) {
    const auto height = std::from_chars(width.ptr + 1, end, command.height);
    fits = height.ec == std::errc() && height.ptr == end;
  }
  if (!fits || command.width < 1 || command.height < 1 || command.width > kMaxSide ||
      command.height > kMaxSide)
    return usage("--size " + printable(text) + ": WxH with sides from 1 to " +
                 std::to_string(kMaxSide) + " is accepted, such as 1280x720");
  return {};
}

Result<void> check(const Command& command) {
  if (command.listDevices)
    return {};
  if (command.scene.empty())
    return usage("no scene: lichen-render SCENE.glb -o OUT.png");
  const std::string extension = command.output.extension().string();
  if (command.output.empty() || (extension != ".png" && extension != ".exr"))
    return usage("-o " + printable(command.output.string()) +
                 ": a name that ends in .png or .exr "
                 "is accepted");
  if (command.frames < 1 || command.frames > kMaxFrames)
    return usage("--frames " + std::to_string(command.frames) + ": 1 to " +
                 std::to_string(kMaxFrames) + " is accepted");
  if (!(command.exposureEv >= -kMaxExposure && command.exposureEv <= kMaxExposure))
    return usage("--exposure: -20 to 20 stops are accepted");
  if (!command.debugView.empty()) {
    const auto names = debugViewNames();
    std::string list;
    for (const std::string_view name : names) {
      if (name == command.debugView)
        return {};
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    return usage("--debug-view " + printable(command.debugView) + ": one of " + list +
                 " is accepted");
  }
  return {};
}

} // namespace

Result<std::variant<Command, std::string>> parseCommandLine(int argc, const char* const* argv) {
  Command command;
  std::string size = "1280x720";
  CLI::App app("Renders a glTF scene, its noise materials included, to a picture.",
               "lichen-render");
  app.add_option("SCENE", command.scene, "a .glb or .gltf file");
  app.add_option("-o,--output", command.output,
                 "the picture: .png (tone-mapped, sRGB) or .exr (light, half floats)");
  app.add_option("--size", size, "width x height in pixels")->capture_default_str();
  app.add_option("--camera", command.camera,
                 "name of a camera of the scene, or auto (default: its first camera, else auto)");
  app.add_option("--environment", command.environment,
                 "light from a latitude-longitude panorama, .exr or .png, instead of the sky");
  app.add_option("--exposure", command.exposureEv, "stops")->capture_default_str();
  app.add_option("--frames", command.frames,
                 "frames to average: edges, penumbrae and the sky's "
                 "light get smoother")
      ->capture_default_str();
  app.add_option("--debug-view", command.debugView,
                 "normals, base-color, weights, lattice, mip-level or gaussian");
  app.add_option("--device", command.device, "index or part of the name of a Vulkan device");
  app.add_flag("--validate", command.validate,
               "fail if the Vulkan validation layers have anything to say");
  app.add_flag("--json", command.json, "print what was done as one JSON object");
  app.add_flag("--list-devices", command.listDevices, "print the Vulkan devices there are");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return std::variant<Command, std::string>(app.help());
  } catch (const CLI::ParseError& fault) {
    return usage(printable(fault.what(), 200) + "; lichen-render --help lists the options");
  }
  if (Result<void> parsed = parseSize(size, command); !parsed)
    return parsed.error();
  if (Result<void> checked = check(command); !checked)
    return checked.error();
  return std::variant<Command, std::string>(std::move(command));
}

} // namespace lichen::renderer
