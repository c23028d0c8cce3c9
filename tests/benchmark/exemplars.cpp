// SPDX-License-Identifier: MIT
#include "exemplars.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <materials.h>

namespace lichen::bench {
namespace {

constexpr int kSide = 256;

/// The top left corner, as RGB.
SrgbImage crop(const SrgbImage& image) {
  SrgbImage result(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int c = 0; c < 3; ++c)
        result.pixel(x, y)[c] = image.pixel(x, y)[image.channels < 3 ? 0 : c];
  return result;
}

void appendPhotograph(std::vector<Exemplar>& exemplars, const std::filesystem::path& path,
                      const std::string& name) {
  const Result<ImageFile> file = readImage(path);
  if (!file)
    return;
  const auto* image = std::get_if<SrgbImage>(&file.value().pixels);
  if (image != nullptr && image->width >= kSide && image->height >= kSide)
    exemplars.push_back({name, crop(*image)});
}

} // namespace

std::vector<Exemplar> exemplars256() {
  std::vector<Exemplar> result;
  for (const exemplars::Material& material : exemplars::kMaterials)
    result.push_back({material.name, material.generate(kSide)});
  const std::filesystem::path folder =
      std::filesystem::path(LICHEN_SOURCE_DIR) / "../shared/exemplars";
  std::error_code none;
  std::vector<std::filesystem::path> entries;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  for (const std::filesystem::path& entry : entries) {
    const std::string name = "photograph " + entry.stem().string();
    if (entry.extension() == ".png")
      appendPhotograph(result, entry, name);
    else if (std::filesystem::is_directory(entry, none))
      appendPhotograph(result, entry / "base_color.png", name);
  }
  return result;
}

MapExemplar baseColorMap(const SrgbImage& image) {
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.width = image.width;
  map.height = image.height;
  map.values = image.values;
  return map;
}

Bundle bakedBundle(const SrgbImage& image) {
  const MapExemplar map = baseColorMap(image);
  Result<TilingBake> bake = bakeTiling("benchmark", {&map, 1}, {});
  if (!bake) {
    std::fprintf(stderr, "lichen-bench: %s\n", bake.error().message.c_str());
    std::exit(int(bake.error().kind));
  }
  Bundle bundle;
  bundle.tables = std::move(bake.value().tables);
  bundle.noises = {std::move(bake.value().noise)};
  bundle.materials = {MaterialNoise{}};
  bundle.materialNames = {"benchmark"};
  return bundle;
}

} // namespace lichen::bench
