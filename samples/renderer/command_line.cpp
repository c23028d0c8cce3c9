// SPDX-License-Identifier: MIT
// Options of lichen-render and the checks that need no device.
#include "command_line.h"

#include "printable.h"
#include "renderer.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kMaxSide = 16384;
constexpr std::uint32_t kMaxFrames = 4096;
constexpr float kMaxExposure = 20.0f;

Error usage(const std::string& message) { return Error{ErrorKind::usage, message}; }

std::optional<std::uint32_t> parseSide(std::string_view text) {
  std::uint32_t side = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (code != std::errc() || end != text.data() + text.size() || side < 1 || side > kMaxSide)
    return std::nullopt;
  return side;
}

Result<void> parseSize(const std::string& text, Command& command) {
  const std::size_t cross = text.find('x');
  const auto width = parseSide(std::string_view(text).substr(0, cross));
  const auto height =
      cross == std::string::npos ? width : parseSide(std::string_view(text).substr(cross + 1));
  if (!width || !height)
    return usage("--size " + printable(text) + ": WIDTHxHEIGHT in pixels, 1 to " +
                 std::to_string(kMaxSide) + " each, is accepted, such as 1280x720");
  command.width = *width;
  command.height = *height;
  return {};
}

Result<void> checkOutput(const std::filesystem::path& output) {
  const std::string extension = output.extension().string();
  if (extension != ".png" && extension != ".exr")
    return usage("-o " + printable(output.string()) +
                 ": a name that ends in .png or .exr is "
                 "accepted");
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    return Error{ErrorKind::environment, output.string() + ": the folder " + folder.string() +
                                             " does not exist; make it first"};
  return {};
}

Result<void> checkDebugView(const std::string& wanted) {
  std::string list;
  for (const std::string_view name : debugViewNames()) {
    if (name == wanted)
      return {};
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return usage("--debug-view " + printable(wanted) + ": one of " + list + " is accepted");
}

Result<void> check(const Command& command) {
  if (command.listDevices)
    return {};
  if (command.scene.empty())
    return usage("no scene: lichen-render SCENE.glb -o OUT.png");
  if (command.frames < 1 || command.frames > kMaxFrames)
    return usage("--frames " + std::to_string(command.frames) + ": 1 to " +
                 std::to_string(kMaxFrames) + " is accepted");
  if (!(command.exposureEv >= -kMaxExposure && command.exposureEv <= kMaxExposure))
    return usage("--exposure: -20 to 20 stops are accepted");
  if (!command.debugView.empty())
    if (Result<void> known = checkDebugView(command.debugView); !known)
      return known;
  return checkOutput(command.output);
}

} // namespace

Result<std::variant<Command, std::string>> parseCommandLine(int argc, const char* const* argv) {
  Command command;
  std::string size = "1280x720";
  CLI::App app("Renders a glTF scene, its noise materials included, to a picture.",
               "lichen-render");
  app.set_version_flag("--version", "lichen-render " LICHEN_VERSION);
  app.add_option("SCENE", command.scene, "a .glb or .gltf file");
  app.add_option("-o,--output", command.output,
                 "the picture: .png (tone-mapped, sRGB) or .exr (light, half floats)");
  app.add_option("--size", size, "WIDTHxHEIGHT in pixels, or one number for a square")
      ->capture_default_str();
  app.add_option("--camera", command.camera,
                 "name of a camera of the scene, or auto (default: its first camera, else auto)");
  app.add_option("--environment", command.environment,
                 "light from a latitude-longitude panorama, EXR, PNG or JPEG, instead of the sky");
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
  app.add_flag("--json", command.json, "one JSON object on standard output, nothing else there");
  app.add_flag("--quiet", command.quiet, "no notes and no report; errors only");
  app.add_flag("--list-devices", command.listDevices, "print the Vulkan devices there are");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) { // --help and --version
    std::ostringstream text;
    app.exit(success, text);
    return std::variant<Command, std::string>(text.str());
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
