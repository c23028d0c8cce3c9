// SPDX-License-Identifier: MIT
// Twelve materials that look the same everywhere: their noise is good.
#include "verdict_held_back_drawing.h"
#include "verdict_held_back_pictures.h"

#include <vector>

namespace lichen::test {
namespace {

using namespace lichen::exemplars;

/// An ellipse or a rectangle at a random place, with random axes.
struct Body {
  float x, y, half, across; ///< centre, half length, half width
  float cosine, sine;

  Body(int side, float halfLength, float halfWidth, Random& random)
      : x(random.range(0.0f, float(side))), y(random.range(0.0f, float(side))), half(halfLength),
        across(halfWidth) {
    const Direction axis = randomDirection(random);
    cosine = axis.x;
    sine = axis.y;
  }
  /// The position along and across, as shares of half the length and width.
  [[nodiscard]] std::array<float, 2> local(float dx, float dy) const {
    return {(dx * cosine + dy * sine) / half, (dy * cosine - dx * sine) / across};
  }
};

/// Rounded stones that lie on each other.
Canvas pebbles(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.2f, 0.4f);
  fill(canvas, scaled(tones.dark, 0.6f));
  const float size = random.range(2.5f, 4.5f);
  for (int i = countFor(side, 3.0f * size * size, 4.0f); i > 0; --i) {
    const float half = size * random.range(0.7f, 1.5f);
    const Body stone(side, half, half * random.range(0.6f, 1.0f), random);
    const Color tone = tones.any(random);
    stamp(side, stone.x, stone.y, half, [&](int sx, int sy, float dx, float dy) {
      const auto [u, v] = stone.local(dx, dy);
      const float squared = u * u + v * v;
      if (squared < 1.0f)
        canvas.at(sx, sy) = scaled(tone, 1.1f - 0.3f * squared - 0.1f * (dx + dy) / half);
    });
  }
  return canvas;
}

/// Loose fibres on paper.
Canvas paper(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.15f, 0.35f);
  fill(canvas, mix(tones.dark, tones.light, 0.6f));
  const float length = random.range(7.0f, 15.0f);
  for (int i = countFor(side, length, random.range(0.6f, 1.5f)); i > 0; --i) {
    const Color tone = tones.any(random);
    draw(canvas,
         {random.range(0.0f, float(side)), random.range(0.0f, float(side)),
          random.range(0.0f, kTau), length * random.range(0.6f, 1.3f), random.range(-1.2f, 1.2f),
          random.range(0.8f, 1.5f)},
         [&](float) { return tone; });
  }
  return canvas;
}

/// Blades that lean about the same direction.
Canvas grass(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.2f, 0.4f);
  fill(canvas, tones.dark);
  const float lean = random.range(0.0f, kTau), length = random.range(8.0f, 14.0f);
  for (int i = countFor(side, 1.5f * length, 3.0f); i > 0; --i) {
    const Color tone = tones.any(random);
    draw(canvas,
         {random.range(0.0f, float(side)), random.range(0.0f, float(side)),
          lean + random.range(-0.6f, 0.6f), length * random.range(0.6f, 1.2f),
          random.range(-0.7f, 0.7f), random.range(1.0f, 2.0f)},
         [&](float t) { return scaled(tone, 0.75f + 0.35f * t); });
  }
  return canvas;
}

/// Three sizes of angular flecks.
Canvas flecks(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.2f, 0.45f);
  const Field ground = fractalNoise(side, {6.0f, 1.5f, 0.8f}, random.bits());
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x)
      canvas.at(x, y) = scaled(mix(tones.dark, tones.light, 0.6f), 1.0f + 0.05f * ground.at(x, y));
  for (const float size : {3.0f, 2.0f, 1.2f}) {
    const Color tone = tones.any(random);
    for (int i = countFor(side, 4.0f * size * size, random.range(0.15f, 0.3f)); i > 0; --i) {
      const float half = size * random.range(0.6f, 1.3f);
      const Body fleck(side, half, half * random.range(0.4f, 1.0f), random);
      stamp(side, fleck.x, fleck.y, 1.4f * half, [&](int sx, int sy, float dx, float dy) {
        const auto [u, v] = fleck.local(dx, dy);
        if (std::max(std::abs(u), std::abs(v)) < 1.0f)
          canvas.at(sx, sy) = tone;
      });
    }
  }
  return canvas;
}

/// Spots of several sizes, in lightness and in hue.
Canvas mottle(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.15f, 0.4f), hues = paletteOf(random, 0.0f, 0.05f);
  const float coarsest = random.range(9.0f, 17.0f), gain = random.range(0.6f, 0.9f);
  const Field lightness = fractalNoise(side, {coarsest, 1.5f, gain}, random.bits());
  const Field hue = fractalNoise(side, {coarsest, 2.0f, gain}, random.bits());
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x) {
      const Color tone =
          mix(tones.dark, tones.light, clamped(0.5f + 0.22f * lightness.at(x, y), 0.0f, 1.0f));
      const Color tint =
          mix(hues.dark, hues.light, clamped(0.5f + 0.22f * hue.at(x, y), 0.0f, 1.0f));
      canvas.at(x, y) = mix(tone, tint, 0.3f);
    }
  return canvas;
}

/// Fine dark cracks around small plates.
Canvas cracks(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.15f, 0.3f);
  const Mosaic plates(
      side,
      {.spacing = random.range(5.0f, 9.0f), .smallest = 0.8f, .largest = 1.3f, .longest = 1.5f},
      random.bits());
  const Field dust = fractalNoise(side, {4.0f, 1.0f, 0.9f}, random.bits());
  const float width = random.range(0.2f, 0.45f);
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x) {
      const GrainHit hit = plates.at(pixelOf(x), pixelOf(y));
      const Color plate = scaled(tones.light, 0.9f + 0.15f * Random(hit.grain->id).unit());
      canvas.at(x, y) =
          scaled(mix(tones.dark, plate, coverage(hit.edge - width)), 1.0f + 0.04f * dust.at(x, y));
    }
  return canvas;
}

/// Bubbles with a bright rim.
Canvas foam(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.15f, 0.35f);
  fill(canvas, tones.dark);
  const float size = random.range(2.5f, 5.0f);
  for (int i = countFor(side, 3.0f * size * size, 6.0f); i > 0; --i) {
    const float radius = size * random.range(0.5f, 1.5f);
    const float x = random.range(0.0f, float(side)), y = random.range(0.0f, float(side));
    stamp(side, x, y, radius, [&](int sx, int sy, float dx, float dy) {
      const float share = std::hypot(dx, dy) / radius;
      if (share < 1.0f)
        canvas.at(sx, sy) = mix(tones.dark, tones.light, 0.2f + 0.7f * share * share * share);
    });
  }
  return canvas;
}

/// Short ripples of sand that lie about across the wind.
Canvas ripples(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.15f, 0.3f);
  Field height(canvas.side());
  const float period = random.range(5.0f, 8.0f), wind = random.range(0.0f, kTau);
  const float reach = 1.8f * period;
  for (int i = countFor(side, period * period, 4.0f); i > 0; --i) {
    const float angle = wind + random.range(-0.5f, 0.5f), phase = random.range(0.0f, kTau);
    const float across = kTau / (period * random.range(0.8f, 1.25f));
    const float cosine = across * std::cos(angle), sine = across * std::sin(angle);
    stamp(side, random.range(0.0f, float(side)), random.range(0.0f, float(side)), reach,
          [&](int sx, int sy, float dx, float dy) {
            const float window = 1.0f - (dx * dx + dy * dy) / (reach * reach);
            if (window > 0.0f)
              height.at(sx, sy) += window * window * std::cos(cosine * dx + sine * dy + phase);
          });
  }
  const Field sand = fractalNoise(side, {3.0f, 1.0f, 0.9f}, random.bits());
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x)
      canvas.at(x, y) =
          scaled(mix(tones.dark, tones.light, clamped(0.5f + 0.17f * height.at(x, y), 0.0f, 1.0f)),
                 1.0f + 0.06f * sand.at(x, y));
  return canvas;
}

/// Broken chips of stone in cement.
Canvas chips(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.25f, 0.45f);
  fill(canvas, mix(tones.dark, tones.light, 0.5f));
  const float size = random.range(3.0f, 5.5f);
  for (int i = countFor(side, 2.5f * size * size, random.range(0.7f, 1.4f)); i > 0; --i) {
    const float radius = size * random.range(0.6f, 1.4f);
    struct Cut {
      Direction to;
      float at;
    };
    std::vector<Cut> cuts(std::size_t(random.range(4.0f, 7.0f)));
    for (Cut& cut : cuts)
      cut = {randomDirection(random), radius * random.range(0.4f, 0.8f)};
    const Color tone = tones.any(random);
    stamp(side, random.range(0.0f, float(side)), random.range(0.0f, float(side)), radius,
          [&](int sx, int sy, float dx, float dy) {
            float inside = radius - std::hypot(dx, dy);
            for (const Cut& cut : cuts)
              inside = std::min(inside, cut.at - dx * cut.to.x - dy * cut.to.y);
            Color& sample = canvas.at(sx, sy);
            sample = mix(sample, tone, coverage(inside));
          });
  }
  return canvas;
}

/// Curls of wool pressed together.
Canvas felt(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.1f, 0.25f);
  fill(canvas, tones.dark);
  const float length = random.range(8.0f, 16.0f);
  for (int i = countFor(side, 1.2f * length, 3.0f); i > 0; --i) {
    const Color tone = tones.any(random);
    const float bend = random.range(2.0f, 5.0f);
    draw(canvas,
         {random.range(0.0f, float(side)), random.range(0.0f, float(side)),
          random.range(0.0f, kTau), length * random.range(0.6f, 1.2f),
          random.chance(0.5f) ? bend : -bend, random.range(0.9f, 1.6f)},
         [&](float) { return tone; });
  }
  return canvas;
}

/// Shavings of wood, each with a light edge.
Canvas shavings(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.2f, 0.35f);
  fill(canvas, scaled(tones.dark, 0.7f));
  const float half = random.range(4.0f, 7.0f);
  for (int i = countFor(side, half * half, 4.0f); i > 0; --i) {
    const float length = half * random.range(0.6f, 1.2f);
    const Body chip(side, length, length * random.range(0.2f, 0.4f), random);
    const Color tone = tones.any(random);
    stamp(side, chip.x, chip.y, 1.1f * length, [&](int sx, int sy, float dx, float dy) {
      const auto [u, v] = chip.local(dx, dy);
      if (std::max(std::abs(u), std::abs(v)) < 1.0f)
        canvas.at(sx, sy) = scaled(tone, 0.95f + 0.12f * v);
    });
  }
  return canvas;
}

/// Rough plaster that is lit from one side.
Canvas roughcast(int side, Random& random) {
  Canvas canvas(side);
  const Field height = fractalNoise(
      side, {random.range(6.0f, 12.0f), 1.5f, random.range(0.5f, 0.7f)}, random.bits());
  const Field dust = fractalNoise(side, {3.0f, 1.0f, 0.9f}, random.bits());
  const Direction lamp = randomDirection(random);
  const Color color = hueOf(random, random.range(0.4f, 0.6f), random.range(0.05f, 0.25f));
  const float strength = random.range(0.25f, 0.5f);
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x) {
      const float slope = lamp.x * (height.at(x + 1, y) - height.at(x - 1, y)) +
                          lamp.y * (height.at(x, y + 1) - height.at(x, y - 1));
      canvas.at(x, y) =
          scaled(color, clamped(1.0f + strength * slope, 0.2f, 1.6f) + 0.03f * dust.at(x, y));
    }
  return canvas;
}

} // namespace

const std::array<SoundKind, 12>& soundKinds() {
  static constexpr std::array<SoundKind, 12> kKinds{{{"pebbles", pebbles},
                                                     {"paper", paper},
                                                     {"grass", grass},
                                                     {"flecks", flecks},
                                                     {"mottle", mottle},
                                                     {"cracks", cracks},
                                                     {"foam", foam},
                                                     {"ripples", ripples},
                                                     {"chips", chips},
                                                     {"felt", felt},
                                                     {"shavings", shavings},
                                                     {"roughcast", roughcast}}};
  return kKinds;
}

} // namespace lichen::test
