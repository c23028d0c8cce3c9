// SPDX-License-Identifier: MIT
// A material -> its photograph, with uneven light, an object, or the traces of a camera.
#include "verdict_held_back_drawing.h"
#include "verdict_held_back_pictures.h"

namespace lichen::test {
namespace {

using namespace lichen::exemplars;

/// Multiplies the linear light of each pixel by factorAt(x, y), with x and y in [-1, 1].
template <typename FactorAt>
void relight(SrgbImage& image, const FactorAt& factorAt) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float factor = factorAt(2.0f * (float(x) + 0.5f) / float(image.width) - 1.0f,
                                    2.0f * (float(y) + 0.5f) / float(image.height) - 1.0f);
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = linearToSrgb(factor * srgbToLinear(image.pixel(x, y)[c]));
    }
}

/// The falloff of a simple lens; corners have 50 to 80 % of the light of the middle.
void addVignette(SrgbImage& image, Random& random) {
  const float corner = random.range(0.5f, 0.8f), gain = 0.5f * (1.0f / std::sqrt(corner) - 1.0f);
  relight(image, [&](float x, float y) {
    const float falloff = 1.0f + gain * (x * x + y * y);
    return 1.0f / (falloff * falloff);
  });
}

/// The dark side has 50 to 80 % of the light of the other.
void addGradient(SrgbImage& image, Random& random) {
  const Direction to = randomDirection(random);
  const float loss = random.range(0.2f, 0.5f), span = std::abs(to.x) + std::abs(to.y);
  relight(image, [&](float x, float y) {
    return 1.0f - 0.5f * loss * (1.0f + (to.x * x + to.y * y) / span);
  });
}

/// 20 to 40 % darker on one side of an edge that is 30 to 60 % of the side wide.
void addShadow(SrgbImage& image, Random& random) {
  const Direction to = randomDirection(random);
  const float loss = random.range(0.2f, 0.4f), at = random.range(-0.3f, 0.3f);
  const float half = random.range(0.3f, 0.6f);
  relight(image, [&](float x, float y) {
    return 1.0f - loss * smoothStep(at - half, at + half, to.x * x + to.y * y);
  });
}

/// Quantizes blocks of 8 x 8 pixels as JPEG does with the tables of its annex K, at a quality of 60
/// to 85; chroma is not subsampled.
void compress(SrgbImage& image, Random& random) {
  constexpr int kBlock = 8;
  constexpr std::array<int, 64> kSteps{
      16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,
      14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,
      18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,
      49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};
  const float scale = 2.0f - 0.02f * random.range(60.0f, 85.0f);
  std::array<std::array<float, kBlock>, kBlock> waves{};
  for (int k = 0; k < kBlock; ++k)
    for (int x = 0; x < kBlock; ++x)
      waves[std::size_t(k)][std::size_t(x)] = (k == 0 ? std::sqrt(0.125f) : 0.5f) *
                                              std::cos(kTau * float(k) * (float(x) + 0.5f) / 16.0f);
  using Block = std::array<std::array<float, kBlock>, kBlock>;
  const auto transformed = [&](const Block& from, bool inverse) {
    Block rows{}, both{};
    for (std::size_t y = 0; y < kBlock; ++y)
      for (std::size_t k = 0; k < kBlock; ++k)
        for (std::size_t x = 0; x < kBlock; ++x)
          rows[y][k] += from[y][x] * (inverse ? waves[x][k] : waves[k][x]);
    for (std::size_t y = 0; y < kBlock; ++y)
      for (std::size_t k = 0; k < kBlock; ++k)
        for (std::size_t x = 0; x < kBlock; ++x)
          both[k][x] += rows[y][x] * (inverse ? waves[y][k] : waves[k][y]);
    return both;
  };
  for (int y0 = 0; y0 < image.height; y0 += kBlock)
    for (int x0 = 0; x0 < image.width; x0 += kBlock)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto pixelAt = [&](std::size_t x, std::size_t y) { // the last one repeats
          return image.pixel(std::min(x0 + int(x), image.width - 1),
                             std::min(y0 + int(y), image.height - 1));
        };
        Block block{};
        for (std::size_t y = 0; y < kBlock; ++y)
          for (std::size_t x = 0; x < kBlock; ++x)
            block[y][x] = 255.0f * pixelAt(x, y)[channel];
        block = transformed(block, false);
        for (std::size_t y = 0; y < kBlock; ++y)
          for (std::size_t x = 0; x < kBlock; ++x) {
            const float step = std::max(1.0f, scale * float(kSteps[kBlock * y + x]));
            block[y][x] = step * std::round(block[y][x] / step);
          }
        block = transformed(block, true);
        for (std::size_t y = 0; y < kBlock; ++y)
          for (std::size_t x = 0; x < kBlock; ++x)
            if (x0 + int(x) < image.width && y0 + int(y) < image.height)
              pixelAt(x, y)[channel] = block[y][x] / 255.0f;
      }
}

/// Noise of a deviation of 1 to 2.5 % of the range.
void addNoise(SrgbImage& image, Random& random) {
  const float deviation = random.range(0.01f, 0.025f);
  for (float& value : image.values) // the sum of three has a deviation of 1/2
    value += 2.0f * deviation * (random.unit() + random.unit() + random.unit() - 1.5f);
}

/// Calls paint(pixel, along, across) for each pixel, with its offset in pixels from the middle of
/// an object at a random place, along and across that.
template <typename Paint>
void addObject(SrgbImage& image, Random& random, const Paint& paint) {
  const float x0 = float(image.width) * random.range(0.25f, 0.75f);
  const float y0 = float(image.height) * random.range(0.25f, 0.75f);
  const Direction axis = randomDirection(random);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float dx = float(x) - x0, dy = float(y) - y0;
      paint(image.pixel(x, y), dx * axis.x + dy * axis.y, dy * axis.x - dx * axis.y);
    }
}

/// A crease: one flank is bright, the other dark.
void addFold(SrgbImage& image, Random& random) {
  const float half = random.range(20.0f, 32.0f), width = random.range(2.0f, 3.5f);
  const float bend = random.range(-0.008f, 0.008f), strength = random.range(0.5f, 0.8f);
  addObject(image, random, [&](float* pixel, float along, float across) {
    const float off = (across - bend * along * along) / width;
    const float fade = 1.0f - smoothStep(0.6f * half, half, std::abs(along));
    const float flank = off * std::exp(0.5f - 0.5f * off * off); // from -1 to 1
    for (int c = 0; c < 3; ++c)
      pixel[c] *= 1.0f + strength * fade * (flank > 0.0f ? 0.5f * flank : flank);
  });
}

/// A dried drop of coffee, darkest at its rim.
void addStain(SrgbImage& image, Random& random) {
  const float radius = random.range(9.0f, 15.0f), strength = random.range(0.35f, 0.55f);
  addObject(image, random, [&](float* pixel, float along, float across) {
    const float share = std::hypot(along, 1.2f * across) / radius;
    const float rim = std::exp(-30.0f * (share - 0.9f) * (share - 0.9f));
    const float wet = strength * (1.0f - smoothStep(0.9f, 1.05f, share)) + 0.2f * rim;
    pixel[0] *= 1.0f - 0.7f * wet;
    pixel[1] *= 1.0f - 0.9f * wet;
    pixel[2] *= 1.0f - 1.1f * wet;
  });
}

/// A leaf in autumn, with a stem and side veins.
void addLeaf(SrgbImage& image, Random& random) {
  const float half = random.range(13.0f, 20.0f), width = half * random.range(0.4f, 0.55f);
  const std::array<float, 3> color{random.range(0.6f, 0.85f), random.range(0.3f, 0.6f), 0.12f};
  addObject(image, random, [&](float* pixel, float along, float across) {
    const float t = along / half, off = std::abs(across);
    const float body = width * (1.0f - t * t) * (1.0f - 0.3f * t) - off;
    const float stem = t < -0.9f && t > -1.5f ? 1.0f - off : -1.0f;
    const float inside = coverage(std::max(std::abs(t) < 1.0f ? body : -1.0f, stem));
    const bool vein = off < 0.7f || std::fmod(std::abs(along - 0.8f * off) + 0.5f, 5.0f) < 1.0f;
    for (std::size_t c = 0; c < 3; ++c)
      pixel[c] += inside * (color[c] * (vein ? 0.75f : 1.0f) - pixel[c]);
  });
}

} // namespace

SrgbImage cropped(const SrgbImage& image, int sidePixels, Random& random) {
  const float spare = float(image.width - sidePixels + 1);
  const int left = int(random.range(0.0f, spare)), top = int(random.range(0.0f, spare));
  SrgbImage part(sidePixels, sidePixels, 3);
  for (int y = 0; y < sidePixels; ++y)
    std::copy_n(image.pixel(left, top + y), 3 * sidePixels, part.pixel(0, y));
  return part;
}

void round(SrgbImage& image) {
  for (float& value : image.values)
    value = std::round(255.0f * std::clamp(value, 0.0f, 1.0f)) / 255.0f;
}

void expose(SrgbImage& image, Condition condition, Random& random) {
  switch (condition) {
  case Condition::tiles:
  case Condition::cropped:
    break;
  case Condition::vignette:
    addVignette(image, random);
    break;
  case Condition::gradient:
    addGradient(image, random);
    break;
  case Condition::shadow:
    addShadow(image, random);
    break;
  case Condition::compressed:
    compress(image, random);
    break;
  case Condition::noisy:
    addNoise(image, random);
    break;
  case Condition::fold:
    addFold(image, random);
    break;
  case Condition::stain:
    addStain(image, random);
    break;
  case Condition::leaf:
    addLeaf(image, random);
    break;
  }
}

SrgbImage photographed(DrawMaterial draw, int sidePixels, Condition condition, Random& random) {
  constexpr int kSpare = 48; // pixels of a larger picture
  if (condition == Condition::tiles)
    return draw(sidePixels, random).resolve();
  SrgbImage image = cropped(draw(sidePixels + kSpare, random).resolve(), sidePixels, random);
  expose(image, condition, random);
  round(image);
  return image;
}

} // namespace lichen::test
