// SPDX-License-Identifier: MIT
// Lichen on stone: crusts of three species on weathered rock, with lobed margins, cracks and
// fruiting bodies.
#include "materials.h"
#include "periodic.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::exemplars {
namespace {

struct Noise {
  Field warpX, warpY, lobe, rock, fine, speckle, tone;
};

struct Species {
  Color margin, inside, fruit;
};

constexpr std::array<Species, 3> kSpecies{{
    {{0.73f, 0.76f, 0.66f}, {0.55f, 0.60f, 0.50f}, {0.25f, 0.22f, 0.18f}}, // grey-green shield
    {{0.83f, 0.80f, 0.52f}, {0.68f, 0.66f, 0.33f}, {0.20f, 0.20f, 0.13f}}, // yellow map
    {{0.82f, 0.57f, 0.25f}, {0.71f, 0.44f, 0.18f}, {0.62f, 0.30f, 0.10f}}, // orange firedot
}};

/// Bare rock with mineral grains.
void paintRock(int sx, int sy, const Mosaic& grains, const Noise& noise, Relief& surface) {
  const GrainHit grain = grains.at(pixelOf(sx) + 0.6f * noise.warpX.at(sx, sy),
                                   pixelOf(sy) + 0.6f * noise.warpY.at(sx, sy));
  Random random(grain.grain->id);
  const float tone = 0.32f + 0.16f * random.unit() + 0.045f * noise.rock.at(sx, sy) +
                     0.025f * noise.fine.at(sx, sy);
  Color color = {tone * 1.03f, tone, tone * 0.95f};
  if (noise.speckle.at(sx, sy) > 1.7f)
    color = scaled(color, 0.55f);
  surface.canvas.at(sx, sy) = color;
  surface.height.at(sx, sy) = 0.5f * noise.rock.at(sx, sy) + 0.2f * noise.fine.at(sx, sy);
}

void paintCrust(int sx, int sy, const Mosaic& thalli, const Mosaic& areoles, const Noise& noise,
                float share, Relief& surface) {
  const float x = pixelOf(sx);
  const float y = pixelOf(sy);
  const GrainHit thallus =
      thalli.at(x + 3.0f * noise.warpX.at(sx, sy), y + 3.0f * noise.warpY.at(sx, sy));
  Random random(thallus.grain->id);
  if (!random.chance(share))
    return;
  const float kind = random.unit();
  const Species& species = kSpecies[kind < 0.5f ? 0 : (kind < 0.82f ? 1 : 2)];
  const float brightness = random.range(0.9f, 1.08f);
  const float radius = random.range(6.0f, 15.0f);
  const float fruiting = random.range(1.0f, 2.2f);
  const float fromCentre =
      std::sqrt(thallus.along * thallus.along + thallus.across * thallus.across);
  const float inside =
      std::min(radius - fromCentre + 1.7f * noise.lobe.at(sx, sy), thallus.edge - 0.3f);
  if (inside <= 0.0f)
    return;
  const GrainHit areole =
      areoles.at(x + 0.5f * noise.warpX.at(sx, sy), y + 0.5f * noise.warpY.at(sx, sy));
  Random own(areole.grain->id);
  const float crack = 1.0f - smoothStep(0.0f, 0.55f, areole.edge);
  Color color = mix(species.margin, species.inside, smoothStep(0.5f, 6.5f, inside));
  color = scaled(color, brightness * (own.range(0.88f, 1.08f) + 0.05f * noise.tone.at(sx, sy)) +
                            0.035f * noise.fine.at(sx, sy));
  float height = 1.1f * smoothStep(0.0f, 1.5f, inside) + 0.5f * smoothStep(0.0f, 1.2f, areole.edge);
  const bool fruit =
      inside > 2.5f && areole.edge > 0.25f && own.chance(0.22f * (fruiting - 1.0f) + 0.04f);
  if (fruit) {
    color = mix(species.fruit, color, 0.15f);
    height += 0.5f;
  } else {
    color = mix(color, {0.16f, 0.15f, 0.12f}, 0.55f * crack * smoothStep(1.0f, 4.0f, inside));
  }
  surface.canvas.at(sx, sy) = mix(surface.canvas.at(sx, sy), color, smoothStep(0.0f, 0.7f, inside));
  surface.height.at(sx, sy) = 0.4f * surface.height.at(sx, sy) + height;
}

} // namespace

SrgbImage lichenOnStone(int side) {
  const Noise noise{
      fractalNoise(side, {9.0f, 1.5f, 0.6f}, 91), fractalNoise(side, {9.0f, 1.5f, 0.6f}, 92),
      fractalNoise(side, {7.0f, 1.5f, 0.7f}, 93), fractalNoise(side, {40.0f, 1.0f, 0.8f}, 94),
      fractalNoise(side, {2.5f, 1.0f, 0.8f}, 95), fractalNoise(side, {3.0f, 1.5f, 0.8f}, 96),
      fractalNoise(side, {12.0f, 3.0f, 0.6f}, 97)};
  const Mosaic grains(side, {.spacing = 3.2f, .smallest = 0.6f, .largest = 1.6f, .longest = 1.5f},
                      98);
  const Mosaic thalli(side, {.spacing = 22.0f, .smallest = 0.7f, .largest = 1.5f, .longest = 1.3f},
                      99);
  const Mosaic young(side, {.spacing = 11.0f, .smallest = 0.7f, .largest = 1.5f, .longest = 1.3f},
                     101);
  const Mosaic areoles(
      side,
      {.spacing = 2.9f, .smallest = 0.8f, .largest = 1.3f, .longest = 1.4f, .irregularity = 0.9f},
      102);
  Relief surface(side);
  for (int y = 0; y < surface.canvas.side(); ++y) {
    for (int x = 0; x < surface.canvas.side(); ++x) {
      paintRock(x, y, grains, noise, surface);
      paintCrust(x, y, young, areoles, noise, 0.16f, surface);
      paintCrust(x, y, thalli, areoles, noise, 0.6f, surface);
    }
  }
  light(surface, {0.20f, 0.20f});
  return surface.canvas.resolve();
}

} // namespace lichen::exemplars
