// SPDX-License-Identifier: MIT
// Terrazzo: chips of marble of three sizes in polished cement.
#include "materials.h"
#include "periodic.h"

#include <array>
#include <cstdint>

namespace lichen::exemplars {
namespace {

struct Noise {
  Field warpX, warpY, vein, cloud, fine;
};

Color chipColor(const GrainHit& chip, float x, float y, const Noise& noise) {
  struct Marble {
    float share; ///< cumulative
    Color dark, light;
  };
  constexpr std::array<Marble, 5> kMarbles{{
      {0.34f, {0.80f, 0.77f, 0.71f}, {0.93f, 0.91f, 0.87f}},  // white
      {0.56f, {0.66f, 0.56f, 0.43f}, {0.81f, 0.72f, 0.59f}},  // botticino
      {0.74f, {0.47f, 0.22f, 0.15f}, {0.63f, 0.36f, 0.26f}},  // verona red
      {0.88f, {0.19f, 0.20f, 0.205f}, {0.31f, 0.32f, 0.32f}}, // black
      {1.00f, {0.27f, 0.35f, 0.30f}, {0.42f, 0.50f, 0.43f}},  // alpine green
  }};
  Random random(chip.grain->id);
  const float kind = random.unit();
  std::size_t marble = 0;
  while (kind >= kMarbles[marble].share)
    ++marble;
  const Color body = mix(kMarbles[marble].dark, kMarbles[marble].light, random.unit());
  const float shift = random.range(0.0f, 300.0f);
  // Veins lie where a smooth noise, sampled in the chip's own frame, crosses zero.
  const float v = noise.vein.atPixel(chip.along + shift, chip.across + shift);
  const float vein = 1.0f - smoothStep(0.0f, 0.16f, v < 0.0f ? -v : v);
  const Color veined =
      mix(body, kind < kMarbles[1].share ? Color{0.55f, 0.50f, 0.44f} : Color{0.80f, 0.77f, 0.72f},
          0.38f * vein);
  return scaled(veined,
                1.0f + 0.05f * noise.cloud.atPixel(x, y) + 0.022f * noise.fine.atPixel(x, y));
}

} // namespace

SrgbImage terrazzo(int side) {
  const Noise noise{
      fractalNoise(side, {9.0f, 2.0f, 0.5f}, 71), fractalNoise(side, {9.0f, 2.0f, 0.5f}, 72),
      fractalNoise(side, {14.0f, 2.0f, 0.55f}, 73), fractalNoise(side, {10.0f, 1.5f, 0.7f}, 74),
      fractalNoise(side, {2.5f, 1.0f, 0.8f}, 75)};
  struct ChipSize {
    Mosaic mosaic;
    float share; ///< share of the grains that are chips
    float gap;   ///< half the width of the cement between neighbours, pixels
  };
  const auto chips = [side](float spacing, std::uint32_t seed) {
    return Mosaic(side,
                  {.spacing = spacing,
                   .smallest = 0.95f,
                   .largest = 1.05f,
                   .longest = 1.4f,
                   .irregularity = 0.93f},
                  seed);
  };
  const std::array<ChipSize, 3> sizes{{{chips(23.0f, 81), 0.44f, 1.5f},
                                       {chips(11.5f, 82), 0.62f, 0.9f},
                                       {chips(5.5f, 83), 0.5f, 0.55f}}};
  Canvas canvas(side);
  for (int sy = 0; sy < canvas.side(); ++sy) {
    for (int sx = 0; sx < canvas.side(); ++sx) {
      const float x = pixelOf(sx) + 0.5f * noise.warpX.at(sx, sy);
      const float y = pixelOf(sy) + 0.5f * noise.warpY.at(sx, sy);
      Color color = scaled({0.69f, 0.675f, 0.645f},
                           1.0f + 0.045f * noise.cloud.at(sx, sy) + 0.04f * noise.fine.at(sx, sy));
      for (const ChipSize& size : sizes) {
        const GrainHit chip = size.mosaic.at(x, y);
        Random random(chip.grain->id ^ 0x51ed270bu);
        if (!random.chance(size.share))
          continue;
        const float inside = smoothStep(size.gap - 0.3f, size.gap + 0.3f, chip.edge);
        color = mix(scaled(color, 0.96f), chipColor(chip, x, y, noise), inside);
        break;
      }
      canvas.at(sx, sy) = color;
    }
  }
  return canvas.resolve();
}

} // namespace lichen::exemplars
