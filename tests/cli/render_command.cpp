// SPDX-License-Identifier: MIT
// lichen-render as a user runs it: exit codes, one-line messages, files.
#include "../gpu/render_gltf.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <sys/wait.h>

using namespace lichen;
using namespace lichen::test;

namespace {

struct Outcome {
  int exitCode = -1;
  std::string output; ///< standard output and standard error
};

/// Runs through the shell; arguments hold no character that it would change.
Outcome run(const std::string& arguments, const std::string& environment = "") {
  const std::string command = environment + " '" LICHEN_RENDER "' " + arguments + " 2>&1";
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

bool hasDevice() {
  static const int exitCode = run("--list-devices").exitCode;
  return exitCode == 0;
}

} // namespace

TEST_CASE("wrong arguments are a usage error on one line with the cure") {
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  const std::string out = " -o " + (folder.path() / "o.png").string() + " ";
  const std::array cases{
      std::string(""),
      scene,
      scene + " -o picture.bmp",
      scene + out + "--size 100",
      scene + out + "--size 0x10",
      scene + out + "--size 10x99999",
      scene + out + "--size 10x10x10",
      scene + out + "--frames 0",
      scene + out + "--frames many",
      scene + out + "--exposure 99",
      scene + out + "--debug-view colours",
      scene + out + "--unknown",
      scene + out + "second.glb",
  };
  for (const std::string& arguments : cases) {
    INFO(arguments);
    const Outcome outcome = run(arguments);
    INFO(outcome.output);
    CHECK(outcome.exitCode == 2);
    CHECK(isOneLine(outcome.output));
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "o.png"));
}

TEST_CASE("help is no error") {
  const Outcome outcome = run("--help");
  CHECK(outcome.exitCode == 0);
  CHECK(outcome.output.find("--debug-view") != std::string::npos);
}

TEST_CASE("a scene that cannot be read is bad input") {
  const TemporaryFolder folder;
  const std::string text = "{}";
  const std::string scene = writeInto(folder, "s.gltf", std::as_bytes(std::span(text))).string();
  for (const std::string& path : {scene, (folder.path() / "absent.glb").string()}) {
    const Outcome outcome = run(path + " -o " + (folder.path() / "o.png").string());
    INFO(outcome.output);
    CHECK(outcome.exitCode == 3);
    CHECK(isOneLine(outcome.output));
    CHECK(outcome.output.find(path) != std::string::npos);
  }
}

TEST_CASE("a machine without a Vulkan device is told what to install") {
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  const Outcome outcome = run(scene + " -o " + (folder.path() / "o.png").string(),
                              "VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent");
  INFO(outcome.output);
  CHECK(outcome.exitCode == 4);
  CHECK(isOneLine(outcome.output));
  CHECK(outcome.output.find("mesa-vulkan-drivers") != std::string::npos);
}

TEST_CASE("a picture is written as PNG or EXR, and JSON says what was done") {
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

TEST_CASE("what only the device can tell has its exit code too") {
  if (!hasDevice())
    return;
  const TemporaryFolder folder;
  const std::string scene = writeInto(folder, "s.glb", triangleScene().glb()).string();
  const std::string out = " -o " + (folder.path() / "o.png").string() + " --size 8x8 --frames 1 ";
  CHECK(run(scene + out + "--device no-such-device").exitCode == 2);
  CHECK(run(scene + out + "--camera nowhere").exitCode == 2);
  CHECK(run(scene + out + "--environment " + scene).exitCode == 3);
  const Outcome noFolder = run(scene + " -o /nonexistent/o.png --size 8x8 --frames 1");
  INFO(noFolder.output);
  CHECK(noFolder.exitCode == 4);
  CHECK(isOneLine(noFolder.output));
}
