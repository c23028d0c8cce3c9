// SPDX-License-Identifier: MIT
// Vertices around a point in tile space -> three taps. docs/gltf_extension/README.md specifies each
// step.
#include "simplex_lattice.h"

#include "sampling/lattice_vertices.h"
#include "tile_rotation.h"

#include <lichen/lattice.h>

#include <cmath>

namespace lichen::tiling {
namespace {

/// Sets the position at which a vertex fetches its tile for a point: a whole number of texels away
/// from the point, minus the whole periods that separate the vertex from its representative in a
/// periodic lattice, and rotated.
void setTap(Taps& taps, std::size_t k, const shader::LichenMaterial& material,
            const shader::LichenNoise& noise, const std::array<float, 2>& position,
            const LatticeVertex& vertex) {
  std::array<float, 2>& tap = taps.position[k];
  tap = {position[0] - vertex.period[0], position[1] - vertex.period[1]};
  taps.weight[k] = vertex.weight;
  taps.turn[k] = {1.0f, 0.0f};
  if (rotatesTiles(material)) {
    constexpr std::array<std::array<float, 2>, 4> kTurns{
        {{1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}, {0.0f, -1.0f}}};
    taps.turn[k] = kTurns[tileQuarterTurns(vertex.i, vertex.j, material.seedWord,
                                           tilingPart(material).tileRotation)];
    tap = turned(tap, taps.turn[k]);
  }
  const auto steps = tileOffsetSteps(vertex.i, vertex.j, material.seedWord);
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
  const std::array<LatticeVertex, 3> vertices = latticeVertices(material, position);
  Taps taps;
  for (std::size_t k = 0; k < 3; ++k)
    setTap(taps, k, material, noise, position, vertices[k]);
  sharpen(taps, tilingPart(material).blendSharpness);
  return taps;
}

} // namespace lichen::tiling
