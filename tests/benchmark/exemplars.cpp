// SPDX-License-Identifier: MIT
#include "exemplars.h"

#include "checkout_paths.h"
#include "synthesized.h"

#include <lichen/image_io.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>
#include <lichen/texton.h>

#include <algorithm>
#include <filesystem>
#include <materials.h>

namespace lichen::bench {
namespace {

constexpr int kSide = 256;
/// Slope for a height step of 1 between pixels: a relief of a few pixels.
constexpr float kRelief = 4.0f;

MapExemplar mapOf(MapTarget target, std::vector<MapChannel> channels, ValueEncoding encoding,
                  const SrgbImage& sizes) {
  MapExemplar map;
  map.target = target;
  map.channels = std::move(channels);
  map.encoding = encoding;
  map.width = sizes.width;
  map.height = sizes.height;
  return map;
}

/// Crops the top left corner, as RGB.
SrgbImage crop(const SrgbImage& image) {
  SrgbImage result(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int c = 0; c < 3; ++c)
        result.pixel(x, y)[c] = image.pixel(x, y)[image.channels < 3 ? 0 : c];
  return result;
}

/// The contents of ../shared/exemplars, if that folder exists.
std::vector<std::filesystem::path> photographs() {
  const std::filesystem::path folder = sourcePath("../shared/exemplars");
  std::error_code none;
  std::vector<std::filesystem::path> entries;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
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
  std::error_code none;
  for (const std::filesystem::path& entry : photographs()) {
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

std::vector<MapExemplar> materialSet(int sidePixels) {
  const SrgbImage color = exemplars::rust(sidePixels);
  MapExemplar height = mapOf(MapTarget::height, {MapChannel::height}, ValueEncoding::linear, color);
  MapExemplar normal = mapOf(MapTarget::normal, {MapChannel::slopeX, MapChannel::slopeY},
                             ValueEncoding::slope, color);
  MapExemplar orm = mapOf(MapTarget::occlusionRoughnessMetallic,
                          {MapChannel::occlusion, MapChannel::roughness, MapChannel::metallic},
                          ValueEncoding::linear, color);
  for (int y = 0; y < sidePixels; ++y)
    for (int x = 0; x < sidePixels; ++x) {
      const auto at = [&](int column, int row) {
        return color.pixel(column % sidePixels, row % sidePixels);
      };
      const float here = at(x, y)[1];
      height.values.push_back(here);
      normal.values.insert(normal.values.end(), {kRelief * (at(x + 1, y)[1] - here),
                                                 kRelief * (here - at(x, y + 1)[1])});
      orm.values.insert(orm.values.end(), {here, at(x, y)[2], at(x, y)[0]});
    }
  return {baseColorMap(color), normal, orm, height};
}

std::vector<MaterialSet> photographedSets() {
  std::vector<MaterialSet> sets;
  std::error_code none;
  for (const std::filesystem::path& entry : photographs())
    if (std::filesystem::is_directory(entry, none))
      if (Result<MaterialSet> set = readMaterialSet({&entry, 1}, {}); set)
        sets.push_back(std::move(set).value());
  return sets;
}

Bundle bundleOf(Result<MethodBake> bake) {
  MethodBake baked = require(std::move(bake));
  Bundle bundle;
  bundle.noises.push_back(std::move(baked.noise));
  bundle.tables = std::move(baked.tables);
  bundle.materials = {MaterialNoise{}};
  bundle.materialNames = {"benchmark"};
  return bundle;
}

Bundle bakedBundle(const SrgbImage& image, const TilingOptions& options) {
  const MapExemplar map = baseColorMap(image);
  return bakedBundle({&map, 1}, options);
}

Bundle textonBundle(const SrgbImage& image) {
  const MapExemplar map = baseColorMap(image);
  return bundleOf(bakeTexton("benchmark", {&map, 1}, {}));
}

Bundle localRandomPhaseBundle(const SrgbImage& image, const LocalRandomPhaseOptions& options) {
  const MapExemplar map = baseColorMap(image);
  return bundleOf(bakeLocalRandomPhase("benchmark", {&map, 1}, options));
}

Bundle multipleKernelsBundle(const SrgbImage& image) {
  const MapExemplar map = baseColorMap(image);
  return bundleOf(bakeMultipleKernels("benchmark", {&map, 1}, {}));
}

Bundle quiltingBundle(const SrgbImage& image) {
  const MapExemplar map = baseColorMap(image);
  return bundleOf(bakeQuilting("benchmark", {&map, 1}, {}));
}

Bundle bakedBundle(std::span<const MapExemplar> maps, const TilingOptions& options) {
  return bundleOf(bakeTiling("benchmark", maps, options));
}

} // namespace lichen::bench
