// SPDX-License-Identifier: MIT
// A tiling noise and its exemplar -> measures, and pictures of the Gaussian image and the table.
#include "tiling_report.h"

#include "../inverse_table_pictures.h"

#include <lichen/shader_parameters.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// The exemplar's size in texels.
struct Extents {
  int width = 0;
  int height = 0;
};

/// Options of the result that is searched for the lattice. A result of large exemplars evaluates
/// only some texels, but with their full-resolution footprint. A coarser footprint would give a
/// different noise, whose averaged texels are less Gaussian: its contrast follows the lattice three
/// times as much.
SynthesisOptions latticeOptions(SynthesisOptions options, const Extents& exemplar) {
  const int width = kLatticeExemplars * exemplar.width;
  const int height = kLatticeExemplars * exemplar.height;
  options.stride = (std::max(width, height) + kLargestResultSide - 1) / kLargestResultSide;
  options.width = std::max(1, width / options.stride);
  options.height = std::max(1, height / options.stride);
  return options;
}

/// The lattice of a result of this material, without a period.
Lattice latticeOf(const Bundle& bundle, MaterialNoise material) {
  material.mapping = Mapping::uv; // as synthesize() has it
  const shader::LichenMaterial constants = shaderMaterial(bundle, material, {}).material;
  Lattice lattice;
  lattice.columnsPerTile = double(constants.columnsPerTile);
  lattice.rowsPerTile = double(constants.rowsPerTile);
  return lattice;
}

LatticeView latticeView(const Lattice& lattice, const SynthesisOptions& options,
                        const Extents& exemplar) {
  const double stride = options.stride;
  const double firstTexel = 0.5 - 0.5 * stride; // a view's pixel centres are at half-integers
  return {lattice, stride / exemplar.width, stride / exemplar.height, firstTexel / exemplar.width,
          firstTexel / exemplar.height};
}

/// Returns the pixels of `first` per pixel of `map`, along the longer side of `map`.
double firstPixelsOf(const MapExemplar& map, const MapExemplar& first) {
  return map.width >= map.height ? double(first.width) / map.width
                                 : double(first.height) / map.height;
}

/// How visible the lattice of the noise's tiles is.
Result<Measure> latticeMeasure(const Bundle& bundle, const SynthesisOptions& wide,
                               const Extents& exemplar, const MapLook& look) {
  const Result<LinearImage> result = synthesize(bundle, wide);
  if (!result)
    return result.error();
  return measureLattice(look.picture(result.value()),
                        latticeView(latticeOf(bundle, wide.material), wide, exemplar));
}

/// The finest mip level of the Gaussian image with at most side^2 pixels.
Result<Json> gaussianPicture(const Table& table, int dimensions, int side) {
  const auto shift = [&](std::uint32_t extent, std::uint32_t level) {
    return std::max(1u, extent >> level);
  };
  std::uint32_t level = 0;
  while (level + 1 < table.mipLevels &&
         double(shift(table.width, level)) * shift(table.height, level) > double(side) * side)
    ++level;
  const std::vector<float> texels = decodeLevel(table, level);
  const auto stored = std::size_t(channelCount(table.format));
  const auto colours = std::size_t(dimensions);
  LinearImage image(int(shift(table.width, level)), int(shift(table.height, level)), int(colours));
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    std::copy_n(&texels[i * stored], colours, &image.values[i * colours]);
  return pictureJson(twoAsRedGreen(std::move(image)));
}

} // namespace

double TilingReport::judgedPixels(int exemplarWidth, int exemplarHeight) const {
  const SynthesisOptions wide = latticeOptions({}, {exemplarWidth, exemplarHeight});
  return double(wide.width) * double(wide.height);
}

Result<std::vector<Risk>> TilingReport::assess(const AssessedMap& assessed,
                                               const Progress& progress) const {
  const MapExemplar& map = assessed.map();
  return assessSuitability(map, assessed.bordersFit, progress,
                           firstPixelsOf(map, assessed.maps.front()),
                           assessed.noise.as<TilingNoise>().grain);
}

Result<void> TilingReport::measure(const ComparedResult&, NoiseComparison& comparison) const {
  Result<std::vector<Measure>> measures = measureResult(comparison.exemplar, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  return {};
}

Result<void> TilingReport::judge(const ComparedResult& result, NoiseComparison& comparison) const {
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  const auto [width, height] = exemplarSize(result.bundle, noise, result.map);
  const Extents baked{int(width), int(height)};
  SynthesisOptions wide = latticeOptions(result.options, baked);
  wide.progress = result.progress;
  Result<Measure> lattice = latticeMeasure(result.bundle, wide, baked, comparison.look);
  if (!lattice)
    return lattice.error();
  comparison.measures.push_back(std::move(lattice).value());
  return {};
}

/// The pictures: the exemplar, the exemplar before flattening, a result of 2 x 2 exemplars, and the
/// Gaussian image.
double TilingReport::picturePixels() const { return 7.0; }

Result<Json> TilingReport::image(const Bundle& bundle, const Noise&, const NoiseMap& map, double,
                                 int side) const {
  Result<Json> shown = gaussianPicture(bundle.tables[map.as<TilingMap>().gaussian],
                                       map.as<TilingMap>().dimensions, side);
  if (!shown)
    return shown;
  shown.value()["title"] = "Gaussianized exemplar";
  shown.value()["text"] =
      "The exemplar with its values replaced by Gaussian ones, which blend without "
      "changing their distribution.";
  return shown;
}

Result<Json> TilingReport::table(const Bundle& bundle, const NoiseMap& map,
                                 const MapLook& look) const {
  return inverseTablePictures(bundle, map, look);
}

} // namespace lichen
