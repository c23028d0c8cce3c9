// SPDX-License-Identifier: MIT
// Local random-phase noise on the CPU: (tables, parameters, footprint) -> value. Steps and names
// follow shaders_glsl/noise/local_random_phase.glsl.
#include "cosine.h"
#include "cosine_gradient.h"
#include "cosine_vertices.h"
#include "gaussianization/value_decoder.h"
#include "solid_cosines.h"
#include "structure_tiles.h"
#include "triplanar/planes.h"

#include <lichen/local_random_phase_evaluate.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace lichen {
namespace {

using namespace local_random_phase;

using Value = LocalRandomPhaseEvaluator::Value;

bool isSlope(const shader::LichenMap& map) { return map.encoding == LICHEN_ENCODING_SLOPE; }

CosineCell cellOf(const TileFootprint& at, const shader::LichenMaterial& material) {
  return cosineCellAt(material,
                      {at.position[0] + material.offsetX, at.position[1] + material.offsetY});
}

} // namespace

struct LocalRandomPhaseEvaluator::Map {
  gaussianization::ValueDecoder decoder;
  std::vector<std::array<CosineTexel, kRowCosines>> texels; ///< of the cosines
  StructureTiles structure;
};

Result<LocalRandomPhaseEvaluator> LocalRandomPhaseEvaluator::create(const Bundle& bundle,
                                                                    std::size_t noiseIndex) {
  const auto exhausted = [&] {
    return "noise " + std::to_string(noiseIndex) + ": not enough memory for its cosines";
  };
  return withinMemory(exhausted, [&]() -> Result<LocalRandomPhaseEvaluator> {
    if (noiseIndex >= bundle.noises.size())
      return Error{ErrorKind::usage, "noise " + std::to_string(noiseIndex) + ": the bundle has " +
                                         std::to_string(bundle.noises.size())};
    const Noise& noise = bundle.noises[noiseIndex];
    if (noise.method() != Method::localRandomPhase)
      return Error{ErrorKind::usage, "noise '" + noise.name + "' has the method " +
                                         std::string(nameOf(noise.method())) +
                                         ", not local-random-phase"};
    const auto& shared = noise.as<LocalRandomPhaseNoise>();
    auto maps = std::make_shared<std::vector<Map>>();
    const CosineImageLayout layout(shared);
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const auto& stored = noise.maps[m].as<LocalRandomPhaseMap>();
      const std::vector<float> image = decodeLevel(bundle.tables[stored.cosines], 0);
      const shader::LichenMap constants = shaderMap(bundle, noise, m);
      maps->push_back({gaussianization::ValueDecoder(bundle, constants, stored.inverseTable),
                       cosineTexels(image, layout),
                       StructureTiles(shared.structure, layout, image, stored, constants)});
    }
    return LocalRandomPhaseEvaluator(shaderNoise(bundle, noiseIndex), shared.cosines,
                                     std::uint32_t(shared.variants), std::move(maps));
  });
}

std::size_t LocalRandomPhaseEvaluator::mapCount() const { return maps_->size(); }

Value LocalRandomPhaseEvaluator::gaussian(std::size_t mapIndex,
                                          const shader::LichenMaterial& material,
                                          const TileFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  const WaveFootprint footprint = waveFootprint(at, noise_);
  const CosineCell cell = cellOf(at, material);
  std::array<float, 3> sum{};
  float squares = 0.0f, lost = 0.0f;
  const auto* row = map.texels.data();
  for (std::size_t octave = 0; octave < cosines_.size(); ++octave) {
    if (cosines_[octave] == 0)
      continue;
    std::array<CosineVertex, 3> vertices =
        verticesAt(cell, int(octave), std::uint32_t(octave), material);
    std::array<std::uint32_t, 3> variants{};
    for (std::size_t v = 0; v < vertices.size(); ++v)
      variants[v] = variantOf(vertices[v].state, variants_);
    const float ofWindow = squaredCyclesOfWindow(footprint, int(octave), material);
    for (int k = 0; k < cosines_[octave]; ++k) {
      const std::size_t own = std::size_t(k) % kRowCosines;
      const CosineTexel& box = row[0][own];
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        CosineVertex& vertex = vertices[v];
        const CosineTexel& amplitude = row[kCosineColumns + variants[v]][own];
        const Draw draw = nextDraw(vertex.state);
        const float fx = box[0] + box[2] * draw.column, fy = box[1] + box[3] * draw.row;
        const float turns =
            fx * vertex.offset[0] + fy * vertex.offset[1] + draw.phase + amplitude[3];
        const float window = vertex.weight * retainedAt(ofWindow + footprint.squaredCycles(fx, fy));
        const float value = window * cosineOfTurns(turns);
        for (std::size_t c = 0; c < 3; ++c) {
          sum[c] += value * amplitude[c];
          const float square = amplitude[c] * amplitude[c];
          squares += vertex.weight * vertex.weight * square;
          lost += (vertex.weight * vertex.weight - window * window) * square;
        }
      }
      if (own + 1 == kRowCosines)
        row += kCosineColumns + variants_;
    }
  }
  const StructureTiles::Value structure = map.structure.at(cell, material, at);
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] += structure.gaussian[c];
  squares += structure.squares;
  lost += structure.lost;
  constexpr float kLeast = 1e-20f; // of a map that does not vary
  const float share = lost / std::max(squares, kLeast);
  return {0.5f + material.contrast * sum[0], 0.5f + material.contrast * sum[1],
          0.5f + material.contrast * sum[2], share};
}

Value LocalRandomPhaseEvaluator::evaluate(std::size_t mapIndex,
                                          const shader::LichenMaterial& material,
                                          const TileFootprint& at) const {
  return (*maps_)[mapIndex].decoder.decode(gaussian(mapIndex, material, at), material.contrast);
}

Value LocalRandomPhaseEvaluator::gaussian(std::size_t mapIndex,
                                          const shader::LichenTriplanarMaterial& material,
                                          const TriplanarFootprint& at) const {
  return triplanar::blendedGaussian(
      triplanar::planesAt(at, material, noise_),
      [&](const auto& plane) { return gaussian(mapIndex, plane.material, plane.at); });
}

Value LocalRandomPhaseEvaluator::evaluate(std::size_t mapIndex,
                                          const shader::LichenTriplanarMaterial& material,
                                          const TriplanarFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  if (isSlope(map.decoder.constants()))
    return triplanar::blendedSlopes(
        triplanar::planesAt(at, material, noise_),
        [&](const auto& plane) { return evaluate(mapIndex, plane.material, plane.at); });
  return map.decoder.decode(gaussian(mapIndex, material, at), material.material.contrast);
}

Value LocalRandomPhaseEvaluator::gaussian(std::size_t mapIndex,
                                          const shader::LichenMaterial& material,
                                          const SolidFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  return solid::gaussianOf(
      solidSumAt(map.texels, cosines_, variants_, noise_, map.decoder.constants(), material, at),
      material);
}

Value LocalRandomPhaseEvaluator::evaluate(std::size_t mapIndex,
                                          const shader::LichenMaterial& material,
                                          const SolidFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  return solid::valueOf(
      solidSumAt(map.texels, cosines_, variants_, noise_, map.decoder.constants(), material, at),
      map.decoder, material);
}

std::array<float, 3> LocalRandomPhaseEvaluator::gradient(std::size_t mapIndex,
                                                         const shader::LichenMaterial& material,
                                                         const TileFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  CosineSlopes slopes = cosineSlopesAt(map.texels, cosines_, variants_, cellOf(at, material),
                                       waveFootprint(at, noise_), material);
  if (const std::array<int, 2> size = map.structure.size(); size[0] > 0) {
    const float x = 0.25f / float(size[0]), y = 0.25f / float(size[1]);
    const auto beside = [&](float dx, float dy) {
      TileFootprint moved = at;
      moved.position[0] += dx;
      moved.position[1] += dy;
      return map.structure.at(cellOf(moved, material), material, moved).gaussian;
    };
    const auto left = beside(-x, 0.0f), right = beside(x, 0.0f);
    const auto above = beside(0.0f, -y), below = beside(0.0f, y);
    for (std::size_t c = 0; c < 3; ++c) {
      slopes.alongX[c] += (right[c] - left[c]) / (2.0f * x);
      slopes.alongY[c] += (below[c] - above[c]) / (2.0f * y);
    }
  }
  const Value here = gaussian(mapIndex, material, at);
  return map.decoder.gradient(here, slopes.alongX, slopes.alongY, material.contrast);
}

} // namespace lichen
