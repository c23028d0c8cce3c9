// SPDX-License-Identifier: MIT
// Bricks in three bonds, glazed tiles, and cobbles.
#include "structured_sheet.h"

#include <algorithm>
#include <cmath>

namespace lichen::exemplars {
namespace {

/// A brick's place: its face is inside > 0.
struct Brick {
  int column = 0, row = 0; ///< wrapped
  float inside = 0.0f;     ///< distance to its nominal border, which is in the middle of the joint
};

constexpr float kCourse = 29.0f, kStretcher = 87.0f; // pitches

Surface brickwork(Point p, const Sheet& sheet, const Brick& brick) {
  // Edges are ragged, and here and there chipped.
  const float rough = sheet.fractal(p, 7.0f, 3, 31);
  const float chip = smoothStep(0.45f, 1.0f, sheet.fractal(p, 17.0f, 2, 32));
  const float inside = brick.inside - 2.3f + 0.7f * rough - 3.2f * chip;
  const float grit = sheet.fractal(p, 3.0f, 2, 33), cloud = sheet.fractal(p, 40.0f, 2, 34);
  Surface surface;
  surface.column = brick.column;
  surface.row = brick.row;
  surface.joint = inside <= 0.0f;
  if (surface.joint) {
    const float sandy = sheet.noise(p, {1.6f, 1.6f}, 35);
    surface.color =
        scaled({0.66f, 0.63f, 0.57f}, 1.0f + 0.08f * cloud + 0.09f * sandy + 0.05f * grit);
    surface.height = 0.45f * grit + 0.5f * rough;
    return surface;
  }
  const std::uint32_t own = sheet.channelOf(brick.column, brick.row, 36);
  const auto toss = [&](std::uint32_t k) { return sheet.hashed(brick.column, brick.row, 37 + k); };
  const float blotch = sheet.fractal(p, 26.0f, 3, own);
  const float fleck = sheet.noise(p, {2.2f, 2.2f}, own + 1);
  Color fired = mix({0.50f, 0.24f, 0.17f}, {0.70f, 0.40f, 0.28f}, toss(0));
  fired = mix(fired, {0.66f, 0.47f, 0.33f}, 0.6f * toss(1) * toss(1));
  const float burnt = toss(2) < 0.14f ? 0.65f : 0.12f * toss(3); // some lay close to the fire
  fired = mix(fired, {0.27f, 0.19f, 0.19f}, burnt * clamped(0.8f + 0.5f * blotch, 0.0f, 1.0f));
  float tone = 1.0f + 0.10f * blotch + 0.06f * grit + 0.05f * cloud;
  tone *= 1.0f - 0.35f * smoothStep(0.72f, 0.95f, fleck);
  // Lime from the mortar.
  const float lime = smoothStep(0.35f, 1.1f, sheet.fractal(p, 60.0f, 4, 41)) *
                     (0.25f + 0.3f * (1.0f - smoothStep(0.0f, 8.0f, inside)));
  surface.color = mix(scaled(fired, tone), {0.78f, 0.74f, 0.70f}, lime);
  surface.height = 2.6f * smoothStep(-0.3f, 3.2f, inside) + 0.30f * grit + 0.5f * blotch -
                   0.9f * smoothStep(0.66f, 0.95f, fleck) + 1.2f * (toss(4) - 0.5f);
  return surface;
}

Surface bond(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {kCourse, kCourse});
  const Slot y = sheet.slot(p.y, kCourse, 0.0f, Axis::y, 0);
  const Slot x = sheet.slot(p.x, kStretcher, 0.5f * float(y.index & 1), Axis::x, y.index);
  return brickwork(at, sheet, {x.index, y.index, insideBox(x, y, 4.0f)});
}

/// Courses of stretchers and of headers take turns.
Surface english(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {kCourse, kCourse});
  const Slot y = sheet.slot(p.y, kCourse, 0.0f, Axis::y, 0);
  const bool headers = (y.index & 1) != 0;
  const Slot x = sheet.slot(p.x, headers ? 0.5f * kStretcher : kStretcher, headers ? 0.5f : 0.0f,
                            Axis::x, y.index);
  return brickwork(at, sheet, {x.index, y.index, insideBox(x, y, 4.0f)});
}

/// Each course takes turns of a stretcher and a header, each header over the middle of a stretcher.
Surface flemish(Point at, const Sheet& sheet) {
  constexpr float kPair = 1.5f * kStretcher;
  const Point p = sheet.uneven(at, {kCourse, kCourse});
  const Slot y = sheet.slot(p.y, kCourse, 0.0f, Axis::y, 0);
  const Slot pair = sheet.slot(p.x, kPair, 0.5f * float(y.index & 1), Axis::x, y.index);
  const float length = pair.before + pair.after;
  const float joint =
      length * (2.0f / 3.0f + sheet.irregularity * (sheet.hashed(pair.index, y.index, 15) - 0.5f));
  const bool header = pair.before >= joint;
  const Slot x = header ? Slot{2 * pair.index + 1, pair.before - joint, pair.after}
                        : Slot{2 * pair.index, pair.before, joint - pair.before};
  return brickwork(at, sheet, {x.index, y.index, insideBox(x, y, 4.0f)});
}

constexpr float kTile = 62.0f;

Surface tiles(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {0.5f * kTile, 0.5f * kTile});
  const Slot x = sheet.slot(p.x, kTile, 0.0f, Axis::x, 0);
  const Slot y = sheet.slot(p.y, kTile, 0.0f, Axis::y, 0);
  const float rough = sheet.fractal(at, 9.0f, 2, 51);
  const float inside = insideBox(x, y, 5.0f) - 2.4f + 0.25f * rough;
  const float dirt = sheet.fractal(at, 90.0f, 3, 52), grit = sheet.noise(at, {1.8f, 1.8f}, 53);
  Surface surface;
  surface.column = x.index;
  surface.row = y.index;
  surface.joint = inside <= 0.0f;
  if (surface.joint) {
    surface.color = scaled({0.60f, 0.58f, 0.54f}, 1.0f + 0.14f * dirt + 0.08f * grit);
    surface.height = 0.4f * grit;
    return surface;
  }
  const std::uint32_t own = sheet.channelOf(x.index, y.index, 54);
  const auto toss = [&](std::uint32_t k) { return sheet.hashed(x.index, y.index, 55 + k); };
  const float pool = sheet.fractal(at, 34.0f, 4, own);
  Color glaze = mix({0.16f, 0.40f, 0.44f}, {0.36f, 0.60f, 0.58f}, toss(0));
  glaze = mix(glaze, {0.30f, 0.46f, 0.56f}, 0.5f * toss(1));
  // Glaze is thin, and pale, at the edges; a pinhole here and there.
  const float thin = 1.0f - smoothStep(0.5f, 5.0f, inside);
  const float pinhole = smoothStep(0.93f, 0.99f, sheet.noise(at, {3.0f, 3.0f}, own + 9));
  glaze = mix(glaze, {0.66f, 0.68f, 0.60f}, 0.45f * thin);
  surface.color = scaled(glaze, (1.0f + 0.13f * pool + 0.03f * dirt) * (1.0f - 0.5f * pinhole));
  const float tilt =
      0.05f * ((toss(2) - 0.5f) * (x.before - x.after) + (toss(3) - 0.5f) * (y.before - y.after));
  surface.height = 2.0f + 2.2f * smoothStep(0.0f, 5.5f, inside) + tilt +
                   0.9f * sheet.noise(at, {22.0f, 22.0f}, own + 3);
  surface.gloss = 0.75f;
  return surface;
}

constexpr float kCobble = 57.0f;

/// Stones in rows, none like another: the cells of jittered points.
Surface cobbles(Point at, const Sheet& sheet) {
  const float rough = sheet.fractal(at, 14.0f, 3, 71);
  const Point p{at.x + 2.2f * sheet.noise(at, {19.0f, 19.0f}, 72) + 0.5f * rough,
                at.y + 2.2f * sheet.noise(at, {19.0f, 19.0f}, 73) + 0.5f * rough};
  struct Stone {
    Point middle;
    int column = 0, row = 0;
    float squared = 1e9f;
  };
  std::array<Stone, 25> stones;
  std::size_t count = 0;
  Stone nearest;
  const int row0 = int(std::floor(p.y / kCobble));
  for (int row = row0 - 2; row <= row0 + 2; ++row) {
    const int wrappedRow = sheet.wrapped(row, kCobble, Axis::y);
    const float start = 0.5f * float(wrappedRow & 1);
    const int column0 = int(std::floor(p.x / kCobble - start));
    for (int column = column0 - 2; column <= column0 + 2; ++column) {
      Stone stone;
      stone.column = sheet.wrapped(column, kCobble, Axis::x);
      stone.row = wrappedRow;
      const float jitter = 0.5f + 2.0f * sheet.irregularity;
      const std::uint32_t own = sheet.channelOf(stone.column, stone.row, 74);
      const float dx = jitter * (float(own >> 16u) * 0x1p-16f - 0.5f);
      const float dy = jitter * (float(own & 0xFFFFu) * 0x1p-16f - 0.5f);
      stone.middle = {kCobble * (float(column) + start + 0.5f + dx),
                      kCobble * (float(row) + 0.5f + dy)};
      const float ox = p.x - stone.middle.x, oy = p.y - stone.middle.y;
      stone.squared = ox * ox + oy * oy;
      if (stone.squared < nearest.squared)
        nearest = stone;
      stones[count++] = stone;
    }
  }
  // Distances to the borders with all neighbours, combined so that corners are round.
  float soft = 0.0f;
  for (const Stone& other : stones) {
    const float ax = other.middle.x - nearest.middle.x, ay = other.middle.y - nearest.middle.y;
    const float apart = std::sqrt(ax * ax + ay * ay);
    if (apart < 1.0f)
      continue;
    const float off = std::max((other.squared - nearest.squared) / (2.0f * apart), 0.5f);
    soft += 1.0f / (off * off);
  }
  const float inside = 1.0f / std::sqrt(soft) - 2.2f + 0.5f * rough;
  const float grit = sheet.fractal(at, 3.0f, 2, 76);
  Surface surface;
  surface.column = nearest.column;
  surface.row = nearest.row;
  surface.joint = inside <= 0.0f;
  if (surface.joint) {
    const float moss = smoothStep(-0.1f, 0.5f, sheet.fractal(at, 70.0f, 3, 77));
    const Color soil = mix({0.28f, 0.24f, 0.19f}, {0.27f, 0.31f, 0.15f}, moss);
    surface.color = scaled(soil, 1.0f + 0.30f * grit);
    surface.height = 0.8f * grit + 0.8f * moss;
    return surface;
  }
  const std::uint32_t own = sheet.channelOf(nearest.column, nearest.row, 78);
  const auto toss = [&](std::uint32_t k) {
    return sheet.hashed(nearest.column, nearest.row, 79 + k);
  };
  const float blotch = sheet.fractal(at, 24.0f, 3, own);
  const float crystal = sheet.noise(at, {2.0f, 2.0f}, own + 1);
  Color stone = mix({0.36f, 0.36f, 0.38f}, {0.60f, 0.58f, 0.56f}, toss(0));
  stone = mix(stone, {0.56f, 0.46f, 0.40f}, toss(1) < 0.3f ? 0.6f : 0.1f);
  const float tone = 1.0f + 0.10f * blotch + 0.14f * crystal + 0.06f * grit;
  surface.color = scaled(stone, tone * (0.8f + 0.2f * smoothStep(0.0f, 7.0f, inside)));
  const float dome = std::min(inside, 12.0f) / 12.0f;
  surface.height =
      2.0f + 7.0f * dome * (2.0f - dome) + 1.3f * blotch + 0.35f * grit + 1.5f * (toss(2) - 0.5f);
  surface.gloss = 0.08f;
  return surface;
}

} // namespace

const StructuredMaterial kBond{
    "bond",
    bond,
    {kStretcher, 2.0f * kCourse},
    {{{kStretcher, 0.0f}, {0.5f * kStretcher, kCourse}}},
};
const StructuredMaterial kEnglish{
    "english",
    english,
    {kStretcher, 2.0f * kCourse},
    {{{kStretcher, 0.0f}, {0.0f, 2.0f * kCourse}}},
};
const StructuredMaterial kFlemish{
    "flemish",
    flemish,
    {1.5f * kStretcher, 2.0f * kCourse},
    {{{1.5f * kStretcher, 0.0f}, {0.75f * kStretcher, kCourse}}},
};
const StructuredMaterial kTiles{
    "tiles",
    tiles,
    {kTile, kTile},
    {{{kTile, 0.0f}, {0.0f, kTile}}},
};
const StructuredMaterial kCobbles{"cobbles", cobbles, {kCobble, 2.0f * kCobble}, {}};

} // namespace lichen::exemplars
