// SPDX-License-Identifier: MIT
// Point in tile space -> three taps. docs/gltf_extension/README.md specifies each step.
#include "simplex_lattice.h"

#include "tile_rotation.h"

#include <lichen/lattice.h>

#include <cmath>

namespace lichen::tiling {
namespace {

std::int32_t wrappingSum(std::int32_t a, std::int32_t b) {
  return std::int32_t(std::uint32_t(a) + std::uint32_t(b));
}

std::int32_t floorDivide(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Sets the position at which vertex (i, j) fetches its tile for a point: a whole number of texels
/// away from the point, minus the whole periods that separate the vertex from its representative in
/// a periodic lattice, and rotated. `way` is the offset from the vertex to the point [tiles].
void setTap(Taps& taps, std::size_t k, const shader::LichenMaterial& material,
            const shader::LichenNoise& noise, const std::array<float, 2>& position,
            const std::array<float, 2>& way, std::int32_t i, std::int32_t j) {
  std::array<float, 2>& tap = taps.position[k];
  tap = position;
  if (material.periodRows > 0) {
    const std::int32_t rowPeriods = floorDivide(j, material.periodRows);
    j -= rowPeriods * material.periodRows;
    i += rowPeriods * (material.periodRows / 2);
    const std::int32_t columnPeriods = floorDivide(i, material.periodColumns);
    i -= columnPeriods * material.periodColumns;
    tap[0] -= float(columnPeriods) * material.periodTilesX;
    tap[1] -= float(rowPeriods) * material.periodTilesY;
  }
  taps.turn[k] = {1.0f, 0.0f};
  if (const std::uint32_t rotation = tilingPart(material).tileRotation; rotation > 1) {
    taps.turn[k] = tileRotationAt(
        tileRotationStep(std::uint32_t(i), std::uint32_t(j), material.seedWord, rotation),
        rotation);
    tap = turned(rotationsKeepTexels(rotation, noise.tileAspect) ? tap : way, taps.turn[k],
                 noise.tileAspect);
  }
  const auto steps = tileOffsetSteps(std::uint32_t(i), std::uint32_t(j), material.seedWord);
  tap[0] += float(steps[0]) * noise.offsetStepX;
  tap[1] += float(steps[1]) * noise.offsetStepY;
}

void sharpen(Taps& taps, float exponent) {
  float sum = 0.0f;
  for (float& weight : taps.weight) {
    weight = exponent == 1.0f ? weight : std::pow(weight, exponent);
    sum += weight;
  }
  float squares = 0.0f;
  for (float& weight : taps.weight) {
    weight /= sum;
    squares += weight * weight;
  }
  taps.norm = std::sqrt(squares);
}

} // namespace

Taps tapsAt(const shader::LichenMaterial& material, const shader::LichenNoise& noise,
            const std::array<float, 2>& position) {
  const float b = position[1] * material.rowsPerTile;
  const float a = position[0] * material.columnsPerTile - 0.5f * b;
  const float floorA = std::floor(a);
  const float floorB = std::floor(b);
  const std::int32_t i = wrappingSum(std::int32_t(floorA), material.cellI);
  const std::int32_t j = wrappingSum(std::int32_t(floorB), material.cellJ);
  const float f = a - floorA;
  const float g = b - floorB;

  Taps taps;
  const bool lower = f + g < 1.0f;
  const std::int32_t corner = lower ? 0 : 1;
  taps.weight = lower ? std::array<float, 3>{1.0f - f - g, f, g}
                      : std::array<float, 3>{f + g - 1.0f, 1.0f - g, 1.0f - f};
  const std::array<std::array<std::int32_t, 2>, 3> corners{{{corner, corner}, {1, 0}, {0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const float column = f - float(corners[k][0]);
    const float row = g - float(corners[k][1]);
    setTap(taps, k, material, noise, position,
           {(column + 0.5f * row) / material.columnsPerTile, row / material.rowsPerTile},
           wrappingSum(i, corners[k][0]), wrappingSum(j, corners[k][1]));
  }
  sharpen(taps, tilingPart(material).blendSharpness);
  return taps;
}

} // namespace lichen::tiling
