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

/// The square of the cycles that the footprint spans of a frequency, q - t^2 / q where a texel
/// spans t: 0 up to a texel, over which the exemplar has averaged already, and soon all of q.
class Footprint {
public:
  Footprint(const TileFootprint& at, const shader::LichenNoise& noise)
      : at_(at), texel_{1.0f / noise.tileTexelsX, 1.0f / noise.tileTexelsY} {}

  [[nodiscard]] float squaredCycles(float fx, float fy) const {
    const float x = fx * at_.dx[0] + fy * at_.dx[1];
    const float y = fx * at_.dy[0] + fy * at_.dy[1];
    const float ownX = fx * texel_[0], ownY = fy * texel_[1];
    constexpr float kLeast = 1e-20f; // of a frequency of 0
    const float cycles = std::max(x * x + y * y, kLeast);
    const float ratio = (ownX * ownX + ownY * ownY) / cycles, square = ratio * ratio;
    return cycles - cycles * square * square;
  }

private:
  TileFootprint at_;
  Vec2 texel_;
};

/// One vertex of a lattice: the state of its random numbers, the vector from it to the point
/// [tiles], and its window there.
struct Vertex {
  std::uint32_t state = 0;
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
std::array<Vertex, 3> verticesAt(const Cell& cell, int octave,
                                 const shader::LichenMaterial& material) {
  const int finer = std::max(octave - cosinesPart(material).firstOctave, 0);
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
    vertices[k] = {
        vertexHash(i, j, seed),
        {(a + 0.5f * b) / (material.columnsPerTile * scale), b / (material.rowsPerTile * scale)},
        windows.weight[k]};
  }
  return vertices;
}

} // namespace

struct LocalRandomPhaseEvaluator::Map {
  gaussianization::ValueDecoder decoder;
  std::vector<Value> texels; ///< of the image of cosines, row by row
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
      const std::vector<float> values = decodeLevel(bundle.tables[stored.cosines], 0);
      Map map{
          gaussianization::ValueDecoder(bundle, shaderMap(bundle, noise, m), stored.inverseTable),
          std::vector<Value>(values.size() / 4)};
      for (std::size_t i = 0; i < map.texels.size(); ++i)
        std::copy_n(&values[4 * i], 4, map.texels[i].begin());
      maps->push_back(std::move(map));
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
  const Footprint footprint(at, noise_);
  const Cell cell =
      cellAt(material, {at.position[0] + material.offsetX, at.position[1] + material.offsetY});
  std::array<float, 3> sum{};
  float lost = 0.0f;
  const Value* row = map.texels.data();
  for (std::size_t octave = 0; octave < cosines_.size(); ++octave) {
    if (cosines_[octave] == 0)
      continue;
    std::array<Vertex, 3> vertices = verticesAt(cell, int(octave), material);
    for (int j = 0; j < cosines_[octave]; ++j, row += kCosineColumns + variants_) {
      for (Vertex& vertex : vertices) {
        const local_random_phase::Draw draw = local_random_phase::nextDraw(vertex.state, variants_);
        const float fx = row[0][0] + row[0][2] * float(draw.column);
        const float fy = row[0][1] + row[0][3] * float(draw.row);
        const Value& amplitude = row[kCosineColumns + draw.variant];
        const float turns =
            fx * vertex.offset[0] + fy * vertex.offset[1] + draw.phase + amplitude[3];
        const float window =
            vertex.weight * local_random_phase::retainedAt(footprint.squaredCycles(fx, fy));
        lost += (vertex.weight * vertex.weight - window * window) *
                (amplitude[0] * amplitude[0] + amplitude[1] * amplitude[1] +
                 amplitude[2] * amplitude[2]);
        const float value = window * local_random_phase::cosineOfTurns(turns);
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += value * amplitude[c];
      }
    }
  }
  const auto dimensions = float(map.decoder.constants().dimensions);
  // Half the square of an amplitude, over the variance 1 / 36 of a Gaussian value.
  const float share = 18.0f * lost / dimensions;
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
