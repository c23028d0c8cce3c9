// SPDX-License-Identifier: MIT
// Local random-phase noise on the CPU: (tables, parameters, footprint) -> value. Steps and names
// follow shaders_glsl/noise/local_random_phase.glsl.
#include "cosine.h"
#include "gaussianization/value_decoder.h"
#include "octave_lattice.h"
#include "triplanar/planes.h"

#include <lichen/lattice.h>
#include <lichen/local_random_phase_evaluate.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace lichen {
namespace {

using Value = LocalRandomPhaseEvaluator::Value;
using Vec2 = std::array<float, 2>;

bool isSlope(const shader::LichenMap& map) { return map.encoding == LICHEN_ENCODING_SLOPE; }

/// The octaves from the lattice of the material's first to that of `octave`.
int finerOctaves(int octave, const shader::LichenMaterial& material) {
  return std::max(octave - cosinesPart(material).firstOctave, 0);
}

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
    return local_random_phase::kWindowSpread *
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

/// One vertex of a lattice: the state of its random numbers, its variant of all cosines, the vector
/// from it to the point [tiles], and its window there.
struct Vertex {
  std::uint32_t state = 0, variant = 0;
  Vec2 offset{};
  float weight = 0.0f;
};

/// The cell of octave 0 that holds a point, modulo 2^32, and the place in it.
struct Cell {
  std::int32_t i = 0, j = 0;
  float column = 0.0f, row = 0.0f; ///< in [0, 1)
};

std::int32_t floorDivide(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Vertex (i, j) relative to the cell of the tile origin -> its representative in the period.
std::pair<std::int32_t, std::int32_t> periodicVertex(std::int32_t i, std::int32_t j,
                                                     std::int32_t columns, std::int32_t rows) {
  const std::int32_t rowPeriods = floorDivide(j, rows);
  j -= rowPeriods * rows;
  i += rowPeriods * (rows / 2);
  i -= floorDivide(i, columns) * columns;
  return {i, j};
}

Cell cellAt(const shader::LichenMaterial& material, const Vec2& position) {
  const float row = position[1] * material.rowsPerTile;
  const float column = position[0] * material.columnsPerTile - 0.5f * row;
  const float left = std::floor(column), top = std::floor(row);
  std::int32_t i = std::int32_t(left), j = std::int32_t(top);
  if (material.periodRows > 0)
    std::tie(i, j) = periodicVertex(i, j, material.periodColumns, material.periodRows);
  return {i, j, column - left, row - top};
}

/// The three vertices around a point in the lattice of an octave.
std::array<Vertex, 3> verticesAt(const Cell& cell, int octave, std::uint32_t variants,
                                 const shader::LichenMaterial& material) {
  const int finer = finerOctaves(octave, material);
  const auto scale = float(std::ldexp(1.0, finer));
  const float column = cell.column * scale, row = cell.row * scale;
  const float left = std::floor(column), top = std::floor(row);
  const auto windows = local_random_phase::windowsAt(column - left, row - top);
  const std::uint32_t seed = pcg(material.seedWord + std::uint32_t(octave));
  std::array<Vertex, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint32_t i = (std::uint32_t(cell.i) << finer) + std::uint32_t(left) +
                      std::uint32_t(windows.corner[k][0]);
    std::uint32_t j =
        (std::uint32_t(cell.j) << finer) + std::uint32_t(top) + std::uint32_t(windows.corner[k][1]);
    if (material.periodRows > 0) {
      const auto reduced =
          periodicVertex(std::int32_t(i), std::int32_t(j), material.periodColumns << finer,
                         material.periodRows << finer);
      i = std::uint32_t(reduced.first);
      j = std::uint32_t(reduced.second);
    } else {
      i += std::uint32_t(material.cellI) << finer;
      j += std::uint32_t(material.cellJ) << finer;
    }
    const float a = windows.offset[k][0], b = windows.offset[k][1];
    const std::uint32_t state = vertexHash(i, j, seed);
    vertices[k] = {
        state,
        local_random_phase::variantOf(state, variants),
        {(a + 0.5f * b) / (material.columnsPerTile * scale), b / (material.rowsPerTile * scale)},
        windows.weight[k]};
  }
  return vertices;
}

} // namespace

struct LocalRandomPhaseEvaluator::Map {
  gaussianization::ValueDecoder decoder;
  std::vector<std::array<CosineTexel, kRowCosines>> texels; ///< of the image of cosines
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
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const auto& stored = noise.maps[m].as<LocalRandomPhaseMap>();
      maps->push_back(
          {gaussianization::ValueDecoder(bundle, shaderMap(bundle, noise, m), stored.inverseTable),
           cosineTexels(decodeLevel(bundle.tables[stored.cosines], 0))});
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
  const Cell cell =
      cellAt(material, {at.position[0] + material.offsetX, at.position[1] + material.offsetY});
  std::array<float, 3> sum{};
  float squares = 0.0f, lost = 0.0f;
  const auto* row = map.texels.data();
  for (std::size_t octave = 0; octave < cosines_.size(); ++octave) {
    if (cosines_[octave] == 0)
      continue;
    std::array<Vertex, 3> vertices = verticesAt(cell, int(octave), variants_, material);
    const float ofWindow = footprint.squaredCyclesOfWindow(int(octave), material);
    for (int k = 0; k < cosines_[octave]; ++k) {
      const std::size_t own = std::size_t(k) % kRowCosines;
      const CosineTexel& box = row[0][own];
      for (Vertex& vertex : vertices) {
        const CosineTexel& amplitude = row[kCosineColumns + vertex.variant][own];
        const local_random_phase::Draw draw = local_random_phase::nextDraw(vertex.state);
        const float fx = box[0] + box[2] * draw.column, fy = box[1] + box[3] * draw.row;
        const float turns =
            fx * vertex.offset[0] + fy * vertex.offset[1] + draw.phase + amplitude[3];
        const float window = vertex.weight * local_random_phase::retainedAt(
                                                 ofWindow + footprint.squaredCycles(fx, fy));
        const float value = window * local_random_phase::cosineOfTurns(turns);
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
