// SPDX-License-Identifier: MIT
// Denim, knitting and corrugated iron: materials that repeat and have no cells.
#include "structured_sheet.h"

#include <algorithm>
#include <cmath>

namespace lichen::exemplars {
namespace {

constexpr float kYarn = 11.0f; // pitch of both warp and weft
constexpr int kTwill = 4;      // the warp passes over three wefts and under one

/// Twill: the dyed warp runs along y, the undyed weft shows in diagonal steps.
Surface denim(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {1.5f * kYarn, 1.5f * kYarn});
  const float x = p.x / kYarn, y = p.y / kYarn;
  const int row0 = int(std::floor(y));
  // The weft, and the floats of three warps, which are wider than their pitch: the highest shows.
  float across = 2.0f * (y - float(row0)) - 1.0f, along = 0.0f;
  float bulge = 1.0f - across * across, height = 1.9f * bulge;
  bool isWeft = true;
  int column0 = int(std::floor(x));
  for (int i = int(std::floor(x)) - 1; i <= int(std::floor(x)) + 1; ++i) {
    constexpr float kHalfWidth = 0.64f, kHalfLength = 1.8f, kMiddle = 2.5f;
    const float u = (x - float(i) - 0.5f) / kHalfWidth, t = float(i) + y;
    float v = t - float(kTwill) * std::floor(t / float(kTwill)) - kMiddle;
    v = (v < -0.5f * float(kTwill) ? v + float(kTwill) : v) / kHalfLength;
    const float body = (1.0f - u * u) * (1.0f - v * v * v * v);
    if (std::abs(u) >= 1.0f || std::abs(v) >= 1.0f || 3.8f * body - 0.2f <= height)
      continue;
    isWeft = false;
    column0 = i;
    across = u;
    along = v;
    bulge = body;
    height = 3.8f * body - 0.2f;
  }
  // Fibres wind around the yarn.
  const int column = sheet.wrapped(column0, kYarn, Axis::x),
            row = sheet.wrapped(row0, kYarn, Axis::y);
  const std::uint32_t own = isWeft ? sheet.channelOf(0, row, 201) : sheet.channelOf(column, 0, 202);
  const Point twisted = isWeft ? Point{at.x + 0.6f * kYarn * across, at.y}
                               : Point{at.x, at.y + 0.6f * kYarn * across};
  const float fibre =
      sheet.fractal(twisted, isWeft ? Point{1.6f, 5.0f} : Point{5.0f, 1.6f}, 2, own);
  const float slub = sheet.noise(at, isWeft ? Point{90.0f, 30.0f} : Point{30.0f, 90.0f}, own + 3);
  const float fuzz = sheet.fractal(at, 3.0f, 2, 203), fade = sheet.fractal(at, 120.0f, 3, 204);
  Surface surface;
  if (isWeft) {
    surface.color = scaled({0.64f, 0.66f, 0.68f}, 1.0f + 0.10f * fibre);
  } else {
    // Dye wears off the crowns first.
    const float worn =
        clamped(0.08f + 0.10f * along * along +
                    0.55f * bulge * (0.5f + 0.35f * fade + 0.35f * slub) + 0.16f * fibre,
                0.0f, 1.0f);
    surface.color = mix({0.13f, 0.19f, 0.33f}, {0.50f, 0.58f, 0.70f}, worn);
  }
  surface.color = scaled(surface.color, 0.70f + 0.36f * bulge + 0.07f * fuzz + 0.06f * slub);
  surface.height = height * (1.0f + 0.15f * slub) + 0.45f * fibre;
  return surface;
}

constexpr float kWale = 45.0f, kStitchRow = 35.0f;

/// Stocking stitch: each stitch shows its two legs, as a V.
Surface knit(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {kWale, kStitchRow});
  const int column = int(std::floor(p.x / kWale));
  const float u = p.x / kWale - float(column);
  const bool isRight = u >= 0.5f;
  const float inner = isRight ? 2.0f - 2.0f * u : 2.0f * u; // 0 between stitches, 1 inside the V
  // Legs fall toward the inside of the V, most in their middle.
  constexpr float kDrop = 1.05f; // rows
  const float fall = kDrop * (0.45f * inner + 0.55f * smoothStep(0.0f, 1.0f, inner));
  const float y = p.y / kStitchRow - fall;
  const int row = int(std::floor(y));
  const float across = 2.0f * (y - float(row)) - 1.0f, along = 2.0f * inner - 1.0f;
  const float square = along * along;
  const float thick = 1.0f - 0.16f * square - 0.16f * square * square; // ends are thinner
  const float share = std::abs(across + 0.1f * square) / thick;
  const float round = std::sqrt(std::max(0.0f, 1.0f - share * share));
  const float height = 8.5f * round * (1.0f - 0.55f * square * square) + 0.8f * along;
  const int i = 2 * sheet.wrapped(column, kWale, Axis::x) + (isRight ? 1 : 0);
  const std::uint32_t own = sheet.channelOf(i, sheet.wrapped(row, kStitchRow, Axis::y), 211);
  // Plies wind around the yarn; fibres lie along the leg.
  const float ply = wave(1.7f * along - 0.75f * across);
  const float fibre = sheet.fractal({at.x, at.y - kStitchRow * fall}, {9.0f, 2.2f}, 2, own);
  const float heather = sheet.fractal(at, 5.0f, 2, 213), fuzz = sheet.fractal(at, 2.6f, 2, 214);
  const float cloud = sheet.fractal(at, 130.0f, 2, 215);
  const float tone = 0.94f + 0.12f * float(own >> 8u) * 0x1p-24f;
  const float t = clamped(0.60f + 0.22f * heather + 0.12f * ply + 0.18f * fibre, 0.0f, 1.0f);
  Surface surface;
  surface.color = scaled(mix({0.40f, 0.20f, 0.21f}, {0.83f, 0.56f, 0.52f}, t),
                         tone * (0.80f + 0.22f * round + 0.05f * cloud + 0.06f * fuzz));
  surface.height = height + 1.3f * ply * round + 0.7f * fibre + 0.5f * fuzz;
  return surface;
}

constexpr float kRidge = 56.0f, kScrewRow = 178.0f;

/// Galvanized sheet with a screw on every ridge, rusty below.
Surface corrugated(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {0.5f * kRidge, 0.1f * kScrewRow});
  const float swell = wave(p.x / kRidge + 0.25f); // 1 on ridges, which are at 0
  const int ridge = int(std::floor(p.x / kRidge + 0.5f));
  const int screwRow = int(std::floor(p.y / kScrewRow + 0.25f));
  const int i = sheet.wrapped(ridge, kRidge, Axis::x);
  const auto toss = [&](int row, std::uint32_t k) {
    return sheet.hashed(i, sheet.wrapped(row, kScrewRow, Axis::y), 221 + k);
  };
  const auto screwAt = [&](int row) {
    const float loose = 4.0f + 60.0f * sheet.irregularity;
    return Point{kRidge * float(ridge) + loose * (toss(row, 0) - 0.5f),
                 kScrewRow * (float(row) + 0.1f) + loose * (toss(row, 1) - 0.5f)};
  };
  // Crystals of zinc, two sizes of patches.
  const float spangle =
      sheet.noise({at.x + 5.0f * sheet.noise(at, {12.0f, 12.0f}, 231), at.y}, {8.0f, 8.0f}, 232);
  const float crystal = spangle > 0.2f ? 0.05f : spangle < -0.25f ? -0.05f : 0.0f;
  const float streak = sheet.fractal(at, {4.0f, 120.0f}, 2, 233);
  const float dull = sheet.fractal(at, 110.0f, 4, 234), grit = sheet.fractal(at, 3.0f, 2, 235);
  Surface surface;
  surface.color = scaled({0.57f, 0.60f, 0.62f}, 1.0f + crystal + 0.05f * streak + 0.08f * dull);
  surface.height = 11.0f * swell + 0.10f * grit + 0.8f * dull;
  surface.gloss = 0.45f;
  // Rust runs down from the screws and collects in patches.
  float rust = 0.55f * smoothStep(0.45f, 1.2f, sheet.fractal(at, 85.0f, 5, 236));
  for (int row = screwRow - 1; row <= screwRow; ++row) {
    const Point screw = screwAt(row);
    const float dx = p.x - screw.x, dy = p.y - screw.y;
    const float reach = 40.0f + 110.0f * toss(row, 2);
    if (dy < -14.0f || dy > reach)
      continue;
    const float fade = 1.0f - std::max(dy, 0.0f) / reach;
    const float width = 5.0f + 3.0f * fade + 2.5f * streak;
    const float off = std::sqrt(dx * dx + std::min(dy, 0.0f) * std::min(dy, 0.0f));
    rust += toss(row, 3) * fade * (1.0f - smoothStep(0.3f * width, width, off)) *
            (0.9f + 0.3f * streak);
  }
  rust = clamped(rust * (1.0f + 0.4f * grit), 0.0f, 1.0f);
  const float tone = 0.5f + 0.3f * sheet.fractal(at, 14.0f, 3, 238);
  surface.color = mix(surface.color, mix({0.30f, 0.15f, 0.09f}, {0.60f, 0.34f, 0.18f}, tone),
                      0.92f * smoothStep(0.05f, 0.75f, rust));
  surface.height += 0.7f * rust * grit;
  surface.gloss *= 1.0f - rust;
  const Point screw = screwAt(screwRow);
  const float radius =
      std::sqrt((p.x - screw.x) * (p.x - screw.x) + (p.y - screw.y) * (p.y - screw.y));
  constexpr float kWasher = 7.5f, kHead = 4.2f;
  if (radius < kWasher) {
    const bool isHead = radius < kHead;
    surface.color = mix(isHead ? Color{0.55f, 0.54f, 0.52f} : Color{0.20f, 0.19f, 0.18f},
                        {0.40f, 0.23f, 0.14f}, 0.8f * toss(screwRow, 3) * (0.7f + 0.5f * grit));
    surface.height += isHead ? 4.2f - 0.09f * radius * radius : 1.2f;
    surface.gloss = isHead ? 0.5f : 0.0f;
  }
  return surface;
}

} // namespace

const StructuredMaterial kDenim{
    "denim", denim, {kTwill * kYarn, kTwill* kYarn}, {{{kTwill * kYarn, 0.0f}, {kYarn, -kYarn}}},
    false,
};
const StructuredMaterial kKnit{
    "knit", knit, {kWale, kStitchRow}, {{{kWale, 0.0f}, {0.0f, kStitchRow}}}, false,
};
const StructuredMaterial kCorrugated{
    "corrugated", corrugated, {kRidge, kScrewRow}, {{{kRidge, 0.0f}, {0.0f, kScrewRow}}}, false,
};

} // namespace lichen::exemplars
