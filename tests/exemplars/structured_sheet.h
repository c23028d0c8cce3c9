// SPDX-License-Identifier: MIT
// What the structured materials are made of: noise, random numbers and cells on a sheet that is
// endless or repeats.
#pragma once

#include "periodic.h"
#include "structured.h"

#include <array>
#include <cstdint>

namespace lichen::exemplars {

/// A material at a point.
struct Surface {
  Color color;
  float height = 0.0f;     ///< pixels
  float gloss = 0.0f;      ///< in [0, 1]
  int column = 0, row = 0; ///< of the cell; any pair that no other cell has
  bool joint = false;
};

/// An interval of a row of intervals.
struct Slot {
  int index = 0;                     ///< wrapped
  float before = 0.0f, after = 0.0f; ///< distances to both ends, pixels
};

enum class Axis { x, y };

/// The plane that a material covers.
struct Sheet {
  std::uint32_t seed = 0;
  float irregularity = 0.0f; ///< in cells
  Point extent;              ///< repeats after this many pixels; 0 for never

  /// Value noise in [-1, 1] of this period.
  [[nodiscard]] float noise(Point p, Point period, std::uint32_t channel) const;
  /// Sum of noises, each of half the period and 0.6 times the amplitude of the one before.
  [[nodiscard]] float fractal(Point p, Point period, int octaves, std::uint32_t channel) const;
  [[nodiscard]] float fractal(Point p, float period, int octaves, std::uint32_t channel) const {
    return fractal(p, {period, period}, octaves, channel);
  }
  /// A hash of a wrapped cell, in [0, 1).
  [[nodiscard]] float hashed(int column, int row, std::uint32_t channel) const;
  /// A channel of the cell's own.
  [[nodiscard]] std::uint32_t channelOf(int column, int row, std::uint32_t channel) const;
  /// The index of an interval, wrapped at the extent.
  [[nodiscard]] int wrapped(int index, float pitch, Axis axis) const;
  /// Moves a point by smooth noise, by up to the irregularity.
  [[nodiscard]] Point uneven(Point p, Point pitch) const;
  /// The interval around x, in intervals of about this length; the first begins at `start` lengths.
  /// Each row has its own lengths.
  [[nodiscard]] Slot slot(float x, float pitch, float start, Axis axis, int row) const;
};

/// The distance from the inside of a rectangle with round corners to its border.
[[nodiscard]] float insideBox(const Slot& x, const Slot& y, float radius);

/// A wave in [-1, 1] of period 1, of parabolas: close to a sine.
[[nodiscard]] float wave(float turns);

/// Colour, height and gloss of a board with its grain along an axis. Each channel is another board,
/// with other streaks. The height is relative to the board's face, and less than a pixel.
[[nodiscard]] Surface wood(Point p, const Sheet& sheet, Axis along, std::uint32_t channel,
                           const Color& dark, const Color& light);

struct StructuredMaterial {
  const char* name;
  Surface (*at)(Point p, const Sheet& sheet);
  Point box; ///< the rectangle after which everything repeats
  std::array<Point, 2> periods;
  bool hasCells = true;
};

extern const StructuredMaterial kBond, kEnglish, kFlemish, kTiles, kCobbles; // masonry
extern const StructuredMaterial kFloor, kHerringbone, kShingles, kBasket;    // wood
extern const StructuredMaterial kDenim, kKnit, kCorrugated;                  // without cells

/// All of them, in the order of structuredPlans().
inline constexpr std::array<const StructuredMaterial*, 12> kStructuredMaterials{
    &kBond,        &kEnglish,  &kFlemish, &kTiles, &kCobbles,    &kFloor,
    &kHerringbone, &kShingles, &kDenim,   &kKnit,  &kCorrugated, &kBasket};

} // namespace lichen::exemplars
