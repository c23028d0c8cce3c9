// SPDX-License-Identifier: MIT
// lichen-exemplars OUTDIR [--size N] [NAME...]: writes the project's example exemplars as PNG, and
// meshes to use them on.
#include "materials.h"
#include "scanned_shape.h"
#include "terrain.h"

#include <lichen/escaped.h>
#include <lichen/files.h>
#include <lichen/image_io.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <options.h>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace {

using namespace lichen;

int fail(ErrorKind kind, const std::string& message) {
  std::fprintf(stderr, "lichen-exemplars: %s\n", escaped(message).c_str());
  return int(kind);
}

/// Names of the meshes.
constexpr const char* kScan = "scan";
constexpr const char* kTerrain = "terrain"; // written together with its mask

std::vector<exemplars::Material> pictures() {
  std::vector<exemplars::Material> all(exemplars::kMaterials.begin(), exemplars::kMaterials.end());
  all.push_back({"bricks", exemplars::bricks});
  return all;
}

/// Prints the path of a written file, or the error. Returns the exit code.
int reportWritten(const Result<void>& written, const std::filesystem::path& path) {
  if (!written)
    return fail(written.error().kind, written.error().message);
  std::printf("%s\n", escaped(path.string()).c_str());
  return 0;
}

/// Returns the exit code.
int createFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? fail(ErrorKind::environment,
                      folder.string() + ": cannot create the folder: " + error.message())
               : 0;
}

int writeFiles(const std::filesystem::path& folder, int side, const std::set<std::string>& names) {
  int code = createFolder(folder);
  const auto isNamed = [&](const char* name) { return names.contains(name); };
  const auto writeMesh = [&](const char* name, const std::vector<std::byte>& glb) {
    const std::filesystem::path path = folder / (std::string(name) + ".glb");
    return reportWritten(replaceFile(path, glb), path);
  };
  const auto writePicture = [&](const std::string& name, const SrgbImage& image) {
    const std::filesystem::path path = folder / (name + ".png");
    return reportWritten(writeImage(path, image), path);
  };
  for (const exemplars::Material& picture : pictures())
    if (code == 0 && isNamed(picture.name))
      code = writePicture(picture.name, picture.generate(side));
  if (code == 0 && isNamed(kScan))
    code = writeMesh(kScan, exemplars::scannedShapeGlb());
  if (code == 0 && isNamed(kTerrain))
    code = writeMesh(kTerrain, exemplars::terrainGlb());
  if (code == 0 && isNamed(kTerrain))
    code = writePicture(std::string(kTerrain) + "_mask", exemplars::terrainMask(side));
  return code;
}

int failUsage(const std::string& message) {
  return fail(ErrorKind::usage, message + "; see 'lichen-exemplars --help'");
}

int run(int argc, char** argv) {
  std::vector<std::string> known;
  for (const exemplars::Material& picture : pictures())
    known.emplace_back(picture.name);
  known.emplace_back(kScan);
  known.emplace_back(kTerrain);

  CLI::App app("Writes the project's example exemplars (8-bit sRGB PNG) and meshes to use them on.",
               "lichen-exemplars");
  app.set_help_flag("-h,--help", "Print this page and exit");
  app.formatter(cli::helpFormatter());
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  std::string folder;
  int side = 0;
  std::vector<std::string> names;
  cli::addText(app, "OUTDIR", folder, "", "Output folder; created if it does not exist").required();
  cli::addTexts(app, "NAME", names, "...",
                "Exemplars to write: " + cli::alternatives(known) + " [default: the first " +
                    std::to_string(exemplars::kMaterials.size()) + ", the materials]");
  cli::addValue(app, "--size", side,
                cli::wholeNumber(exemplars::kSmallestSide, exemplars::kLargestSide), "512",
                "Pixels per side; details have the same size in pixels");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request); // --help
  } catch (const CLI::ParseError& error) {
    return failUsage(cli::parseFault(app, error));
  }
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      return failUsage(name + ": no such exemplar; expected " + cli::alternatives(known));
  if (names.empty())
    for (const exemplars::Material& material : exemplars::kMaterials)
      names.emplace_back(material.name);
  return writeFiles(folder, side, {names.begin(), names.end()});
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::resources, "out of memory; try a smaller --size");
  } catch (const std::exception& error) {
    return fail(ErrorKind::badInput, error.what());
  }
}
