// SPDX-License-Identifier: MIT
// A floor of boards, herringbone parquet, shingles, and a basket of splints.
#include "structured_sheet.h"

#include <algorithm>
#include <cmath>

namespace lichen::exemplars {
namespace {

struct Board {
  int column = 0, row = 0; ///< wrapped
  Axis along = Axis::x;
  float inside = 0.0f; ///< distance to its nominal border
};

/// A varnished board with worn edges; `channel` selects the tones.
Surface boardAt(Point p, const Sheet& sheet, const Board& board, float gap, const Color& dark,
                const Color& light) {
  const float rough = sheet.fractal(p, 11.0f, 2, 111);
  const float inside = board.inside - gap + 0.18f * rough;
  Surface surface;
  if (inside > 0.0f) {
    const auto toss = [&](std::uint32_t k) {
      return sheet.hashed(board.column, board.row, 112 + k);
    };
    const float tone = 0.84f + 0.30f * toss(0), warm = toss(1) - 0.5f;
    const auto tinted = [&](const Color& c) {
      return Color{c.r * tone * (1.0f + 0.08f * warm), c.g * tone,
                   c.b * tone * (1.0f - 0.18f * warm)};
    };
    surface = wood(p, sheet, board.along, sheet.channelOf(board.column, board.row, 116),
                   tinted(dark), tinted(light));
    const float worn = smoothStep(0.3f, 1.0f, sheet.fractal(p, 80.0f, 3, 117));
    const float edge = 1.0f - smoothStep(0.0f, 2.2f, inside);
    surface.color =
        mix(scaled(surface.color, 1.0f - 0.35f * edge), {0.60f, 0.50f, 0.40f}, 0.20f * worn);
    surface.height += 1.6f * smoothStep(-0.4f, 2.6f, inside) + 0.5f * (toss(2) - 0.5f);
    surface.gloss *= 1.0f - 0.6f * worn;
  } else {
    const float dust = sheet.fractal(p, 12.0f, 2, 118);
    surface.color = scaled({0.13f, 0.10f, 0.08f}, 1.0f + 0.4f * dust);
    surface.height = -0.8f;
  }
  surface.column = board.column;
  surface.row = board.row;
  surface.joint = inside <= 0.0f;
  return surface;
}

constexpr float kBoardWidth = 44.0f, kBoardLength = 190.0f;

/// Boards along x; the ends of each row are a third of a board from the ends of the row before.
Surface floorBoards(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {0.3f * kBoardWidth, 0.3f * kBoardWidth});
  const Slot y = sheet.slot(p.y, kBoardWidth, 0.0f, Axis::y, 0);
  const float start = float((y.index % 3 + 3) % 3) / 3.0f;
  const Slot x = sheet.slot(p.x, kBoardLength, start, Axis::x, y.index);
  const Board board{x.index, y.index, Axis::x, insideBox(x, y, 1.5f)};
  Surface surface = boardAt(at, sheet, board, 0.9f, {0.44f, 0.29f, 0.18f}, {0.76f, 0.58f, 0.40f});
  // Two nails at each end.
  constexpr float kFromEnd = 7.0f, kFromSide = 9.0f, kRadius = 1.7f;
  const float dx = std::min(x.before, x.after) - kFromEnd;
  const float dy = std::min(y.before, y.after) - kFromSide;
  const float nail =
      1.0f - smoothStep(kRadius - 0.5f, kRadius + 0.5f, std::sqrt(dx * dx + dy * dy));
  surface.color = mix(surface.color, {0.20f, 0.17f, 0.15f}, nail);
  surface.height -= 0.8f * nail;
  return surface;
}

constexpr float kStaveWidth = 20.0f; // a stave is a row of kStaveCells squares
constexpr int kStaveCells = 4;

/// A square (i, j) belongs to a stave along x or along y by (i - j) modulo 2 kStaveCells.
Surface herringbone(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {kStaveWidth, kStaveWidth});
  const int i = int(std::floor(p.x / kStaveWidth)), j = int(std::floor(p.y / kStaveWidth));
  const float fx = p.x - kStaveWidth * float(i), fy = p.y - kStaveWidth * float(j);
  constexpr int kPeriod = 2 * kStaveCells;
  const int phase = ((i - j) % kPeriod + kPeriod) % kPeriod;
  const bool isAlongX = phase < kStaveCells;
  const int part = isAlongX ? phase : kPeriod - 1 - phase;
  const auto spanOf = [](float in, int k) {
    const float before = in + kStaveWidth * float(k);
    return Slot{0, before, kStaveWidth * float(kStaveCells) - before};
  };
  const Slot across{0, isAlongX ? fy : fx, kStaveWidth - (isAlongX ? fy : fx)};
  const Slot along = spanOf(isAlongX ? fx : fy, part);
  const Board stave{sheet.wrapped(isAlongX ? i - part : i, kStaveWidth, Axis::x),
                    sheet.wrapped(isAlongX ? j : j - part, kStaveWidth, Axis::y),
                    isAlongX ? Axis::x : Axis::y, insideBox(across, along, 1.0f)};
  return boardAt(at, sheet, stave, 0.4f, {0.36f, 0.20f, 0.11f}, {0.68f, 0.46f, 0.28f});
}

constexpr float kShingleWidth = 53.0f, kShingleHeight = 46.0f;

/// Cedar shingles; each row covers the top of the one below.
Surface shingles(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {0.5f * kShingleWidth, 0.5f * kShingleHeight});
  const int guess = int(std::floor(p.y / kShingleHeight));
  const float splinters = sheet.noise(at, {5.0f, 30.0f}, 131);
  // The lowest edge that is below the point belongs to the shingle on top.
  for (int row = guess - 1;; ++row) {
    const int wrappedRow = sheet.wrapped(row, kShingleHeight, Axis::y);
    const Slot x =
        sheet.slot(p.x, kShingleWidth, 0.5f * float(wrappedRow & 1), Axis::x, wrappedRow);
    const auto toss = [&](std::uint32_t k) { return sheet.hashed(x.index, wrappedRow, 132 + k); };
    const float uneven = (0.06f + 2.0f * sheet.irregularity) * (toss(0) - 0.5f);
    const float below = kShingleHeight * (float(row) + 1.0f + uneven) + 0.8f * splinters - p.y;
    if (below <= 0.0f && row <= guess)
      continue;
    const float gap = std::min(x.before, x.after) - 0.9f - 0.5f * toss(1) + 0.3f * splinters;
    const float up = std::min(below / kShingleHeight, 1.3f);
    Surface surface;
    surface.column = x.index;
    surface.row = wrappedRow;
    surface.joint = gap <= 0.0f;
    const float thick = 3.2f + 1.4f * toss(2);
    surface.height = thick * (1.0f - up);
    if (surface.joint) {
      surface.height -= 2.5f;
      surface.color = {0.14f, 0.11f, 0.09f};
      return surface;
    }
    const std::uint32_t own = sheet.channelOf(x.index, wrappedRow, 136);
    const float tone = 0.78f + 0.36f * toss(3);
    const Surface grain = wood(at, sheet, Axis::y, own, scaled({0.33f, 0.27f, 0.22f}, tone),
                               scaled({0.63f, 0.55f, 0.46f}, tone));
    const float weather = sheet.fractal(at, 70.0f, 4, 141);
    const float silver = clamped(0.35f + 0.5f * weather + 0.5f * (toss(4) - 0.5f), 0.0f, 1.0f);
    const float grey = 0.5f * (grain.color.r + grain.color.g);
    surface.color = mix(grain.color, {grey, grey, 0.98f * grey}, silver);
    // Rain washes what is low; the part under the row above stays dark.
    surface.color =
        scaled(surface.color,
               (1.06f - 0.30f * up) * (1.0f - 0.25f * (1.0f - smoothStep(0.0f, 2.0f, gap))));
    surface.height +=
        4.0f * grain.height + 0.8f * (toss(5) - 0.5f) + 0.5f * smoothStep(0.0f, 2.0f, gap);
    return surface;
  }
}

constexpr float kSplint = 22.0f; // pitch; splints go over and under two others by turns

/// The splint around x along the axis, and its neighbour of the same pair.
struct Pair {
  Pair(float x, const Sheet& sheet, Axis axis) : splint(sheet.slot(x, kSplint, 0.0f, axis, 0)) {
    const bool isSecond = (splint.index & 1) != 0;
    const float middleOfOther =
        x + (isSecond ? -splint.before - 0.5f * kSplint : splint.after + 0.5f * kSplint);
    const Slot other = sheet.slot(middleOfOther, kSplint, 0.0f, axis, 0);
    const float length = other.before + other.after;
    both = {splint.index >> 1, splint.before + (isSecond ? length : 0.0f),
            splint.after + (isSecond ? 0.0f : length)};
  }
  Slot splint, both;
};

/// Basket weave: a cell is what a splint shows where it passes over two others.
Surface basket(Point at, const Sheet& sheet) {
  const Point p = sheet.uneven(at, {kSplint, kSplint});
  const Pair x(p.x, sheet, Axis::x), y(p.y, sheet, Axis::y);
  const bool isAlongX = ((x.both.index + y.both.index) & 1) == 0;
  const Slot& across = isAlongX ? y.splint : x.splint;
  const Slot& along = isAlongX ? x.both : y.both;
  Surface surface;
  surface.column = isAlongX ? 2 * x.both.index : x.splint.index;
  surface.row = isAlongX ? y.splint.index : 2 * y.both.index;
  const float rough = sheet.fractal(at, 9.0f, 2, 151);
  const float inside = insideBox(across, along, 2.0f) - 1.0f + 0.2f * rough;
  surface.joint = inside <= 0.0f;
  if (surface.joint) {
    surface.color = scaled({0.16f, 0.12f, 0.08f}, 1.0f + 0.3f * rough);
    surface.height = -1.5f;
    return surface;
  }
  const auto toss = [&](std::uint32_t k) {
    return sheet.hashed(across.index, isAlongX ? 1 : 0, 152 + k);
  };
  const float tone =
      0.82f + 0.26f * toss(0) + 0.06f * sheet.hashed(surface.column, surface.row, 155);
  const std::uint32_t own = sheet.channelOf(across.index, isAlongX ? 1 : 0, 156);
  const Surface grain = wood(at, sheet, isAlongX ? Axis::x : Axis::y, own,
                             mix({0.48f, 0.32f, 0.16f}, {0.42f, 0.30f, 0.20f}, toss(1)),
                             mix({0.82f, 0.66f, 0.42f}, {0.74f, 0.62f, 0.46f}, toss(1)));
  const float t = (along.before - along.after) / (along.before + along.after);
  const float u = (across.before - across.after) / (across.before + across.after);
  const float dirt = sheet.fractal(at, 60.0f, 3, 161), end = t * t;
  surface.color = scaled(grain.color, tone * (1.0f + 0.05f * dirt) * (1.0f - 0.22f * end * end) *
                                          (0.8f + 0.2f * smoothStep(0.0f, 2.0f, inside)));
  surface.height = 4.5f * (1.0f - end) + 0.9f * (1.0f - u * u) + 2.0f * grain.height;
  surface.gloss = 0.18f;
  return surface;
}

} // namespace

const StructuredMaterial kFloor{
    "floor",
    floorBoards,
    {kBoardLength, 3.0f * kBoardWidth},
    {{{kBoardLength, 0.0f}, {kBoardLength / 3.0f, kBoardWidth}}},
};
const StructuredMaterial kHerringbone{
    "herringbone",
    herringbone,
    {2.0f * kStaveCells * kStaveWidth, 2.0f * kStaveCells* kStaveWidth},
    {{{kStaveWidth, kStaveWidth}, {kStaveCells * kStaveWidth, -kStaveCells* kStaveWidth}}},
};
const StructuredMaterial kShingles{
    "shingles",
    shingles,
    {kShingleWidth, 2.0f * kShingleHeight},
    {{{kShingleWidth, 0.0f}, {0.5f * kShingleWidth, kShingleHeight}}},
};

const StructuredMaterial kBasket{
    "basket",
    basket,
    {4.0f * kSplint, 4.0f * kSplint},
    {{{2.0f * kSplint, 2.0f * kSplint}, {2.0f * kSplint, -2.0f * kSplint}}},
};

} // namespace lichen::exemplars
