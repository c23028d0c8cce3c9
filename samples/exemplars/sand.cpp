// SPDX-License-Identifier: MIT
// Coarse beach sand: rounded grains of quartz, feldspar, shell and dark minerals in three sizes;
// larger grains lie on top of finer ones.
#include "materials.h"
#include "periodic.h"

#include <array>
#include <cstdint>

namespace lichen::exemplars {
namespace {

Color grainColor(Random& random) {
  struct Kind {
    float share; ///< cumulative
    Color dark, light;
  };
  constexpr std::array<Kind, 6> kKinds{{
      {0.38f, {0.58f, 0.49f, 0.36f}, {0.78f, 0.69f, 0.55f}}, // stained quartz
      {0.60f, {0.66f, 0.62f, 0.54f}, {0.86f, 0.83f, 0.76f}}, // clear quartz
      {0.74f, {0.55f, 0.36f, 0.23f}, {0.72f, 0.52f, 0.37f}}, // feldspar, iron-stained
      {0.86f, {0.30f, 0.25f, 0.21f}, {0.48f, 0.41f, 0.34f}}, // rock
      {0.95f, {0.11f, 0.10f, 0.10f}, {0.24f, 0.22f, 0.21f}}, // magnetite, hornblende
      {1.00f, {0.88f, 0.84f, 0.77f}, {0.97f, 0.95f, 0.90f}}, // shell
  }};
  const float kind = random.unit();
  std::size_t k = 0;
  while (kind >= kKinds[k].share)
    ++k;
  return mix(kKinds[k].dark, kKinds[k].light, random.unit());
}

} // namespace

SrgbImage sand(int side) {
  const Field warpX = fractalNoise(side, {5.0f, 1.5f, 0.6f}, 111);
  const Field warpY = fractalNoise(side, {5.0f, 1.5f, 0.6f}, 112);
  const Field fine = fractalNoise(side, {2.5f, 1.0f, 0.8f}, 113);
  struct GrainSize {
    Mosaic mosaic;
    float share; ///< share of the mosaic's cells with a grain
  };
  const auto grains = [side](float spacing, std::uint32_t seed) {
    return Mosaic(side,
                  {.spacing = spacing,
                   .smallest = 0.7f,
                   .largest = 1.4f,
                   .longest = 1.6f,
                   .irregularity = 0.9f},
                  seed);
  };
  const std::array<GrainSize, 3> sizes{
      {{grains(9.0f, 121), 0.16f}, {grains(5.6f, 122), 0.40f}, {grains(3.4f, 123), 1.0f}}};
  Relief sheet(side);
  for (int sy = 0; sy < sheet.canvas.side(); ++sy) {
    for (int sx = 0; sx < sheet.canvas.side(); ++sx) {
      const float x = pixelOf(sx) + 0.45f * warpX.at(sx, sy);
      const float y = pixelOf(sy) + 0.45f * warpY.at(sx, sy);
      for (std::size_t layer = 0; layer < sizes.size(); ++layer) {
        const GrainHit grain = sizes[layer].mosaic.at(x, y);
        Random random(grain.grain->id);
        constexpr float kRim = 0.45f; // pixels between a grain and the border of its cell
        if (!random.chance(sizes[layer].share) || (layer + 1 < sizes.size() && grain.edge < kRim))
          continue;
        const Color body = grainColor(random);
        const float dome = smoothStep(0.0f, 2.2f, grain.edge);
        sheet.canvas.at(sx, sy) = scaled(body, 0.62f + 0.40f * dome + 0.05f * fine.at(sx, sy));
        sheet.height.at(sx, sy) = 1.3f * dome + 1.2f * float(sizes.size() - layer) + random.unit();
        break;
      }
    }
  }
  light(sheet, {0.16f, 0.20f});
  return sheet.canvas.resolve();
}

} // namespace lichen::exemplars
