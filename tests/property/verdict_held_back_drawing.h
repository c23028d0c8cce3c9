// SPDX-License-Identifier: MIT
// Palettes, stamps and strokes for the pictures of verdict_held_back_pictures.h.
//
// Lengths are in pixels, colours in sRGB code values. Literals are art direction.
#pragma once

#include <lichen/image.h>
#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <periodic.h>

namespace lichen::test {

using exemplars::Canvas;
using exemplars::Color;
using exemplars::Field;
using exemplars::Random;

inline constexpr float kTau = 6.2831853f;

/// A colour of this luminance, about, with a random hue.
inline Color hueOf(Random& random, float level, float saturation) {
  const float r = random.range(-0.5f, 0.5f), g = random.range(-0.5f, 0.5f);
  const float b = random.range(-0.5f, 0.5f), grey = 0.3f * r + 0.6f * g + 0.1f * b;
  return {level + saturation * (r - grey), level + saturation * (g - grey),
          level + saturation * (b - grey)};
}

struct Palette {
  Color dark, light;

  /// A colour between both, at random.
  [[nodiscard]] Color any(Random& random) const {
    return exemplars::mix(dark, light, random.unit());
  }
};

/// Two colours whose levels differ by a random contrast, from `least` to `most`.
inline Palette paletteOf(Random& random, float least, float most) {
  const float middle = random.range(0.4f, 0.52f), half = 0.5f * random.range(least, most);
  const float saturation = random.range(0.05f, 0.3f);
  return {hueOf(random, middle - half, saturation), hueOf(random, middle + half, saturation)};
}

/// A number in [0, 1) that belongs to a pair of integers.
inline float hashed(int i, int j, std::uint32_t seed) {
  return float(pcg3d({std::uint32_t(i), std::uint32_t(j), seed})[0] >> 8u) * 0x1p-24f;
}

/// 1 inside a shape, 0 outside, with a soft edge of a pixel. `inside` is the distance to the edge.
inline float coverage(float inside) { return exemplars::smoothStep(-0.5f, 0.5f, inside); }

/// The number of shapes with this mean area that cover a square `times` over.
inline int countFor(int sidePixels, float area, float times) {
  return int(times * float(sidePixels) * float(sidePixels) / area);
}

/// Calls paint(sampleX, sampleY, dx, dy) for all samples within `reach` of (x, y) along both axes.
/// dx and dy are the sample's offset from (x, y). Samples wrap at the borders.
template <typename Paint>
void stamp(int sidePixels, float x, float y, float reach, const Paint& paint) {
  const int samples = sidePixels * exemplars::kSamplesPerPixel;
  const auto sampleOf = [](float pixels) {
    return int(std::floor(pixels * float(exemplars::kSamplesPerPixel)));
  };
  for (int j = sampleOf(y - reach); j <= sampleOf(y + reach); ++j)
    for (int i = sampleOf(x - reach); i <= sampleOf(x + reach); ++i)
      paint((i % samples + samples) % samples, (j % samples + samples) % samples,
            exemplars::pixelOf(i) - x, exemplars::pixelOf(j) - y);
}

/// A stroke of constant width along an arc.
struct Stroke {
  float x = 0.0f, y = 0.0f;
  float angle = 0.0f; ///< of its start
  float length = 0.0f;
  float bend = 0.0f; ///< by how much its angle changes from end to end
  float width = 1.0f;
};

/// Draws the stroke; colorAt(t) is its colour at the share t of its length.
template <typename ColorAt>
void draw(Canvas& canvas, const Stroke& stroke, const ColorAt& colorAt) {
  constexpr float kStep = 0.5f;
  const int side = canvas.side() / exemplars::kSamplesPerPixel;
  const float radius = 0.5f * stroke.width;
  float x = stroke.x, y = stroke.y;
  for (float along = 0.0f; along <= stroke.length; along += kStep) {
    const float t = along / stroke.length, angle = stroke.angle + stroke.bend * t;
    const Color color = colorAt(t);
    stamp(side, x, y, radius + 0.5f, [&](int sx, int sy, float dx, float dy) {
      Color& sample = canvas.at(sx, sy);
      sample = exemplars::mix(sample, color, coverage(radius - std::hypot(dx, dy)));
    });
    x += kStep * std::cos(angle);
    y += kStep * std::sin(angle);
  }
}

inline void fill(Canvas& canvas, const Color& color) {
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x)
      canvas.at(x, y) = color;
}

} // namespace lichen::test
