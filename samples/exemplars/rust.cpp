// SPDX-License-Identifier: MIT
// A neglected painted steel sheet: remains of paint, layers of rust that flake off along angular
// edges, orange powder, dark pits.
//
// Coats are thresholded noise, sampled per cell of a mosaic so that they end at the edges of
// flakes. They raise a height field that is lit from the upper left.
#include "materials.h"
#include "periodic.h"

namespace lichen::exemplars {
namespace {

/// What remains of a coat at a position: covered where above 0, increasing toward the inside.
float coat(const GrainHit& flake, const Field& extent, float x, float y, float threshold) {
  // the rest follows the noise at the position: worn instead of broken
  constexpr float kByFlake = 0.6f;
  return kByFlake * extent.atPixel(flake.grain->x, flake.grain->y) +
         (1.0f - kByFlake) * extent.atPixel(x, y) - threshold;
}

struct Noise {
  Field warpX, warpY;
  Field scaleExtent, paintExtent;
  Field tone, grain, speckle, pits;
};

/// Powdery rust: from dark brown through orange to ochre.
Color powder(float tone) {
  const float t = clamped(0.5f + 0.28f * tone, 0.0f, 1.0f);
  if (t < 0.5f)
    return mix({0.27f, 0.145f, 0.095f}, {0.48f, 0.255f, 0.14f}, 2.0f * t);
  return mix({0.48f, 0.255f, 0.14f}, {0.70f, 0.44f, 0.23f}, 2.0f * t - 1.0f);
}

void paintSample(int sx, int sy, const Mosaic& flakes, const Mosaic& chips, const Noise& noise,
                 Relief& sheet) {
  const float x = pixelOf(sx) + 1.3f * noise.warpX.at(sx, sy);
  const float y = pixelOf(sy) + 1.3f * noise.warpY.at(sx, sy);
  const float grain = noise.grain.at(sx, sy);
  float height = 0.35f * noise.tone.at(sx, sy) + 0.16f * grain;
  Color color = powder(noise.tone.at(sx, sy) + 0.55f * grain);
  if (noise.speckle.at(sx, sy) > 1.5f)
    color = mix(color, {0.82f, 0.55f, 0.28f}, 0.6f);

  const GrainHit flake = flakes.at(x, y);
  Random random(flake.grain->id);
  const float scale = coat(flake, noise.scaleExtent, x, y, 0.15f);
  if (scale > 0.0f) {
    const Color body = mix({0.22f, 0.13f, 0.105f}, {0.36f, 0.20f, 0.135f}, random.unit());
    color = mix(scaled(body, 1.0f + 0.16f * grain), color, 0.22f);
    height += 0.9f * smoothStep(0.0f, 0.12f, scale) + 0.4f * random.unit();
  }
  const GrainHit chip = chips.at(x, y);
  const float paint = coat(chip, noise.paintExtent, x, y, 0.85f);
  if (paint > 0.0f) {
    Random own(chip.grain->id);
    const Color body = mix({0.50f, 0.57f, 0.55f}, {0.66f, 0.70f, 0.66f}, own.unit());
    // Rust stains the paint, starting at its edges.
    const float stain = clamped(0.75f - 1.1f * paint + 0.22f * noise.tone.at(sx, sy), 0.0f, 0.85f);
    color = mix(scaled(body, 1.0f + 0.03f * grain), {0.56f, 0.33f, 0.18f}, stain);
    height += 1.5f * smoothStep(0.0f, 0.15f, paint);
  }
  const float pit = smoothStep(1.35f, 2.3f, noise.pits.at(sx, sy));
  color = mix(color, {0.11f, 0.075f, 0.065f}, 0.85f * pit);
  height -= 1.6f * pit;
  sheet.canvas.at(sx, sy) = color;
  sheet.height.at(sx, sy) = height;
}

} // namespace

SrgbImage rust(int side) {
  const Noise noise{
      fractalNoise(side, {8.0f, 1.0f, 0.65f}, 51),  fractalNoise(side, {8.0f, 1.0f, 0.65f}, 52),
      fractalNoise(side, {56.0f, 3.0f, 0.68f}, 54), fractalNoise(side, {48.0f, 3.0f, 0.7f}, 55),
      fractalNoise(side, {52.0f, 1.0f, 0.76f}, 56), fractalNoise(side, {4.0f, 1.0f, 0.85f}, 57),
      fractalNoise(side, {3.0f, 1.5f, 0.8f}, 58),   fractalNoise(side, {9.0f, 2.0f, 0.55f}, 59)};
  const Mosaic flakes(side, {.spacing = 10.0f, .smallest = 0.5f, .largest = 1.7f, .longest = 2.0f},
                      61);
  const Mosaic chips(side, {.spacing = 7.0f, .smallest = 0.5f, .largest = 1.7f, .longest = 1.8f},
                     62);
  Relief sheet(side);
  for (int y = 0; y < sheet.canvas.side(); ++y)
    for (int x = 0; x < sheet.canvas.side(); ++x)
      paintSample(x, y, flakes, chips, noise, sheet);
  light(sheet, {0.26f, 0.22f});
  return sheet.canvas.resolve();
}

} // namespace lichen::exemplars
