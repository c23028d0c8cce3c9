// SPDX-License-Identifier: MIT
// Fields of noise, stretched and coloured -> surfaces with little contrast.
#include "surfaces.h"

#include "periodic.h"

namespace lichen::exemplars {
SrgbImage plaster(int side) {
  const Field grain = fractalNoise(side, {24.0f, 2.0f, 0.75f}, 201);
  const Field trowel = fractalNoise(side, {40.0f, 8.0f, 0.6f}, 202);
  return painted(side, [&](int sx, int sy) {
    const float stroke = trowel.at(sx, sy / 2);
    return scaled({0.78f, 0.75f, 0.69f}, 1.0f + 0.022f * grain.at(sx, sy) + 0.008f * stroke);
  });
}

SrgbImage cloth(int side) {
  const Field fibres = fractalNoise(side, {10.0f, 1.5f, 0.8f}, 211);
  const Field crossed = fractalNoise(side, {10.0f, 1.5f, 0.8f}, 212);
  const Field dye = fractalNoise(side, {20.0f, 2.0f, 0.7f}, 213);
  return painted(side, [&](int sx, int sy) {
    // Short fibres along both directions of the fabric.
    const float hair = fibres.at(sx, sy / 4) + crossed.at(sx / 4, sy);
    const Color blue{0.17f, 0.19f, 0.25f + 0.01f * dye.at(sx, sy)};
    return scaled(blue, 1.0f + 0.12f * hair + 0.05f * dye.at(sy, sx));
  });
}

SrgbImage woodGrain(int side) {
  const Field bands = fractalNoise(side, {60.0f, 4.0f, 0.7f}, 221);
  const Field fine = fractalNoise(side, {8.0f, 1.0f, 0.9f}, 222);
  const Field pores = fractalNoise(side, {6.0f, 2.0f, 0.8f}, 223);
  return painted(side, [&](int sx, int sy) {
    constexpr int kStretch = 16; // along y
    const float band = bands.at(sx, sy / kStretch), grain = fine.at(sx, sy / kStretch);
    const float pore = smoothStep(1.5f, 2.2f, pores.at(sx, sy / kStretch + sx / 64));
    const Color wood =
        mix({0.46f, 0.31f, 0.19f}, {0.68f, 0.52f, 0.35f}, smoothStep(-2.2f, 2.2f, band));
    return scaled(wood, 1.0f + 0.05f * grain - 0.35f * pore);
  });
}

SrgbImage concrete(int side) {
  const Field cement = fractalNoise(side, {48.0f, 2.0f, 0.7f}, 231);
  const Field grit = fractalNoise(side, {4.0f, 1.0f, 0.9f}, 232);
  const Mosaic pores(side, {.spacing = 14.0f, .smallest = 0.4f, .largest = 1.8f, .longest = 1.3f},
                     233);
  return painted(side, [&](int sx, int sy) {
    const GrainHit cell = pores.at(pixelOf(sx), pixelOf(sy));
    Random random(cell.grain->id);
    const float radius = random.chance(0.12f) ? random.range(0.6f, 2.2f) : 0.0f;
    const float away = cell.along * cell.along + cell.across * cell.across;
    const float pore = 1.0f - smoothStep(0.5f * radius * radius, radius * radius + 0.01f, away);
    return scaled({0.56f, 0.56f, 0.54f},
                  1.0f + 0.035f * cement.at(sx, sy) + 0.03f * grit.at(sx, sy) - 0.45f * pore);
  });
}

} // namespace lichen::exemplars
