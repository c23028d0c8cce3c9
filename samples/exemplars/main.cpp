// SPDX-License-Identifier: MIT
// lichen-exemplars OUTDIR [--size N] [NAME...]: writes the project's own example exemplars as PNG.
#include "materials.h"
#include "unsuitable.h"

#include <lichen/image_io.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <vector>

namespace {

using namespace lichen;

int fail(ErrorKind kind, const std::string& message) {
  std::fprintf(stderr, "lichen-exemplars: %s\n", message.c_str());
  return int(kind);
}

/// The materials, then the pictures that do not suit.
std::vector<exemplars::Material> pictures() {
  std::vector<exemplars::Material> all(exemplars::kMaterials.begin(), exemplars::kMaterials.end());
  for (const exemplars::Unsuitable& picture : exemplars::kUnsuitable)
    all.push_back({picture.name, picture.generate});
  return all;
}

int writePictures(const std::filesystem::path& folder, int side,
                  const std::vector<std::string>& names) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return fail(ErrorKind::environment,
                folder.string() + ": cannot make the folder: " + error.message());
  for (const exemplars::Material& picture : pictures()) {
    if (std::find(names.begin(), names.end(), picture.name) == names.end())
      continue;
    const std::filesystem::path path = folder / (std::string(picture.name) + ".png");
    const Result<void> written = writeImage(path, picture.generate(side));
    if (!written)
      return fail(written.error().kind, written.error().message);
    std::printf("%s\n", path.c_str());
  }
  return 0;
}

int run(int argc, char** argv) {
  std::vector<std::string> known;
  for (const exemplars::Material& picture : pictures())
    known.emplace_back(picture.name);

  CLI::App app("Writes the project's own example exemplars: tileable PNG, 8-bit sRGB.",
               "lichen-exemplars");
  std::filesystem::path folder;
  int side = 512;
  std::vector<std::string> names;
  app.add_option("OUTDIR", folder, "folder, made when absent")->required();
  app.add_option("--size", side, "pixels a side; details keep their size")
      ->check(CLI::Range(exemplars::kSmallestSide, exemplars::kLargestSide))
      ->capture_default_str();
  app.add_option("NAME", names,
                 "which ones; the materials when none is named, not those that do not suit")
      ->check(CLI::IsMember(known));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request); // --help
  } catch (const CLI::ParseError& error) {
    return fail(ErrorKind::usage, error.what());
  }
  if (names.empty())
    for (const exemplars::Material& material : exemplars::kMaterials)
      names.emplace_back(material.name);
  return writePictures(folder, side, names);
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
