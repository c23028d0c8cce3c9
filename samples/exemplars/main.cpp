// SPDX-License-Identifier: MIT
// lichen-exemplars OUTDIR [--size N] [NAME...]: writes the project's own example exemplars as PNG.
#include "materials.h"

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

int writeMaterials(const std::filesystem::path& folder, int side,
                   const std::vector<std::string>& names) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return fail(ErrorKind::environment,
                folder.string() + ": cannot make the folder: " + error.message());
  for (const exemplars::Material& material : exemplars::kMaterials) {
    if (!names.empty() && std::find(names.begin(), names.end(), material.name) == names.end())
      continue;
    const std::filesystem::path path = folder / (std::string(material.name) + ".png");
    const Result<void> written = writeImage(path, material.generate(side));
    if (!written)
      return fail(written.error().kind, written.error().message);
    std::printf("%s\n", path.c_str());
  }
  return 0;
}

int run(int argc, char** argv) {
  std::vector<std::string> known;
  for (const exemplars::Material& material : exemplars::kMaterials)
    known.emplace_back(material.name);

  CLI::App app("Writes the project's own example exemplars: tileable PNG, 8-bit sRGB.",
               "lichen-exemplars");
  std::filesystem::path folder;
  int side = 512;
  std::vector<std::string> names;
  app.add_option("OUTDIR", folder, "folder, made when absent")->required();
  app.add_option("--size", side, "pixels a side; details keep their size")
      ->check(CLI::Range(exemplars::kSmallestSide, exemplars::kLargestSide))
      ->capture_default_str();
  app.add_option("NAME", names, "which ones; all when none is named")->check(CLI::IsMember(known));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request); // --help
  } catch (const CLI::ParseError& error) {
    return fail(ErrorKind::usage, error.what());
  }
  return writeMaterials(folder, side, names);
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
