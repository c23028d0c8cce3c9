// SPDX-License-Identifier: MIT
// Ten materials without a structure. Their features are larger than in the pictures for the
// verdict: up to a third of the side.
#include "quilting_held_back_pictures.h"
#include "verdict_held_back_drawing.h"
#include "verdict_held_back_pictures.h"

#include <array>

namespace lichen::test {
namespace {

using namespace lichen::exemplars;

template <typename ColorAt>
Canvas colored(int side, const ColorAt& colorAt) {
  Canvas canvas(side);
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x)
      canvas.at(x, y) = colorAt(x, y);
  return canvas;
}

Stroke strokeAnywhere(int side, float angle, float length, float bend, float width,
                      Random& random) {
  return {
      random.range(0.0f, float(side)), random.range(0.0f, float(side)), angle, length, bend, width};
}

/// Stones side by side, of very different sizes.
Canvas gravel(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.2f, 0.4f);
  const Mosaic stones(
      side,
      {.spacing = random.range(8.0f, 18.0f), .smallest = 0.5f, .largest = 1.8f, .longest = 2.0f},
      random.bits());
  const Field grain = fractalNoise(side, {5.0f, 1.0f, 0.8f}, random.bits());
  const float gap = random.range(0.3f, 1.0f);
  return colored(side, [&](int x, int y) {
    const GrainHit hit = stones.at(pixelOf(x), pixelOf(y));
    Random own(hit.grain->id);
    const float round = smoothStep(gap, gap + 3.0f, hit.edge);
    const float lit = 0.55f + 0.4f * round - 0.012f * (hit.along + hit.across);
    return scaled(tones.any(own), lit * (1.0f + 0.06f * grain.at(x, y)));
  });
}

/// Plaster spread by short arcs of a trowel.
Canvas stucco(int side, Random& random) {
  Relief relief(side);
  const Color color = hueOf(random, random.range(0.5f, 0.7f), random.range(0.05f, 0.2f));
  const Field grain = fractalNoise(side, {4.0f, 1.0f, 0.8f}, random.bits());
  const float width = random.range(5.0f, 9.0f);
  for (int i = countFor(side, 4.0f * width * width, 6.0f); i > 0; --i) {
    const float half = width * random.range(0.6f, 1.2f), level = random.range(0.0f, 2.0f);
    const float angle = random.range(0.0f, kTau), bend = random.range(-0.05f, 0.05f);
    const float cosine = std::cos(angle), sine = std::sin(angle), halfLength = 2.2f * half;
    stamp(side, random.range(0.0f, float(side)), random.range(0.0f, float(side)), halfLength,
          [&](int sx, int sy, float dx, float dy) {
            const float along = dx * cosine + dy * sine;
            const float across = dy * cosine - dx * sine - bend * along * along;
            const float inside =
                1.0f - along * along / (halfLength * halfLength) - across * across / (half * half);
            if (inside > 0.0f) {
              float& height = relief.height.at(sx, sy);
              height += smoothStep(0.0f, 0.25f, inside) * (level + 0.12f * across - height);
            }
          });
  }
  for (int y = 0; y < relief.canvas.side(); ++y)
    for (int x = 0; x < relief.canvas.side(); ++x) {
      relief.canvas.at(x, y) = scaled(color, 1.0f + 0.025f * grain.at(x, y));
      relief.height.at(x, y) += 0.05f * grain.at(x, y);
    }
  light(relief, {.slope = random.range(0.4f, 0.8f), .hollow = 0.1f});
  return std::move(relief.canvas);
}

/// Long plates with deep cracks between.
Canvas bark(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.15f, 0.3f);
  Field plates(side * kSamplesPerPixel);
  const float longest = random.range(16.0f, 30.0f), trunk = random.range(0.0f, kTau);
  for (const float share : {1.0f, 0.6f, 0.36f}) {
    const float half = share * longest, width = 0.28f * half, level = std::sqrt(share);
    for (int i = countFor(side, 4.0f * half * width, 5.0f); i > 0; --i) {
      const float angle = trunk + random.range(-0.2f, 0.2f),
                  rise = level * random.range(-1.0f, 1.0f);
      const float cosine = std::cos(angle), sine = std::sin(angle);
      stamp(side, random.range(0.0f, float(side)), random.range(0.0f, float(side)), half,
            [&](int sx, int sy, float dx, float dy) {
              const float along = (dx * cosine + dy * sine) / half;
              const float across = (dy * cosine - dx * sine) / width;
              const float inside = 1.0f - along * along - across * across;
              if (inside > 0.0f)
                plates.at(sx, sy) += rise * smoothStep(0.0f, 0.6f, inside);
            });
    }
  }
  const Field fine = fractalNoise(side, {6.0f, 1.0f, 0.8f}, random.bits());
  return colored(side, [&](int x, int y) {
    const float value = plates.at(x, y) + 0.15f * fine.at(x, y);
    const float crack = 1.0f - smoothStep(0.0f, 0.45f, std::abs(value + 0.4f));
    const float tone = clamped(0.5f + 0.25f * value + 0.1f * fine.at(y, x), 0.0f, 1.0f);
    return scaled(mix(tones.dark, tones.light, tone), 1.0f - 0.6f * crack);
  });
}

/// Long fibres of several colours.
Canvas matted(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.15f, 0.35f);
  fill(canvas, tones.dark);
  const float length = random.range(18.0f, 34.0f);
  for (int i = countFor(side, 1.3f * length, 3.0f); i > 0; --i) {
    const Color tone = tones.any(random);
    draw(canvas,
         strokeAnywhere(side, random.range(0.0f, kTau), length * random.range(0.5f, 1.3f),
                        random.range(-4.0f, 4.0f), random.range(0.9f, 1.7f), random),
         [&](float) { return tone; });
  }
  return canvas;
}

/// Tufts of blades that spread from a point.
Canvas lawn(int side, Random& random) {
  Canvas canvas(side);
  const float level = random.range(0.35f, 0.5f);
  const Color dark{0.35f * level, 0.5f * level, 0.2f * level};
  const Color pale{0.9f * level, 1.15f * level, 0.5f * level};
  fill(canvas, scaled(dark, 0.6f));
  const float length = random.range(12.0f, 22.0f);
  for (int i = countFor(side, 12.0f * length, 4.0f); i > 0; --i) {
    const float x = random.range(0.0f, float(side)), y = random.range(0.0f, float(side));
    for (int blade = 0; blade < 6; ++blade) {
      const Color tone = mix(dark, pale, random.unit());
      draw(canvas,
           {x, y, random.range(0.0f, kTau), length * random.range(0.5f, 1.0f),
            random.range(-1.0f, 1.0f), random.range(1.0f, 2.2f)},
           [&](float t) { return scaled(tone, 0.6f + 0.5f * t); });
    }
  }
  return canvas;
}

/// Clouds with thin bent veins.
Canvas marble(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.12f, 0.3f);
  const Color vein = hueOf(random, random.chance(0.5f) ? 0.2f : 0.8f, 0.1f);
  const float coarsest = random.range(20.0f, 32.0f);
  const Field body = fractalNoise(side, {coarsest, 2.0f, 0.6f}, random.bits());
  const Field across = fractalNoise(side, {coarsest, 4.0f, 0.55f}, random.bits());
  const Field bends = fractalNoise(side, {16.0f, 4.0f, 0.6f}, random.bits());
  const float width = random.range(0.08f, 0.2f);
  return colored(side, [&](int x, int y) {
    const int bent = int(5.0f * bends.at(x, y));
    const float at = std::abs(across.at(x + bent, y - bent)) / width;
    const float line = 0.9f * clamped(0.6f + body.at(y, x), 0.0f, 1.0f) / (1.0f + at * at);
    return mix(mix(tones.dark, tones.light, clamped(0.5f + 0.2f * body.at(x, y), 0.0f, 1.0f)), vein,
               line);
  });
}

/// Polished broken stones of all sizes in cement.
Canvas aggregate(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.25f, 0.45f);
  const Color other = hueOf(random, 0.45f, 0.4f);
  fill(canvas, hueOf(random, random.range(0.4f, 0.65f), 0.05f));
  const float size = random.range(9.0f, 15.0f);
  for (float radius = size; radius > 1.2f; radius *= 0.85f) {
    constexpr std::size_t kCuts = 6;
    for (int i = countFor(side, 2.5f * radius * radius, 0.14f); i > 0; --i) {
      std::array<Direction, kCuts> to;
      std::array<float, kCuts> at{};
      for (std::size_t k = 0; k < kCuts; ++k) {
        to[k] = randomDirection(random);
        at[k] = radius * random.range(0.4f, 0.85f);
      }
      const Color tone = random.chance(0.2f) ? other : tones.any(random);
      stamp(side, random.range(0.0f, float(side)), random.range(0.0f, float(side)), radius,
            [&](int sx, int sy, float dx, float dy) {
              float inside = radius - std::hypot(dx, dy);
              for (std::size_t k = 0; k < kCuts; ++k)
                inside = std::min(inside, at[k] - dx * to[k].x - dy * to[k].y);
              Color& sample = canvas.at(sx, sy);
              sample = mix(sample, scaled(tone, 0.94f + 0.06f * std::min(inside, 2.0f) / 2.0f),
                           coverage(inside));
            });
    }
  }
  return canvas;
}

/// Fallen leaves, several deep, each with a shadow.
Canvas litter(int side, Random& random) {
  Canvas canvas(side);
  fill(canvas, {0.12f, 0.09f, 0.06f});
  const float size = random.range(8.0f, 14.0f), red = random.range(0.0f, 0.25f);
  for (int i = countFor(side, size * size, 5.0f); i > 0; --i) {
    const float half = size * random.range(0.6f, 1.2f), width = half * random.range(0.35f, 0.6f);
    const float angle = random.range(0.0f, kTau), cosine = std::cos(angle), sine = std::sin(angle);
    const float level = random.range(0.35f, 0.7f), green = random.range(0.55f, 0.85f) - red;
    const Color color{level, level * green, level * random.range(0.2f, 0.4f)};
    stamp(side, random.range(0.0f, float(side)), random.range(0.0f, float(side)), half + 2.0f,
          [&](int sx, int sy, float dx, float dy) {
            const float t = (dx * cosine + dy * sine) / half, off = dy * cosine - dx * sine;
            const float inside = width * (1.0f - t * t) - std::abs(off);
            Color& sample = canvas.at(sx, sy);
            sample = scaled(sample, 0.55f + 0.45f * smoothStep(-1.5f, 2.0f, -inside));
            const float vein = std::abs(off) < 0.5f ? 1.25f : 1.0f;
            sample =
                mix(sample, scaled(color, vein * (0.9f + 0.2f * off / width)), coverage(inside));
          });
  }
  return canvas;
}

/// Hair that lies along slowly changing directions.
Canvas fur(int side, Random& random) {
  Canvas canvas(side);
  const Palette tones = paletteOf(random, 0.2f, 0.4f);
  fill(canvas, tones.dark);
  const Field swirl = fractalNoise(side, {60.0f, 20.0f, 0.5f}, random.bits());
  const float lie = random.range(0.0f, kTau), length = random.range(12.0f, 24.0f);
  for (int i = countFor(side, length, 4.0f); i > 0; --i) {
    Stroke hair = strokeAnywhere(side, 0.0f, length * random.range(0.6f, 1.2f),
                                 random.range(-0.4f, 0.4f), random.range(0.7f, 1.4f), random);
    hair.angle = lie + 0.5f * swirl.atPixel(hair.x, hair.y) + random.range(-0.15f, 0.15f);
    const Color tone = tones.any(random);
    draw(canvas, hair, [&](float t) { return scaled(tone, 0.75f + 0.4f * t); });
  }
  return canvas;
}

/// Crusts of three colours with rough outlines over stone.
Canvas crusts(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.25f, 0.45f);
  const Color other = hueOf(random, 0.5f, 0.35f);
  const float coarsest = random.range(16.0f, 28.0f);
  const Field one = fractalNoise(side, {coarsest, 1.5f, 0.6f}, random.bits());
  const Field two = fractalNoise(side, {0.7f * coarsest, 1.5f, 0.6f}, random.bits());
  const Field grain = fractalNoise(side, {3.0f, 1.0f, 0.9f}, random.bits());
  return colored(side, [&](int x, int y) {
    Color color = mix(tones.dark, tones.light, smoothStep(0.1f, 0.25f, one.at(x, y)));
    color = mix(color, other, smoothStep(0.7f, 0.8f, two.at(x, y)));
    return scaled(color, 1.0f + 0.07f * grain.at(x, y));
  });
}

constexpr std::array<SoundKind, 10> kKinds{{{"gravel", gravel},
                                            {"stucco", stucco},
                                            {"bark", bark},
                                            {"matted", matted},
                                            {"lawn", lawn},
                                            {"marble", marble},
                                            {"aggregate", aggregate},
                                            {"litter", litter},
                                            {"fur", fur},
                                            {"crusts", crusts}}};

} // namespace

HeldBackPicture stochasticHeldBack(int index) {
  constexpr std::array<Condition, 7> kConditions{
      Condition::cropped,  Condition::tiles,      Condition::cropped, Condition::vignette,
      Condition::gradient, Condition::compressed, Condition::noisy};
  const SoundKind& kind = kKinds[std::size_t(index) % kKinds.size()];
  const Condition condition = kConditions[std::size_t(index) / kKinds.size() % kConditions.size()];
  Random random(std::uint32_t(20000 + index));
  const int side = int(random.range(float(kSmallestQuiltingSide), float(kLargestQuiltingSide + 1)));
  HeldBackPicture picture;
  picture.name = std::string(kind.name) + ", " + kConditionNames[std::size_t(condition)];
  picture.image = photographed(kind.draw, side, condition, random);
  return picture;
}

} // namespace lichen::test
