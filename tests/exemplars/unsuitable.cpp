// SPDX-License-Identifier: MIT
#include "unsuitable.h"

#include <algorithm>
#include <cmath>
#include <periodic.h>

namespace lichen::exemplars {
namespace {

/// Multiplies the linear light of every pixel; rounds and clips to 8 bits.
template <typename FactorAt>
SrgbImage relit(SrgbImage image, const FactorAt& factorAt) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) {
        float& value =
            image.values[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 3 +
                         std::size_t(c)];
        const float lit = linearToSrgb(srgbToLinear(value) * factorAt(x, y));
        value = std::round(255.0f * std::clamp(lit, 0.0f, 1.0f)) / 255.0f;
      }
  return image;
}

/// Noise whose power spectrum falls as frequency^-exponent, in octaves from the full side down to
/// two pixels.
Field cloud(int side, float exponent, std::uint32_t seed) {
  // An octave at frequency f has energy proportional to f^(2 - exponent); the amplitude is its
  // square root.
  const float gain = std::pow(2.0f, (2.0f - exponent) / 2.0f);
  return fractalNoise(side, {float(side), 2.0f, gain}, seed);
}

} // namespace

SrgbImage planks(int side) {
  constexpr int kBoards = 6;
  const Field grain = fractalNoise(side, {20.0f, 1.0f, 0.9f}, 41);
  const float width = float(side) / kBoards;
  return painted(side, [&](int sx, int sy) {
    const float x = pixelOf(sx);
    const int board = int(x / width);
    const float inside = x - width * float(board);
    const float gap = std::min(inside, width - inside);
    // Grain, stretched along the board.
    const float streak = grain.at(sx, sy / 16 + 97 * board);
    const Color wood = mix({0.50f, 0.36f, 0.22f}, {0.70f, 0.54f, 0.36f}, hashed(board, 0, 42));
    return mix({0.10f, 0.07f, 0.05f}, scaled(wood, 1.0f + 0.06f * streak),
               smoothStep(0.8f, 1.8f, gap));
  });
}

SrgbImage weave(int side) {
  const int threads = side / 8;
  const Field grain = fractalNoise(side, {5.0f, 1.0f, 0.8f}, 51);
  const float pitch = float(side) / float(threads);
  return painted(side, [&](int sx, int sy) {
    const float x = pixelOf(sx) / pitch, y = pixelOf(sy) / pitch;
    const bool warp = ((int(x) + int(y)) & 1) == 0;
    const float across = (warp ? x - std::floor(x) : y - std::floor(y)) - 0.5f;
    const float along = (warp ? y - std::floor(y) : x - std::floor(x)) - 0.5f;
    const float shade = (1.0f - 2.4f * across * across) * (1.0f - 1.2f * along * along);
    return scaled({0.74f, 0.68f, 0.56f}, shade * (1.0f + 0.05f * grain.at(sx, sy)));
  });
}

SrgbImage text(int side) {
  constexpr float kDot = 2.0f;               // a letter is five by seven dots
  constexpr int kAdvance = 6, kLeading = 11; // dots
  const Field paper = fractalNoise(side, {8.0f, 1.0f, 0.8f}, 61);
  return painted(side, [&](int sx, int sy) {
    const int dotX = int(pixelOf(sx) / kDot), dotY = int(pixelOf(sy) / kDot);
    const int column = dotX / kAdvance, line = dotY / kLeading;
    const int inX = dotX % kAdvance, inY = dotY % kLeading;
    // Strokes: a stem and a per-letter set of bars.
    const auto letter = std::uint32_t(26.0f * hashed(column, line, 62));
    const bool space = hashed(column, line, 63) < 0.18f;
    const bool bar = (inY == 0 && hashed(int(letter), 0, 64) < 0.6f) ||
                     (inY == 3 && hashed(int(letter), 1, 64) < 0.6f) ||
                     (inY == 6 && hashed(int(letter), 2, 64) < 0.6f);
    const bool stem = inX == 0 || (inX == 4 && hashed(int(letter), inY / 4, 65) < 0.6f);
    const bool ink = !space && inX < 5 && inY < 7 && (stem || bar);
    return scaled(ink ? Color{0.10f, 0.10f, 0.12f} : Color{0.92f, 0.90f, 0.85f},
                  1.0f + 0.015f * paper.at(sx, sy));
  });
}

SrgbImage oneStone(int side) {
  const Mosaic gravel(side, {.spacing = 7.0f, .smallest = 0.6f, .largest = 1.6f, .longest = 1.5f},
                      71);
  const Field grain = fractalNoise(side, {8.0f, 1.0f, 0.8f}, 72);
  const Field outline = fractalNoise(side, {float(side) / 2.0f, 8.0f, 0.5f}, 73);
  return painted(side, [&](int sx, int sy) {
    const float x = pixelOf(sx), y = pixelOf(sy), half = 0.5f * float(side);
    const float radius = std::hypot(x - half, y - half) / half + 0.05f * outline.at(sx, sy);
    const GrainHit hit = gravel.at(x, y);
    const Color ground =
        scaled({0.30f, 0.27f, 0.24f}, 0.6f + 0.8f * hashed(int(hit.grain->id), 0, 74) -
                                          0.3f * (1.0f - smoothStep(0.0f, 1.5f, hit.edge)));
    const Color stone = scaled({0.70f, 0.68f, 0.64f}, 1.0f + 0.05f * grain.at(sx, sy));
    return mix(stone, ground, smoothStep(0.58f, 0.61f, radius));
  });
}

SrgbImage paving(int side) {
  const Mosaic stones(
      side,
      {.spacing = 50.0f, .smallest = 0.7f, .largest = 1.4f, .longest = 1.5f, .irregularity = 0.8f},
      101);
  const Field grain = fractalNoise(side, {8.0f, 1.0f, 0.8f}, 102);
  return painted(side, [&](int sx, int sy) {
    const GrainHit hit = stones.at(pixelOf(sx), pixelOf(sy));
    const Color stone =
        mix({0.45f, 0.43f, 0.40f}, {0.68f, 0.64f, 0.58f}, hashed(int(hit.grain->id), 0, 103));
    return scaled(mix({0.16f, 0.14f, 0.12f}, stone, smoothStep(1.5f, 3.0f, hit.edge)),
                  1.0f + 0.06f * grain.at(sx, sy));
  });
}

SrgbImage slopingLight(int side) {
  return relit(sand(side), [&](int x, int) { return 0.3f + 1.4f * float(x) / float(side); });
}

SrgbImage vignette(int side) {
  const float half = 0.5f * float(side);
  return relit(sand(side), [&](int x, int y) {
    const float radius = std::hypot(float(x) - half, float(y) - half) / half;
    return 1.4f - 0.68f * radius * radius;
  });
}

SrgbImage overexposed(int side) {
  return relit(granite(side), [](int, int) { return 3.2f; });
}

SrgbImage carpet(int side) {
  const Field worn = cloud(side, 3.0f, 81);
  const Field fibres = fractalNoise(side, {4.0f, 1.0f, 0.9f}, 82);
  const Field dye = fractalNoise(side, {6.0f, 1.0f, 0.8f}, 83);
  const Field yarn = fractalNoise(side, {6.0f, 1.0f, 0.8f}, 84);
  return painted(side, [&](int sx, int sy) {
    const Color color{0.50f, 0.36f + 0.02f * dye.at(sx, sy), 0.34f + 0.03f * yarn.at(sx, sy)};
    return scaled(color, 1.0f + 0.16f * worn.at(sx, sy) + 0.07f * fibres.at(sx, sy));
  });
}

SrgbImage wood(int side) {
  const Field bands = cloud(side, 3.0f, 91);
  const Field fine = fractalNoise(side, {12.0f, 1.0f, 0.9f}, 92);
  return painted(side, [&](int sx, int sy) {
    // Both are stretched along y.
    const float dark = bands.at(sx, sy / 4), grain = fine.at(sx, sy / 8);
    return scaled({0.58f, 0.42f, 0.27f}, 1.0f + 0.18f * dark + 0.05f * grain);
  });
}

} // namespace lichen::exemplars
