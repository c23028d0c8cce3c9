// SPDX-License-Identifier: MIT
// Local random-phase noise on the CPU: (tables, parameters, footprint) -> value. Steps and names
// follow shaders_glsl/noise/local_random_phase.glsl.
#include "cosine.h"
#include "cosine_vertices.h"
#include "gaussianization/value_decoder.h"
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
using Vec2 = std::array<float, 2>;

bool isSlope(const shader::LichenMap& map) { return map.encoding == LICHEN_ENCODING_SLOPE; }

/// The squared cycles that a footprint spans of a frequency, as a quadratic form.
struct Footprint {
  float xx = 0.0f, yy = 0.0f, xy = 0.0f;

  [[nodiscard]] float squaredCycles(float fx, float fy) const {
    return fx * (xx * fx + xy * fy) + yy * fy * fy;
  }

  /// Of the window at a vertex of an octave, by its mean square frequency.
  [[nodiscard]] float squaredCyclesOfWindow(int octave,
                                            const shader::LichenMaterial& material) const {
    const auto scale = float(std::ldexp(1.0, finerOctaves(octave, material)));
    const float columns = material.columnsPerTile * scale, rows = material.rowsPerTile * scale;
    return kWindowSpread *
           (xx * columns * columns + 0.75f * yy * rows * rows); // rows are sqrt(3) / 2 edges apart
  }
};

/// A squared length [texels^2] -> what is averaged beyond a texel, over which the exemplar has
/// averaged already: 0 up to 1, and soon all of it.
float beyondTexel(float squared) {
  const float own = std::max(squared, 1.0f);
  return own - 1.0f / (own * own * own);
}

/// lichenCosinesFootprint: beyondTexel() of the footprint's ellipse along both of its axes.
Footprint footprintOf(const TileFootprint& at, const shader::LichenNoise& noise) {
  const Vec2 columns{at.dx[0] * noise.tileTexelsX, at.dy[0] * noise.tileTexelsX};
  const Vec2 rows{at.dx[1] * noise.tileTexelsY, at.dy[1] * noise.tileTexelsY};
  const float xx = columns[0] * columns[0] + columns[1] * columns[1];
  const float yy = rows[0] * rows[0] + rows[1] * rows[1];
  const float xy = columns[0] * rows[0] + columns[1] * rows[1];
  const float mean = 0.5f * (xx + yy), half = 0.5f * (xx - yy);
  const float apart = std::sqrt(half * half + xy * xy);
  const float longer = beyondTexel(mean + apart), shorter = beyondTexel(mean - apart);
  constexpr float kLeast = 1e-20f; // of a circle, whose axes are the same
  const float own = 0.5f * (longer + shorter);
  const float slope = 0.5f * (longer - shorter) / std::max(apart, kLeast);
  return {(own + slope * half) / (noise.tileTexelsX * noise.tileTexelsX),
          (own - slope * half) / (noise.tileTexelsY * noise.tileTexelsY),
          2.0f * slope * xy / (noise.tileTexelsX * noise.tileTexelsY)};
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
  const Footprint footprint = footprintOf(at, noise_);
  const CosineCell cell = cosineCellAt(
      material, {at.position[0] + material.offsetX, at.position[1] + material.offsetY});
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
    const float ofWindow = footprint.squaredCyclesOfWindow(int(octave), material);
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

} // namespace lichen
