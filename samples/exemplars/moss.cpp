// SPDX-License-Identifier: MIT
// Moss seen from above: thousands of star-shaped shoots at different heights over dark litter.
//
// Each shoot is a rosette of leaflets, painted with a depth buffer. Points below their surroundings
// are darkened.
#include "materials.h"
#include "periodic.h"

#include <cmath>

namespace lichen::exemplars {
namespace {

struct Leaflet {
  float x, y;          ///< base, pixels
  Direction direction; ///< from base to tip
  float length, width; ///< pixels
  float baseHeight, tipHeight;
  Color color;
};

void paintLeaflet(const Leaflet& leaf, Relief& layers) {
  const int side = layers.canvas.side();
  const float reach = leaf.length + leaf.width;
  const int x0 = int(std::floor((leaf.x - reach) * float(kSamplesPerPixel)));
  const int x1 = int(std::floor((leaf.x + reach) * float(kSamplesPerPixel)));
  const int y0 = int(std::floor((leaf.y - reach) * float(kSamplesPerPixel)));
  const int y1 = int(std::floor((leaf.y + reach) * float(kSamplesPerPixel)));
  for (int sy = y0; sy <= y1; ++sy) {
    for (int sx = x0; sx <= x1; ++sx) {
      const float dx = pixelOf(sx) - leaf.x;
      const float dy = pixelOf(sy) - leaf.y;
      const float t = (dx * leaf.direction.x + dy * leaf.direction.y) / leaf.length;
      if (t < 0.0f || t > 1.0f)
        continue;
      // Lanceolate: widest at a third of its length, pointed at the tip.
      const float profile = 2.6f * std::sqrt(t) * (1.0f - t);
      const float across =
          (dy * leaf.direction.x - dx * leaf.direction.y) / (0.5f * leaf.width * profile + 0.01f);
      if (across < -1.0f || across > 1.0f)
        continue;
      const float rib = 1.0f - across * across;
      const float height = leaf.baseHeight + (leaf.tipHeight - leaf.baseHeight) * t + 0.5f * rib;
      float& top = layers.height.at(sx, sy);
      if (height <= top)
        continue;
      top = height;
      // A keeled leaf: the half that faces the light, from the upper left, is lighter.
      const float facing = (leaf.direction.y - leaf.direction.x) * 0.7f * across;
      const float shade = 0.72f + 0.36f * t + 0.16f * facing;
      const int wx = (sx % side + side) % side;
      const int wy = (sy % side + side) % side;
      layers.canvas.at(wx, wy) = scaled(leaf.color, shade);
    }
  }
}

Color shootColor(Random& random) {
  const float kind = random.unit();
  const float t = random.unit();
  if (kind < 0.50f)
    return mix({0.27f, 0.34f, 0.12f}, {0.39f, 0.46f, 0.17f}, t);
  if (kind < 0.78f)
    return mix({0.39f, 0.45f, 0.18f}, {0.53f, 0.56f, 0.27f}, t);
  if (kind < 0.93f)
    return mix({0.18f, 0.25f, 0.11f}, {0.26f, 0.33f, 0.14f}, t);
  return mix({0.40f, 0.31f, 0.17f}, {0.54f, 0.45f, 0.26f}, t); // withered
}

void paintShoot(float x, float y, float height, Random& random, Relief& layers) {
  const Color color = shootColor(random);
  const float radius = random.range(3.0f, 7.5f);
  constexpr int kRings = 4;
  for (int ring = 0; ring < kRings; ++ring) {
    const float inward = float(ring) / float(kRings - 1);
    const int leaves = 12 - 2 * ring;
    for (int leaf = 0; leaf < leaves; ++leaf) {
      const Color tint = mix(color, {0.62f, 0.64f, 0.38f}, 0.22f * inward + 0.12f * random.unit());
      const float length = radius * (1.0f - 0.65f * inward) * random.range(0.7f, 1.2f);
      // Outer leaflets droop, inner ones stand up.
      const float base = height + 2.0f * inward;
      const float tip = base - 2.5f + 3.5f * inward + random.range(-1.2f, 1.2f);
      paintLeaflet({x + random.range(-0.7f, 0.7f), y + random.range(-0.7f, 0.7f),
                    randomDirection(random), length, random.range(0.9f, 1.7f), base, tip,
                    scaled(tint, random.range(0.82f, 1.18f))},
                   layers);
    }
  }
}

void paintLitter(int side, Relief& layers) {
  const Field soil = fractalNoise(side, {12.0f, 1.0f, 0.75f}, 31);
  for (int y = 0; y < layers.canvas.side(); ++y)
    for (int x = 0; x < layers.canvas.side(); ++x)
      layers.canvas.at(x, y) = mix({0.10f, 0.085f, 0.05f}, {0.30f, 0.24f, 0.15f},
                                   clamped(0.4f + 0.3f * soil.at(x, y), 0.0f, 1.0f));
}

/// Darkens points below the mean height of their near and far surroundings.
void shadeByDepth(Relief& layers) {
  const Field near = blurred(layers.height, 2);
  const Field far = blurred(layers.height, 9);
  for (int y = 0; y < layers.canvas.side(); ++y) {
    for (int x = 0; x < layers.canvas.side(); ++x) {
      const float height = layers.height.at(x, y);
      const float crevice = smoothStep(-1.6f, 3.2f, near.at(x, y) - height);
      const float hollow = smoothStep(-4.0f, 6.0f, far.at(x, y) - height);
      layers.canvas.at(x, y) =
          scaled(layers.canvas.at(x, y), 1.5f * (1.0f - 0.62f * crevice) * (1.0f - 0.75f * hollow));
    }
  }
}

} // namespace

SrgbImage moss(int side) {
  Relief layers(side);
  paintLitter(side, layers);
  Random random(41);
  constexpr float kSpacing = 4.6f; // pixels between shoots
  const int perSide = int(float(side) / kSpacing + 0.5f);
  const float cell = float(side) / float(perSide);
  const Field bare = fractalNoise(side, {34.0f, 8.0f, 0.7f}, 42);
  const Field cushions = fractalNoise(side, {22.0f, 10.0f, 0.7f}, 43);
  for (int j = 0; j < perSide; ++j) {
    for (int i = 0; i < perSide; ++i) {
      const float x = (float(i) + random.unit()) * cell;
      const float y = (float(j) + random.unit()) * cell;
      const float height =
          random.range(1.0f, 6.0f) + 2.0f * bare.atPixel(x, y) + 1.8f * cushions.atPixel(x, y);
      if (random.chance(clamped(-0.05f - 0.28f * bare.atPixel(x, y), 0.04f, 0.85f)))
        continue;
      paintShoot(x, y, height, random, layers);
    }
  }
  shadeByDepth(layers);
  return layers.canvas.resolve();
}

} // namespace lichen::exemplars
