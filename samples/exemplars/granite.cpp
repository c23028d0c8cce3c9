// SPDX-License-Identifier: MIT
// Polished granite: feldspar crystals in a finer mosaic of quartz and feldspar, with clusters of
// biotite flakes.
#include "materials.h"
#include "periodic.h"

namespace lichen::exemplars {
namespace {

/// Noise fields for variation within a grain.
struct Detail {
  Field warpX, warpY, cloud, fine, crack;
};

/// Streaks along the grain: fine noise sampled in the grain's own frame and stretched along it.
float streaks(const GrainHit& hit, float phase, const Detail& detail) {
  constexpr float kAlong = 0.2f;  // five times longer than the noise
  constexpr float kAcross = 1.2f; // slightly thinner
  return detail.fine.atPixel(hit.along * kAlong + phase, hit.across * kAcross + phase);
}

Color potassiumFeldspar(const GrainHit& hit, float x, float y, const Detail& detail) {
  Random random(hit.grain->id);
  const Color body = mix({0.66f, 0.50f, 0.43f}, {0.79f, 0.67f, 0.59f}, random.unit());
  const float brightness = 1.0f + 0.06f * random.range(-1.0f, 1.0f);
  // Perthite (pale lamellae along the grain), clouded by alteration.
  const float lamella = smoothStep(0.2f, 1.6f, streaks(hit, random.range(0.0f, 90.0f), detail));
  const Color perthite = mix(body, {0.86f, 0.78f, 0.72f}, 0.5f * lamella);
  return scaled(perthite, brightness + 0.05f * detail.cloud.atPixel(x, y) +
                              0.045f * detail.fine.atPixel(x, y));
}

Color plagioclase(const GrainHit& hit, float x, float y, const Detail& detail) {
  Random random(hit.grain->id);
  const Color body = mix({0.70f, 0.68f, 0.63f}, {0.85f, 0.83f, 0.79f}, random.unit());
  const float twin = streaks(hit, random.range(0.0f, 90.0f), detail);
  return scaled(body, 1.0f + 0.03f * twin + 0.06f * detail.cloud.atPixel(x, y) +
                          0.04f * detail.fine.atPixel(x, y));
}

Color quartz(const GrainHit& hit, float x, float y, const Detail& detail) {
  Random random(hit.grain->id);
  const Color body = mix({0.36f, 0.35f, 0.34f}, {0.60f, 0.58f, 0.55f}, random.unit());
  // Clear: dark where the view reaches deep, light where a healed crack scatters.
  const float scatter = smoothStep(0.8f, 2.2f, detail.crack.atPixel(x, y));
  return scaled(mix(body, {0.80f, 0.78f, 0.75f}, 0.55f * scatter),
                1.0f + 0.16f * detail.cloud.atPixel(x, y) + 0.04f * detail.fine.atPixel(x, y));
}

Color biotite(const GrainHit& hit, float x, float y, const Detail& detail) {
  Random random(hit.grain->id);
  const float brown = random.unit();
  const Color body = mix({0.09f, 0.085f, 0.085f}, {0.23f, 0.19f, 0.155f}, brown * brown);
  // Cleavage sheets, seen edge-on, catch the light along the flake.
  const float sheet = smoothStep(0.5f, 2.0f, streaks(hit, random.range(0.0f, 90.0f), detail));
  return scaled(mix(body, {0.50f, 0.47f, 0.44f}, 0.55f * sheet),
                1.0f + 0.15f * detail.fine.atPixel(x, y));
}

/// A large, early crystal, or a grain of the mosaic between them.
struct Crystal {
  GrainHit hit;
  Color color;
};

Crystal bulkAt(const Mosaic& large, const Mosaic& small, float x, float y, const Detail& detail) {
  constexpr float kLargeShare = 0.34f; // share of the large mosaic's grains that are crystals
  const GrainHit first = large.at(x, y);
  Random random(first.grain->id ^ 0x51ed270bu);
  const float kind = random.unit();
  if (kind < kLargeShare)
    return {first, kind < 0.7f * kLargeShare ? potassiumFeldspar(first, x, y, detail)
                                             : plagioclase(first, x, y, detail)};
  const GrainHit hit = small.at(x, y);
  Random between(hit.grain->id ^ 0x51ed270bu);
  const float mineral = between.unit();
  constexpr float kQuartz = 0.47f; // share of the finer grains, by number
  constexpr float kPlagioclase = 0.80f;
  if (mineral < kQuartz)
    return {hit, quartz(hit, x, y, detail)};
  return {hit, mineral < kPlagioclase ? plagioclase(hit, x, y, detail)
                                      : potassiumFeldspar(hit, x, y, detail)};
}

} // namespace

SrgbImage granite(int side) {
  const Detail detail{
      fractalNoise(side, {10.0f, 1.2f, 0.65f}, 11), fractalNoise(side, {10.0f, 1.2f, 0.65f}, 12),
      fractalNoise(side, {14.0f, 1.7f, 0.65f}, 13), fractalNoise(side, {3.0f, 1.0f, 0.8f}, 14),
      fractalNoise(side, {7.0f, 1.5f, 0.7f}, 15)};
  const Mosaic large(side, {.spacing = 22.0f, .smallest = 0.6f, .largest = 1.6f, .longest = 1.8f},
                     20);
  const Mosaic small(side, {.spacing = 8.5f, .smallest = 0.5f, .largest = 1.7f, .longest = 1.7f},
                     21);
  const Mosaic flakes(side, {.spacing = 7.0f, .smallest = 0.5f, .largest = 1.8f, .longest = 2.6f},
                      22);
  const Field clusters = fractalNoise(side, {40.0f, 9.0f, 0.8f}, 23);
  Canvas canvas(side);
  for (int sy = 0; sy < canvas.side(); ++sy) {
    for (int sx = 0; sx < canvas.side(); ++sx) {
      constexpr float kRagged = 1.2f; // pixels of boundary displacement
      const float x = pixelOf(sx) + kRagged * detail.warpX.at(sx, sy);
      const float y = pixelOf(sy) + kRagged * detail.warpY.at(sx, sy);
      const Crystal crystal = bulkAt(large, small, x, y, detail);
      // A thin film along the boundaries, stained brown here and there.
      const float film = 1.0f - smoothStep(0.0f, 0.9f, crystal.hit.edge);
      const float stain = clamped(0.25f + 0.25f * detail.crack.at(sx, sy), 0.0f, 0.8f);
      Color color = mix(crystal.color, {0.38f, 0.32f, 0.27f}, film * stain);
      const GrainHit flake = flakes.at(x, y);
      Random random(flake.grain->id ^ 0x9e3779b9u);
      const float gathering = clusters.atPixel(flake.grain->x, flake.grain->y);
      if (random.chance(clamped(0.12f + 0.14f * gathering, 0.02f, 0.6f)))
        color = biotite(flake, x, y, detail);
      canvas.at(sx, sy) = color;
    }
  }
  return canvas.resolve();
}

} // namespace lichen::exemplars
