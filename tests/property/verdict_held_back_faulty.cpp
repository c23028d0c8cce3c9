// SPDX-License-Identifier: MIT
// Sixteen kinds of pictures whose noise shows a fault.
#include "verdict_held_back_drawing.h"
#include "verdict_held_back_pictures.h"

#include <limits>
#include <vector>

namespace lichen::test {
namespace {

using namespace lichen::exemplars;

/// Paints a plane that the camera sees a little rotated. colorAt(x, y) is the colour at a position
/// of the plane, in pixels; fine grain of 3 to 6 % covers it.
template <typename ColorAt>
SrgbImage paintedPlane(int side, float mostRotation, Random& random, const ColorAt& colorAt) {
  const float angle = random.range(-mostRotation, mostRotation);
  const float cosine = std::cos(angle), sine = std::sin(angle);
  const float x0 = random.range(0.0f, 1000.0f), y0 = random.range(0.0f, 1000.0f);
  const float strength = random.range(0.03f, 0.06f);
  const Field grain = fractalNoise(side, {random.range(3.0f, 6.0f), 1.0f, 0.8f}, random.bits());
  return painted(side, [&](int sx, int sy) {
    const float x = pixelOf(sx), y = pixelOf(sy);
    return scaled(colorAt(x0 + x * cosine - y * sine, y0 + x * sine + y * cosine),
                  1.0f + strength * grain.at(sx, sy));
  });
}
constexpr float kWall = 0.08f; // radians: the camera is held almost upright
constexpr float kAnyRotation = 0.5f * kTau;

/// The place of a value in a row of cells: the cell, and the distance from its start.
struct Cell {
  int index;
  float at;
};
Cell cellOf(float value, float pitch) {
  const float index = std::floor(value / pitch);
  return {int(index), value - index * pitch};
}

/// Hexagonal tiles with joints.
SrgbImage hexagons(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.25f, 0.45f);
  const float pitch = random.range(16.0f, 32.0f), joint = random.range(0.7f, 1.4f);
  const float spread = random.range(0.02f, 0.15f);
  const std::uint32_t seed = random.bits();
  return paintedPlane(side, kWall, random, [&](float x, float y) {
    const float rise = pitch * std::sqrt(0.75f);
    float first = std::numeric_limits<float>::max(), second = first;
    int column = 0, line = 0;
    const int row = int(std::floor(y / rise));
    for (int j = row - 1; j <= row + 2; ++j) {
      const float shift = (j & 1) != 0 ? 0.5f * pitch : 0.0f;
      const int middle = int(std::floor((x - shift) / pitch));
      for (int i = middle - 1; i <= middle + 2; ++i) {
        const float away = std::hypot(x - shift - float(i) * pitch, y - float(j) * rise);
        second = std::min(second, std::max(first, away));
        if (away < first) {
          first = away;
          column = i;
          line = j;
        }
      }
    }
    const Color tile = scaled(tones.light, 1.0f + spread * (hashed(column, line, seed) - 0.5f));
    return mix(tones.dark, tile, coverage(0.5f * (second - first) - joint));
  });
}

/// Parquet of blocks, two of which fit across one, alternately along and across.
SrgbImage herringbone(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.2f, 0.4f);
  const float width = random.range(9.0f, 16.0f);
  const std::uint32_t seed = random.bits();
  return paintedPlane(side, kAnyRotation, random, [&](float x, float y) {
    const auto [i, atX] = cellOf(x, width);
    const auto [j, atY] = cellOf(y, width);
    const int phase = ((i - j) % 4 + 4) % 4;
    const bool along = phase < 2;
    const int startX = phase == 1 ? i - 1 : i, startY = phase == 2 ? j - 1 : j;
    const float u = x - float(startX) * width, v = y - float(startY) * width;
    const float length = along ? 2.0f * width : width, depth = along ? width : 2.0f * width;
    const float inside = std::min({u, length - u, v, depth - v});
    const float tone = (along ? 0.55f : 0.9f) + 0.2f * (hashed(startX, startY, seed) - 0.5f);
    return mix(scaled(tones.dark, 0.7f), mix(tones.dark, tones.light, tone),
               coverage(inside - 0.6f));
  });
}

/// A roof of rounded shingles.
SrgbImage shingles(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.25f, 0.4f);
  const float pitch = random.range(16.0f, 28.0f), rise = 0.5f * pitch;
  const std::uint32_t seed = random.bits();
  return paintedPlane(side, kWall, random, [&](float x, float y) {
    const float radius = 0.56f * pitch;
    const int row = int(std::floor(y / rise));
    for (int j = row - 3; j <= row; ++j) { // an upper row covers the lower ones
      const auto [i, at] = cellOf(x - ((j & 1) != 0 ? 0.5f * pitch : 0.0f), pitch);
      const float inside = radius - std::hypot(at - 0.5f * pitch, y - float(j) * rise);
      if (inside <= 0.0f)
        continue;
      const Color shingle = scaled(tones.light, 0.9f + 0.2f * hashed(i, j, seed));
      return mix(tones.dark, shingle, smoothStep(0.0f, 0.3f * radius, inside));
    }
    return tones.dark;
  });
}

/// Tartan: the same bands along and across.
SrgbImage tartan(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.3f, 0.45f);
  std::vector<Color> threads;
  for (int band = 0; band < 5; ++band) {
    const Color color = band % 2 == 0 ? tones.dark : hueOf(random, random.range(0.4f, 0.7f), 0.4f);
    threads.insert(threads.end(), std::size_t(random.range(3.0f, 11.0f)), color);
  }
  const auto threadAt = [&](float at) {
    return threads[std::size_t(cellOf(at, float(threads.size())).at) % threads.size()];
  };
  return paintedPlane(side, kAnyRotation, random,
                      [&](float x, float y) { return mix(threadAt(x), threadAt(y), 0.5f); });
}

/// Dots in a square grid.
SrgbImage dots(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.25f, 0.45f);
  const float pitch = random.range(14.0f, 28.0f), radius = pitch * random.range(0.2f, 0.35f);
  const bool light = random.chance(0.5f);
  return paintedPlane(side, kAnyRotation, random, [&](float x, float y) {
    const float away =
        std::hypot(cellOf(x, pitch).at - 0.5f * pitch, cellOf(y, pitch).at - 0.5f * pitch);
    const float inside = coverage(radius - away);
    return mix(tones.dark, tones.light, light ? inside : 1.0f - inside);
  });
}

/// Squares of three slats, alternately along and across.
SrgbImage basket(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.25f, 0.45f);
  const float pitch = random.range(14.0f, 26.0f);
  const std::uint32_t seed = random.bits();
  return paintedPlane(side, kWall, random, [&](float x, float y) {
    const auto [i, atX] = cellOf(x, pitch);
    const auto [j, atY] = cellOf(y, pitch);
    const bool along = ((i + j) & 1) == 0;
    const auto [slat, across] = cellOf(along ? atY : atX, pitch / 3.0f);
    const float t = 6.0f * across / pitch - 1.0f; // from -1 to 1 across a slat
    const float tone = (1.0f - t * t) * (0.85f + 0.3f * (hashed(3 * i + slat, j, seed) - 0.5f));
    return mix(tones.dark, tones.light, along ? tone : 0.8f * tone);
  });
}

/// A fence of crossed wires in front of a dark ground.
SrgbImage fence(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.3f, 0.45f);
  const float pitch = random.range(16.0f, 30.0f), half = random.range(1.0f, 1.8f);
  return paintedPlane(side, kWall, random, [&](float x, float y) {
    const auto wireAt = [&](float at) {
      return half - std::abs(cellOf(at, pitch).at - 0.5f * pitch);
    };
    const float wire = std::max(wireAt(0.75f * x + 0.6f * y), wireAt(0.75f * x - 0.6f * y));
    return mix(tones.dark, tones.light, coverage(wire));
  });
}

/// Two colours in patches of every size up to the picture's; their power falls with the cube of the
/// frequency.
SrgbImage patches(int side, Random& random) {
  struct Wave {
    float x, y, phase, amplitude;
  };
  constexpr int kWaves = 150;
  std::vector<Wave> waves;
  float power = 0.0f;
  for (int i = 0; i < kWaves; ++i) {
    const float cycles = 0.7f * std::pow(2.0f, random.range(0.0f, 5.0f)); // per side
    const Direction to = randomDirection(random);
    const float perPixel = kTau * cycles / float(side);
    waves.push_back(
        {to.x * perPixel, to.y * perPixel, random.range(0.0f, kTau), 1.0f / std::sqrt(cycles)});
    power += 0.5f / cycles;
  }
  Field field(side * kSamplesPerPixel);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      float sum = 0.0f;
      for (const Wave& wave : waves)
        sum += wave.amplitude * std::cos(wave.x * float(x) + wave.y * float(y) + wave.phase);
      for (int k = 0; k < kSamplesPerPixel * kSamplesPerPixel; ++k)
        field.at(kSamplesPerPixel * x + k % 2, kSamplesPerPixel * y + k / 2) =
            sum / std::sqrt(power);
    }
  const Color first = hueOf(random, random.range(0.25f, 0.4f), 0.5f);
  const Color second = hueOf(random, random.range(0.5f, 0.65f), 0.5f);
  const Field grain = fractalNoise(side, {4.0f, 1.0f, 0.8f}, random.bits());
  return painted(side, [&](int sx, int sy) {
    return scaled(mix(first, second, smoothStep(-1.5f, 1.5f, field.at(sx, sy))),
                  1.0f + 0.06f * grain.at(sx, sy));
  });
}

SrgbImage anyMaterial(int side, Random& random) {
  const SoundKind& kind = soundKinds()[random.bits() % soundKinds().size()];
  return photographed(kind.draw, side, Condition::cropped, random);
}

/// Multiplies the codes of all channels.
void scale(SrgbImage& image, const std::array<float, 3>& factors) {
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = std::min(1.0f, factors[i % 3] * image.values[i]);
}

/// Two materials meet along a wavy line.
SrgbImage twoZones(int side, Random& random) {
  SrgbImage image = anyMaterial(side, random), other = anyMaterial(side, random);
  scale(image, {0.65f, 0.7f, 0.8f});
  scale(other, {1.4f, 1.25f, 1.1f});
  const Direction to = randomDirection(random);
  const float at = float(side) * random.range(-0.1f, 0.1f), wave = random.range(2.0f, 6.0f);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float dx = float(x) - 0.5f * float(side), dy = float(y) - 0.5f * float(side);
      const float along = to.x * dy - to.y * dx;
      if (to.x * dx + to.y * dy > at + wave * std::sin(along / 12.0f))
        std::copy_n(other.pixel(x, y), 3, image.pixel(x, y));
    }
  return image;
}

/// A round lid with rings that covers half of the picture.
SrgbImage lid(int side, Random& random) {
  SrgbImage image = anyMaterial(side, random);
  const float radius = float(side) * random.range(0.36f, 0.42f);
  const float x0 = float(side) * random.range(0.45f, 0.55f);
  const float y0 = float(side) * random.range(0.45f, 0.55f), ring = random.range(8.0f, 16.0f);
  const float level = random.chance(0.5f) ? random.range(0.15f, 0.25f) : random.range(0.7f, 0.85f);
  const Color metal = hueOf(random, level, 0.3f);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float away = std::hypot(float(x) - x0, float(y) - y0);
      if (away > radius)
        continue;
      const float tone = 1.0f + 0.12f * std::sin(kTau * away / ring);
      const std::array<float, 3> codes{metal.r, metal.g, metal.b};
      for (std::size_t c = 0; c < 3; ++c)
        image.pixel(x, y)[c] =
            std::round(255.0f * std::clamp(tone * codes[c], 0.0f, 1.0f)) / 255.0f;
    }
  return image;
}

/// Stretches the codes so that `share` of the pixels are 0 in all channels.
SrgbImage withBlack(SrgbImage image, float share) {
  std::vector<float> most;
  for (std::size_t i = 0; i < image.values.size(); i += 3)
    most.push_back(std::max({image.values[i], image.values[i + 1], image.values[i + 2]}));
  const auto place = most.begin() + std::ptrdiff_t(share * float(most.size()));
  std::nth_element(most.begin(), place, most.end());
  for (float& value : image.values)
    value = std::round(255.0f * std::clamp(1.5f * (value - *place), 0.0f, 1.0f)) / 255.0f;
  return image;
}

/// 30 to 45 % of the pixels are black.
SrgbImage underexposed(int side, Random& random) {
  return withBlack(anyMaterial(side, random), random.range(0.3f, 0.45f));
}

/// 30 to 45 % of the pixels are white.
SrgbImage overexposed(int side, Random& random) {
  SrgbImage image = anyMaterial(side, random);
  for (float& value : image.values)
    value = 1.0f - value;
  image = withBlack(std::move(image), random.range(0.3f, 0.45f));
  for (float& value : image.values)
    value = 1.0f - value;
  return image;
}

/// Lines of capital letters.
SrgbImage writing(int side, Random& random) {
  // Letters of 3 x 5 squares, from the upper left: A C E F H I L N O P T U
  constexpr std::array<std::uint32_t, 12> kLetters{
      0b010101111101101, 0b011100100100011, 0b111100110100111, 0b111100110100100,
      0b101101111101101, 0b111010010010111, 0b100100100100111, 0b101111111111101,
      0b111101101101111, 0b110101110100100, 0b111010010010010, 0b101101101101111};
  const Palette tones = paletteOf(random, 0.35f, 0.5f);
  const float square = random.range(1.6f, 2.8f), line = square * random.range(7.0f, 9.0f);
  const std::uint32_t seed = random.bits();
  return paintedPlane(side, kWall, random, [&](float x, float y) {
    const auto [row, down] = cellOf(y, line);
    const auto [letter, across] = cellOf(x + 100.0f * hashed(row, 0, seed), 4.0f * square);
    const int i = int(across / square), j = int(down / square);
    if (i >= 3 || j >= 5 || hashed(letter, row, seed) < 0.15f) // a space between words
      return tones.light;
    const std::uint32_t shape = kLetters[std::size_t(12.0f * hashed(letter, row, seed + 1))];
    return (shape >> unsigned(14 - 3 * j - i) & 1u) != 0 ? tones.dark : tones.light;
  });
}

/// The inverse of the square by which Canvas::resolve() approximates the sRGB curve, in 8 bits.
float codeOf(float light) {
  return std::round(255.0f * std::sqrt(std::clamp(light, 0.0f, 1.0f))) / 255.0f;
}

/// Any material on level ground, photographed at 52 to 66 degrees from straight down, with any side
/// of the picture up: what is nearest is 2.3 to 5.4 times as wide as what is farthest, in the middle of the picture.
SrgbImage slantedGround(int side, Random& random) {
  constexpr float kHalfView = 0.306f; // tangent of 17 degrees, from the middle to a side
  constexpr float kMagnified = 2.0f;  // pixels per pixel of the material, where that is nearest
  constexpr int kSamples = 10; // per pixel along each axis; the farthest pixels see much ground
  const SoundKind& kind = soundKinds()[random.bits() % soundKinds().size()];
  Canvas ground = kind.draw(2 * side, random); // repeats
  const float tilt = random.range(52.0f, 66.0f) * kTau / 360.0f;
  const float roll =
      0.25f * kTau * std::floor(random.range(0.0f, 4.0f)) + random.range(-0.2f, 0.2f);
  const float cosine = std::cos(roll), sine = std::sin(roll);
  const float down = std::cos(tilt), ahead = std::sin(tilt);
  const float perPixel = 2.0f * kHalfView / float(side);
  const float height = (down + kHalfView * ahead) / (perPixel * kMagnified);
  const auto sampleAt = [&](float x, float y) -> const Color& {
    const auto wrapped = [&](float pixels) {
      const int sample = int(std::floor(pixels * float(kSamplesPerPixel))) % ground.side();
      return sample < 0 ? sample + ground.side() : sample;
    };
    return ground.at(wrapped(x), wrapped(y));
  };
  SrgbImage image(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      std::array<float, 3> light{};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const float dx = float(x) + (float(k % kSamples) + 0.5f) / float(kSamples);
        const float dy = float(y) + (float(k / kSamples) + 0.5f) / float(kSamples);
        const float right = perPixel * dx - kHalfView, below = perPixel * dy - kHalfView;
        const float u = right * cosine - below * sine, v = right * sine + below * cosine;
        const float reach = height / (down - v * ahead);
        const Color& seen = sampleAt(reach * u, reach * (ahead + v * down));
        light[0] += seen.r * seen.r;
        light[1] += seen.g * seen.g;
        light[2] += seen.b * seen.b;
      }
      for (std::size_t c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = codeOf(light[c] / float(kSamples * kSamples));
    }
  return image;
}

/// Any material that is sharp in a band or in a disc, anywhere in the picture, whose half width is
/// 10 to 20 % of the side. Elsewhere the lens spreads each point over a disc. Its radius grows with
/// the distance, to 3 to 5 % of the side at half a side from there.
SrgbImage partlyBlurred(int side, Random& random) {
  const float most = float(side) * random.range(0.03f, 0.05f);
  const float sharpHalf = float(side) * random.range(0.1f, 0.2f);
  const float x0 = float(side) * random.range(0.1f, 0.9f);
  const float y0 = float(side) * random.range(0.1f, 0.9f);
  const Direction across = randomDirection(random);
  const bool isBand = random.chance(0.5f);
  const int spare = int(std::ceil(most)) + 1;
  const SrgbImage sharp = anyMaterial(side + 2 * spare, random);
  SrgbImage image(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float dx = float(x) - x0, dy = float(y) - y0;
      const float away = isBand ? std::abs(dx * across.x + dy * across.y) : std::hypot(dx, dy);
      const float radius = most * std::clamp(2.0f * (away - sharpHalf) / float(side), 0.0f, 1.0f);
      const int reach = int(std::ceil(radius));
      std::array<float, 3> light{};
      float sum = 0.0f;
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
          const float weight = coverage(radius + 0.5f - std::hypot(float(i), float(j)));
          sum += weight;
          const float* const from = sharp.pixel(x + spare + i, y + spare + j);
          for (std::size_t c = 0; c < 3; ++c)
            light[c] += weight * from[c] * from[c];
        }
      for (std::size_t c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = codeOf(light[c] / sum);
    }
  return image;
}

/// Boards of different widths from one side of the picture to the other.
SrgbImage boards(int side, Random& random) {
  const Palette tones = paletteOf(random, 0.2f, 0.4f);
  const float pitch = random.range(20.0f, 36.0f);
  const std::uint32_t seed = random.bits();
  const Field fibre = fractalNoise(side, {6.0f, 1.5f, 0.8f}, random.bits());
  return paintedPlane(side, kAnyRotation, random, [&](float x, float y) {
    const auto edgeOf = [&](int board) {
      return pitch * (float(board) + 0.5f * (hashed(board, 0, seed) - 0.5f));
    };
    int board = cellOf(y, pitch).index;
    board += y >= edgeOf(board + 1) ? 1 : y < edgeOf(board) ? -1 : 0;
    const float inside = std::min(y - edgeOf(board), edgeOf(board + 1) - y);
    const Color wood = scaled(mix(tones.dark, tones.light, hashed(board, 1, seed)),
                              1.0f + 0.06f * fibre.atPixel(0.06f * x + 50.0f * float(board), y));
    return mix(scaled(tones.dark, 0.4f), wood, coverage(inside - 0.7f));
  });
}

} // namespace

const std::array<FaultyKind, 16>& faultyKinds() {
  static constexpr std::array<FaultyKind, 16> kKinds{{{"hexagons", hexagons},
                                                      {"herringbone", herringbone},
                                                      {"shingles", shingles},
                                                      {"tartan", tartan},
                                                      {"dots", dots},
                                                      {"basket", basket},
                                                      {"fence", fence},
                                                      {"patches", patches},
                                                      {"two zones", twoZones},
                                                      {"lid", lid},
                                                      {"underexposed", underexposed},
                                                      {"overexposed", overexposed},
                                                      {"writing", writing},
                                                      {"slanted ground", slantedGround},
                                                      {"partly blurred", partlyBlurred},
                                                      {"boards", boards}}};
  return kKinds;
}

} // namespace lichen::test
