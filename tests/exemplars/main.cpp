// SPDX-License-Identifier: MIT
// lichen-test-exemplars OUTDIR SIZE NAME...: writes generated photographs as PNG for the gallery's
// sheets. NAME is `photographs` for the sixty of photographs.h, a name of unsuitable.h, the name of
// a structured material such as bond-whole, bond-whole-maps for a folder with its maps, or
// `landscape` for a mesh.
#include "landscape.h"
#include "photographs.h"
#include "structured.h"
#include "unsuitable.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

using namespace lichen;
using namespace lichen::exemplars;

bool isWritten(const Result<void>& written) {
  if (!written)
    std::fprintf(stderr, "lichen-test-exemplars: %s\n", written.error().message.c_str());
  return written.ok();
}

bool write(const std::filesystem::path& path, const SrgbImage& image) {
  std::error_code error; // the write fails if there is no folder
  std::filesystem::create_directories(path.parent_path(), error);
  return isWritten(writeImage(path, image));
}

bool writePhotographs(const std::filesystem::path& folder, int side) {
  return std::ranges::all_of(sixtyPhotographs(), [&](const PhotographPlan& plan) {
    return write(folder / (plan.name() + ".png"),
                 photograph(photographedSurface(plan.material, side), plan).image);
  });
}

bool writeMaps(const std::filesystem::path& folder, const StructuredMaps& maps) {
  return write(folder / "color.png", maps.color) && write(folder / "normal_gl.png", maps.normal) &&
         write(folder / "roughness.png", maps.roughness) &&
         write(folder / "ao.png", maps.occlusion) && write(folder / "height.png", maps.height);
}

bool writeNamed(const std::filesystem::path& folder, int side, const std::string& name) {
  if (name == "photographs")
    return writePhotographs(folder, side);
  if (name == "landscape")
    return isWritten(replaceFile(folder / "landscape.glb", landscapeGlb()));
  for (const Unsuitable& picture : kUnsuitable)
    if (name == picture.name)
      return write(folder / (name + ".png"), picture.generate(side));
  for (const StructuredPlan& plan : structuredPlans()) {
    if (name == plan.name())
      return write(folder / (name + ".png"), structured(side, plan).image);
    if (name == plan.name() + "-maps")
      return writeMaps(folder / name, structuredMaps(side, plan));
  }
  std::fprintf(stderr, "lichen-test-exemplars: %s: no such exemplar\n", name.c_str());
  return false;
}

} // namespace

int main(int argc, char** argv) {
  const int side = argc > 3 ? std::atoi(argv[2]) : 0;
  if (side < 64 || side > 1024) {
    std::fprintf(stderr, "usage: lichen-test-exemplars OUTDIR SIZE NAME...; SIZE is 64 to 1024\n");
    return 2;
  }
  return std::all_of(argv + 3, argv + argc,
                     [&](const char* name) { return writeNamed(argv[1], side, name); })
             ? 0
             : 1;
}
