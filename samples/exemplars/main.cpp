// SPDX-License-Identifier: MIT
// lichen-exemplars OUTDIR [--size N] [NAME...]: writes the project's example exemplars as PNG, and
// meshes to use them on.
#include "landscape.h"
#include "materials.h"
#include "photographs.h"
#include "scanned_shape.h"
#include "structured.h"
#include "terrain.h"
#include "unsuitable.h"

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
#include <functional>
#include <new>
#include <options.h>
#include <set>
#include <string>
#include <system_error>
#include <utility>
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
constexpr const char* kLandscape = "landscape";
/// Name of the sixty photographs.
constexpr const char* kPhotographs = "photographs";
/// Name of the structured materials, with their cells.
constexpr const char* kStructured = "structured";
/// After the name of one of them: its maps instead, in a folder.
constexpr const char* kMapsEnding = "-maps";

/// The materials, then the unsuitable pictures.
std::vector<exemplars::Material> pictures() {
  std::vector<exemplars::Material> all(exemplars::kMaterials.begin(), exemplars::kMaterials.end());
  for (const exemplars::Unsuitable& picture : exemplars::kUnsuitable)
    all.push_back({picture.name, picture.generate});
  return all;
}

/// Prints the path of a written file, or the error. Returns the exit code.
int reportWritten(const Result<void>& written, const std::filesystem::path& path) {
  if (!written)
    return fail(written.error().kind, written.error().message);
  std::printf("%s\n", escaped(path.string()).c_str());
  return 0;
}

using WritePicture = std::function<int(const std::string& name, const SrgbImage& image)>;

int writePhotographs(int side, const WritePicture& write) {
  int code = 0;
  std::string material;
  SrgbImage surface;
  for (const exemplars::PhotographPlan& plan : exemplars::sixtyPhotographs()) {
    if (code != 0)
      break;
    if (plan.material != material)
      surface = exemplars::photographedSurface(plan.material, side);
    material = plan.material;
    code = write(plan.name(), exemplars::photograph(surface, plan).image);
  }
  return code;
}

int writePhotograph(int side, const exemplars::StructuredPlan& plan, const WritePicture& write) {
  const exemplars::StructuredPicture picture = exemplars::structured(side, plan);
  const int code = write(plan.name(), picture.image);
  return code != 0 || picture.cells.empty()
             ? code
             : write(plan.name() + "-cells", exemplars::coloredCells(side, picture.cells));
}

int writeMaps(int side, const exemplars::StructuredPlan& plan, const WritePicture& write) {
  const exemplars::StructuredMaps maps = exemplars::structuredMaps(side, plan);
  const std::pair<const char*, const SrgbImage&> files[] = {{"color", maps.color},
                                                            {"normal_gl", maps.normal},
                                                            {"roughness", maps.roughness},
                                                            {"ao", maps.occlusion},
                                                            {"height", maps.height}};
  int code = 0;
  for (const auto& [name, image] : files)
    if (code == 0)
      code = write(plan.name() + kMapsEnding + "/" + name, image);
  return code;
}

/// Writes the photographs and maps that are named.
int writeStructured(int side, const std::set<std::string>& names, const WritePicture& write) {
  int code = 0;
  for (const exemplars::StructuredPlan& plan : exemplars::structuredPlans()) {
    if (code == 0 && (names.contains(kStructured) || names.contains(plan.name())))
      code = writePhotograph(side, plan, write);
    if (code == 0 && names.contains(plan.name() + kMapsEnding))
      code = writeMaps(side, plan, write);
  }
  return code;
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
    const int created = createFolder(path.parent_path()); // the folder of a set of maps
    return created != 0 ? created : reportWritten(writeImage(path, image), path);
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
  if (code == 0 && isNamed(kLandscape))
    code = writeMesh(kLandscape, exemplars::landscapeGlb());
  if (code == 0 && isNamed(kPhotographs))
    code = writePhotographs(side, writePicture);
  if (code == 0)
    code = writeStructured(side, names, writePicture);
  return code;
}

int failUsage(const std::string& message) {
  return fail(ErrorKind::usage, message + "; see 'lichen-exemplars --help'");
}

/// Rewrites a parser error in the style of the lichen command.
int failUsage(const CLI::App& app, const CLI::ParseError& fault) {
  const std::string text = fault.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr)
    return failUsage(app.remaining().front() + ": no such option");
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&fault) != nullptr)
    return failUsage(text.substr(0, text.find(':')) + ": a value is missing");
  return failUsage(text);
}

/// What a name should be; of one that begins like a structured material, which of those there are.
std::string expectedFor(const std::string& name, const std::vector<std::string>& known) {
  std::vector<std::string> materials, conditions;
  const auto add = [](std::vector<std::string>& names, const std::string& own) {
    if (std::ranges::find(names, own) == names.end())
      names.push_back(own);
  };
  bool isStructured = false;
  for (const exemplars::StructuredPlan& plan : exemplars::structuredPlans()) {
    add(materials, plan.material);
    add(conditions, plan.condition.name);
    isStructured = isStructured || name == plan.material ||
                   name.starts_with(std::string(plan.material) + "-") ||
                   name.ends_with(std::string("-") + plan.condition.name) ||
                   name.ends_with(std::string("-") + plan.condition.name + kMapsEnding);
  }
  if (!isStructured)
    return cli::alternatives(known) + ", or one of the structured, such as bond-even";
  return "MATERIAL-CONDITION or MATERIAL-CONDITION" + std::string(kMapsEnding) +
         " with the material " + cli::alternatives(materials) + ", and the condition " +
         cli::alternatives(conditions);
}

int run(int argc, char** argv) {
  std::vector<std::string> known;
  for (const exemplars::Material& picture : pictures())
    known.emplace_back(picture.name);
  known.emplace_back(kScan);
  known.emplace_back(kTerrain);
  known.emplace_back(kLandscape);
  known.emplace_back(kPhotographs);
  known.emplace_back(kStructured);

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
                "Exemplars to write: " + cli::alternatives(known) +
                    ", or one of the structured, such as bond-even, or its maps, such as "
                    "bond-even-maps [default: the first " +
                    std::to_string(exemplars::kMaterials.size()) + ", the materials]");
  cli::addValue(app, "--size", side,
                cli::wholeNumber(exemplars::kSmallestSide, exemplars::kLargestSide), "512",
                "Pixels per side; details have the same size in pixels");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request); // --help
  } catch (const CLI::ParseError& error) {
    return failUsage(app, error);
  }
  std::set<std::string> structured{kStructured};
  for (const exemplars::StructuredPlan& plan : exemplars::structuredPlans())
    structured.insert({plan.name(), plan.name() + kMapsEnding});
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end() && !structured.contains(name))
      return failUsage(name + ": no such exemplar; expected " + expectedFor(name, known));
  if (std::ranges::find(names, kPhotographs) != names.end() && side > exemplars::kLargestPhotograph)
    return failUsage("--size " + std::to_string(side) + ": photographs have at most " +
                     std::to_string(exemplars::kLargestPhotograph) + " pixels a side");
  const bool hasStructured = std::ranges::any_of(
      names, [&](const std::string& name) { return structured.contains(name); });
  if (hasStructured && side > exemplars::kLargestStructured)
    return failUsage("--size " + std::to_string(side) + ": structured materials have at most " +
                     std::to_string(exemplars::kLargestStructured) + " pixels a side");
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
