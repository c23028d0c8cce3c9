// SPDX-License-Identifier: MIT
// A tiling noise and its exemplar -> risks and measures.
#include "../method_report.h"

#include <lichen/shader_parameters.h>

#include <algorithm>

namespace lichen {
namespace {

/// Options of the result that is searched for the lattice. A result of large exemplars evaluates
/// only some texels, but with their full-resolution footprint. A coarser footprint would give a
/// different noise, whose averaged texels are less Gaussian: its contrast follows the lattice three
/// times as much.
SynthesisOptions latticeOptions(SynthesisOptions options, const Extents& exemplar) {
  const int width = kLatticeExemplars * exemplar[0];
  const int height = kLatticeExemplars * exemplar[1];
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
  return {lattice, stride / exemplar[0], stride / exemplar[1], firstTexel / exemplar[0],
          firstTexel / exemplar[1]};
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

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress& progress) {
  const MapExemplar& map = assessed.map();
  return assessSuitability(map, assessed.bordersFit, progress,
                           firstPixelsOf(map, assessed.maps.front()),
                           assessed.noise.as<TilingNoise>().grain);
}

Result<void> measure(const ComparedResult&, NoiseComparison& comparison) {
  return take(measureResult(comparison.exemplar, comparison.result), comparison);
}

Result<void> judge(const ComparedResult& result, NoiseComparison& comparison) {
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

} // namespace

/// latticeMeasure() synthesizes 16 x 16 exemplars, after a result of 4 x 4.
extern const MethodReport kTilingReport{
    .assess = assess, .measure = measure, .judge = judge, .judgedShare = 0.9};

} // namespace lichen
