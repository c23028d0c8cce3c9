// SPDX-License-Identifier: MIT
// lichen-exemplars OUTDIR [--size N] [NAME...]: writes the project's own example exemplars as PNG,
// and meshes to put them on.
#include "landscape.h"
#include "materials.h"
#include "scanned_shape.h"
#include "terrain.h"
#include "unsuitable.h"

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
#include <string>
#include <system_error>
#include <vector>

namespace {

using namespace lichen;

int fail(ErrorKind kind, const std::string& message) {
  std::fprintf(stderr, "lichen-exemplars: %s\n", message.c_str());
  return int(kind);
}

/// The names of the meshes, which are no pictures.
constexpr const char* kScan = "scan";
constexpr const char* kTerrain = "terrain"; // with its mask
constexpr const char* kLandscape = "landscape";

/// The materials, then the pictures that do not suit.
std::vector<exemplars::Material> pictures() {
  std::vector<exemplars::Material> all(exemplars::kMaterials.begin(), exemplars::kMaterials.end());
  for (const exemplars::Unsuitable& picture : exemplars::kUnsuitable)
    all.push_back({picture.name, picture.generate});
  return all;
}

/// 0, or after a message the exit code.
int codeOf(const Result<void>& written, const std::filesystem::path& path) {
  if (!written)
    return fail(written.error().kind, written.error().message);
  std::printf("%s\n", path.c_str());
  return 0;
}

int writeFiles(const std::filesystem::path& folder, int side,
               const std::vector<std::string>& names) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return fail(ErrorKind::environment,
                folder.string() + ": cannot make the folder: " + error.message());
  const auto isNamed = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const auto writeMesh = [&](const char* name, const std::vector<std::byte>& glb) {
    const std::filesystem::path path = folder / (std::string(name) + ".glb");
    return codeOf(replaceFile(path, glb), path);
  };
  const auto writePicture = [&](const std::string& name, const SrgbImage& image) {
    const std::filesystem::path path = folder / (name + ".png");
    return codeOf(writeImage(path, image), path);
  };
  int code = 0;
  for (const exemplars::Material& picture : pictures())
    if (code == 0 && isNamed(picture.name))
      code = writePicture(picture.name, picture.generate(side));
  if (code == 0 && isNamed(kScan))
    code = writeMesh(kScan, exemplars::scannedShapeGlb());
  if (code == 0 && isNamed(kTerrain))
    code = writeMesh(kTerrain, exemplars::terrainGlb());
  if (code == 0 && isNamed(kTerrain))
    code = writePicture(std::string(kTerrain) + "_mask", exemplars::terrainMask(side));
  if (code == 0 && isNamed(kLandscape))
    code = writeMesh(kLandscape, exemplars::landscapeGlb());
  return code;
}

int failUsage(const std::string& message) {
  return fail(ErrorKind::usage, message + "; see 'lichen-exemplars --help'");
}

/// What the parser found wrong, in the words of the command line.
int failUsage(const CLI::App& app, const CLI::ParseError& fault) {
  const std::string text = fault.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr)
    return failUsage(app.remaining().front() + ": no such option");
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&fault) != nullptr)
    return failUsage(text.substr(0, text.find(':')) + ": a value is missing");
  return failUsage(text);
}

int run(int argc, char** argv) {
  std::vector<std::string> known;
  for (const exemplars::Material& picture : pictures())
    known.emplace_back(picture.name);
  known.emplace_back(kScan);
  known.emplace_back(kTerrain);
  known.emplace_back(kLandscape);

  CLI::App app("Writes the project's own example exemplars: tileable PNG, 8-bit sRGB; and meshes "
               "to put them on.",
               "lichen-exemplars");
  app.set_help_flag("-h,--help", "Print this page and exit");
  app.formatter(cli::helpFormatter());
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  std::string folder;
  int side = 0;
  std::vector<std::string> names;
  cli::addText(app, "OUTDIR", folder, "", "The folder, made when absent").required();
  cli::addTexts(app, "NAME", names, "...",
                "Which ones: " + cli::alternatives(known) + " [default: the " +
                    std::to_string(exemplars::kMaterials.size()) + " materials, which come first]");
  cli::addValue(app, "--size", side,
                cli::wholeNumber(exemplars::kSmallestSide, exemplars::kLargestSide), "512",
                "Pixels a side; details keep their size");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request); // --help
  } catch (const CLI::ParseError& error) {
    return failUsage(app, error);
  }
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return failUsage(name + ": no such exemplar; " + cli::alternatives(known) + " is accepted");
  if (names.empty())
    for (const exemplars::Material& material : exemplars::kMaterials)
      names.emplace_back(material.name);
  return writeFiles(folder, side, names);
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::resources, "memory exhausted; try a smaller --size");
  } catch (const std::exception& error) {
    return fail(ErrorKind::badInput, error.what());
  }
}
