// SPDX-License-Identifier: MIT
// lichen-view: a glTF scene -> a window.
#include "controls.h"
#include "viewer.h"

#include <lichen/files.h>

#include <CLI/App.hpp>

#include <options.h>

namespace lichen::renderer {
namespace {

constexpr const char* kProgram = "lichen-view";

/// Errors: usage; environment if the folder for screenshots does not exist; what view() says.
Result<void> parseAndView(int argc, char** argv) {
  ViewCommand command;
  CLI::App app("Shows a glTF scene, including its noise materials, in a window, and loads it again "
               "when its file changes.",
               kProgram);
  app.footer("\n" + std::string(Controls::help()));
  addSceneOptions(app, command, "64");
  cli::addText(app, "-o,--output", command.output, "FOLDER",
               "Folder for screenshots [default: the current folder]");
  const Result<bool> parsed = parseArguments(app, argc, argv);
  if (!parsed)
    return parsed.error();
  if (!parsed.value())
    return {};
  if (command.scene.empty())
    return usageError(kProgram, "the scene is missing; give a .glb or .gltf file");
  if (command.output.empty())
    command.output = ".";
  if (Result<void> exists = checkFolder(command.output); !exists)
    return exists;
  return view(command);
}

} // namespace
} // namespace lichen::renderer

int main(int argc, char** argv) {
  using namespace lichen::renderer;
  return runProgram(kProgram, [&] { return parseAndView(argc, argv); });
}
