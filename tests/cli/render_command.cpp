// SPDX-License-Identifier: MIT
// lichen-render as a user runs it: exit codes, one-line messages, files.
#include "../gpu/render_gltf.h"
#include "checkout_paths.h"
#include "device_needed.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <sys/wait.h>

using namespace lichen;
using namespace lichen::test;
using cli_test::hasDevice;

namespace {

struct Outcome {
  int exitCode = -1;
  std::string output; ///< standard output and standard error
};

/// Runs through the shell. Redirections are the only characters in the arguments that it
/// interprets.
Outcome run(const std::string& arguments, const std::string& environment = "") {
  const std::string command =
      environment + " '" + programPath("lichen-render") + "' 2>&1 " + arguments;
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    outcome.output.append(buffer.data(), count);
  const int status = ::pclose(pipe);
  outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

bool isOneLine(const std::string& text) {
  return !text.empty() && text.find('\n') == text.size() - 1;
}

/// Checks the exit code, and that the only line of output has these words.
void checkRefused(const std::string& arguments, int code, const std::string& words = "",
                  const std::string& environment = "") {
  const Outcome outcome = run(arguments, environment);
  INFO(arguments << ": " << outcome.output);
  CHECK(outcome.exitCode == code);
  CHECK(isOneLine(outcome.output));
  CHECK(outcome.output.find(words) != std::string::npos);
}

} // namespace

TEST_CASE("wrong arguments are a usage error on one line that says what to do") {
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  const std::string out = " -o " + (folder.path() / "o.png").string() + " ";
  checkRefused("", 2);
  checkRefused(scene, 2);
  checkRefused(scene + " -o picture.bmp", 2);
  for (const char* arguments : {"--size 0", "--size 99999", "--size 100x", "--size 10x99999",
                                "--size 10x10x10", "--frames 0", "--frames many", "--exposure 99",
                                "--debug-view colours", "--unknown", "second.glb"})
    checkRefused(scene + out + arguments, 2);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "o.png"));
}

TEST_CASE("help and version exit with 0") {
  const Outcome help = run("--help");
  CHECK(help.exitCode == 0);
  CHECK(help.output.find("--debug-view") != std::string::npos);
  const Outcome version = run("--version");
  CHECK(version.exitCode == 0);
  CHECK(version.output == "lichen-render " LICHEN_VERSION "\n");
}

TEST_CASE("a scene that cannot be read is bad input") {
  const TemporaryFolder folder;
  const auto written = [&](const char* name, const std::string& text) {
    return writeInto(folder, name, std::as_bytes(std::span(text))).string();
  };
  for (const std::string& path :
       {written("s.gltf", "{}"), written("half.gltf", "{\"asset\": {"), written("photo.jpg", "no"),
        folder.path().string(), (folder.path() / "absent.glb").string()})
    checkRefused(path + " -o " + (folder.path() / "o.png").string(), 3, path);
}

TEST_CASE("a fault in a noise is bad input, and the error states its JSON pointer") {
  if (!hasDevice())
    return;
  const TemporaryFolder folder;
  const auto bytes = readFile(sourcePath("docs/gltf_extension/examples/felt.glb")).value();
  GltfScene scene(bytes);
  scene.addBall(0);
  scene.json["extensions"]["LICHEN_materials_exemplar_noise"]["noises"][0]["maps"][0]["gaussian"] =
      99;
  const std::string path = writeInto(folder, "s.glb", scene.glb()).string();
  checkRefused(path + " --size 8 -o " + (folder.path() / "o.png").string(), 3,
               path + ": /extensions/LICHEN_materials_exemplar_noise/noises/0/maps/0/gaussian");
}

TEST_CASE("displacement needs a height map") {
  if (!hasDevice())
    return;
  const TemporaryFolder folder;
  const auto bytes = readFile(sourcePath("docs/gltf_extension/examples/dune.glb")).value();
  GltfScene dune(bytes); // a height map
  dune.addBall(0);
  const std::string path = writeInto(folder, "dune.glb", dune.glb()).string();
  const std::string picture = (folder.path() / "o.png").string();
  const std::string small = " --size 16 --frames 1 --validate -o " + picture;
  const Outcome outcome = run(path + " --displace 0.1" + small);
  INFO(outcome.output);
  CHECK(outcome.exitCode == 0);
  CHECK(isOneLine(outcome.output)); // no note
  const std::string flat = writeInto(folder, "flat.glb", triangleScene().glb()).string();
  checkRefused(flat + " --displace 0.1" + small, 3,
               flat + ": no mesh has a noise with a height map");
  checkRefused(path + " --displace -1" + small, 2);
}

TEST_CASE("without a Vulkan device the error says what to install") {
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  checkRefused(scene + " -o " + (folder.path() / "o.png").string(), 4, "mesa-vulkan-drivers",
               "VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent");
}

TEST_CASE("lichen-render writes a PNG or EXR and a JSON report") {
  if (!hasDevice())
    return;
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  const std::string png = (folder.path() / "o.png").string();
  const Outcome outcome = run(scene + " -o " + png + " --size 40x30 --frames 2 --json --validate");
  INFO(outcome.output);
  REQUIRE(outcome.exitCode == 0);
  const auto json = nlohmann::json::parse(outcome.output);
  CHECK(json["width"] == 40);
  CHECK(json["triangles"] == 1);
  const auto image = readImage(png);
  REQUIRE(image.ok());
  CHECK(std::get<SrgbImage>(image.value().pixels).width == 40);

  const std::string exr = (folder.path() / "o.exr").string();
  CHECK(run(scene + " -o " + exr + " --size 40x30 --frames 1").exitCode == 0);
  CHECK(readImage(exr).ok());
  CHECK(run(scene + " -o " + png + " --environment " + exr + " --size 8x8 --frames 1").exitCode ==
        0);
}

TEST_CASE("lichen-render reports a picture on one line with notes, or nothing with --quiet") {
  if (!hasDevice())
    return;
  const TemporaryFolder folder;
  GltfScene noted = triangleScene();
  noted.json["extensionsUsed"] = {"KHR_materials_clearcoat"};
  const std::string png = (folder.path() / "o.png").string();
  const std::string arguments =
      writeInto(folder, "s.glb", noted.glb()).string() + " -o " + png + " --size 24 --frames 1 ";
  const Outcome report = run(arguments + "2>/dev/null");
  CHECK(isOneLine(report.output));
  CHECK(report.output.find(png + ": 24 x 24, 1 frame on ") == 0);
  const Outcome notes = run(arguments + ">/dev/null");
  CHECK(notes.output == "note: the extension KHR_materials_clearcoat is ignored\n");
  CHECK(run(arguments + "--quiet").output.empty());
  const Outcome json = run(arguments + "--quiet --json");
  CHECK(nlohmann::json::parse(json.output)["notes"][0] ==
        "the extension KHR_materials_clearcoat is ignored");
}

TEST_CASE("control characters in names are escaped on the terminal, other characters are not") {
  checkRefused("\"$(printf 'm\\033[31m\\302\\233\\177\\nf\\303\\274').glb\" -o o.png", 3,
               "m\\x1b[31m\\xc2\\x9b\\x7f\\x0af\xc3\xbc.glb");
  checkRefused("\"$(printf 'latin f\\374.glb')\" -o o.png", 3, "latin f\\xfc.glb: ");
}

TEST_CASE("a failed write to standard output is an error of one line") {
  for (const char* arguments : {"--help >/dev/full", "--version >/dev/full"}) {
    const Outcome full = run(arguments);
    CHECK(full.exitCode == 5);
    CHECK(full.output == "lichen-render: standard output: cannot be written\n");
  }
  if (!hasDevice())
    return;
  CHECK(run("--list-devices >/dev/full").exitCode == 5);
}

TEST_CASE("errors that only the device can find have their exit codes") {
  if (!hasDevice())
    return;
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  const std::string out = " -o " + (folder.path() / "o.png").string() + " --size 8x8 --frames 1 ";
  checkRefused(scene + out + "--device no-such-device", 2);
  checkRefused(scene + out + "--device 99", 2,
               "--device 99: no such Vulkan device; this machine has \"");
  checkRefused(scene + out + "--camera nowhere", 2);
  checkRefused(scene + out + "--environment " + scene, 3);
  checkRefused(scene + " -o /nonexistent/o.png --size 8x8 --frames 1", 4);
}
