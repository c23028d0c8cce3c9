// SPDX-License-Identifier: MIT
// Verdicts on pictures that were not used to choose the thresholds of decision 7. This file's
// generators make each picture with its own seed, colours and sizes. The expected verdict of each
// kind was fixed before any picture was judged.
#include "measured_cloudiness.h"

#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <periodic.h>
#include <string>
#include <vector>

using namespace lichen;
using namespace lichen::exemplars;

namespace {

/// Not the side of the calibration pictures, and large enough for every measure. The less material
/// a picture shows, the larger the share of slow variation: at 144, two of the suitable pictures
/// are reported to have it, mildly.
constexpr int kSide = 160;

struct Picture {
  SrgbImage image;
  bool periodic = true;
};

Color colorIn(Random& random, float low, float high) {
  const float r = random.range(low, high), g = random.range(low, high);
  return {r, g, random.range(low, high)};
}

template <typename ColorAt>
SrgbImage painted(const ColorAt& colorAt) {
  Canvas canvas(kSide);
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x)
      canvas.at(x, y) = colorAt(x, y);
  return canvas.resolve();
}

/// Multiplies every pixel's code values by a factor and clips them.
template <typename FactorAt>
SrgbImage relit(SrgbImage image, const FactorAt& factorAt) {
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int c = 0; c < 3; ++c) {
        float& value = image.pixel(x, y)[c];
        value = std::round(255.0f * std::clamp(value * factorAt(x, y), 0.0f, 1.0f)) / 255.0f;
      }
  return image;
}

/// Grains of 5 to 12 pixels; each has one colour between the given two.
SrgbImage gravel(std::uint32_t seed) {
  Random random(seed);
  const Mosaic grains(
      kSide,
      {.spacing = random.range(5.0f, 12.0f), .smallest = 0.7f, .largest = 1.4f, .longest = 1.5f},
      random.bits());
  const Field fine = fractalNoise(kSide, {4.0f, 1.0f, 0.8f}, random.bits());
  const Color dark = colorIn(random, 0.2f, 0.5f), light = colorIn(random, 0.5f, 0.8f);
  return painted([&](int sx, int sy) {
    const GrainHit hit = grains.at(pixelOf(sx), pixelOf(sy));
    return scaled(mix(dark, light, Random(hit.grain->id).unit()), 1.0f + 0.05f * fine.at(sx, sy));
  });
}

/// Soft spots of 8 to 20 pixels.
SrgbImage mottled(std::uint32_t seed) {
  Random random(seed);
  const Field spots = fractalNoise(kSide, {random.range(8.0f, 20.0f), 1.5f, 0.7f}, random.bits());
  const Color dark = colorIn(random, 0.2f, 0.5f), light = colorIn(random, 0.5f, 0.8f);
  return painted(
      [&](int sx, int sy) { return mix(dark, light, smoothStep(-2.0f, 2.0f, spots.at(sx, sy))); });
}

/// Scattered flakes on an even ground.
SrgbImage speckled(std::uint32_t seed) {
  Random random(seed);
  const Mosaic flakes(
      kSide,
      {.spacing = random.range(4.0f, 8.0f), .smallest = 0.5f, .largest = 1.8f, .longest = 2.0f},
      random.bits());
  const Field fine = fractalNoise(kSide, {5.0f, 1.0f, 0.8f}, random.bits());
  const float share = random.range(0.1f, 0.3f);
  const Color dark = colorIn(random, 0.2f, 0.4f), light = colorIn(random, 0.5f, 0.8f);
  return painted([&](int sx, int sy) {
    const GrainHit hit = flakes.at(pixelOf(sx), pixelOf(sy));
    return scaled(Random(hit.grain->id).chance(share) ? dark : light,
                  1.0f + 0.06f * fine.at(sx, sy));
  });
}

using Generator = SrgbImage (*)(std::uint32_t seed);
constexpr std::array<Generator, 3> kSuitable{gravel, mottled, speckled};

SrgbImage anySuitable(std::uint32_t seed) { return kSuitable[seed % kSuitable.size()](seed); }

/// Square tiles with dark joints.
Picture tiles(std::uint32_t seed) {
  Random random(seed);
  const float pitch = float(kSide) / std::floor(random.range(5.0f, 13.0f));
  const Field fine = fractalNoise(kSide, {6.0f, 1.0f, 0.8f}, random.bits());
  const Color joint = colorIn(random, 0.1f, 0.3f), tile = colorIn(random, 0.5f, 0.8f);
  return {painted([&](int sx, int sy) {
    const float x = std::fmod(pixelOf(sx), pitch), y = std::fmod(pixelOf(sy), pitch);
    const float fromEdge = std::min({x, pitch - x, y, pitch - y});
    return scaled(mix(joint, tile, smoothStep(0.8f, 1.6f, fromEdge)),
                  1.0f + 0.06f * fine.at(sx, sy));
  })};
}

/// Bands across the picture, 8 to 20 pixels each.
Picture stripes(std::uint32_t seed) {
  Random random(seed);
  const float count = std::floor(random.range(8.0f, 21.0f));
  const Field fine = fractalNoise(kSide, {6.0f, 1.0f, 0.8f}, random.bits());
  const Color dark = colorIn(random, 0.2f, 0.45f), light = colorIn(random, 0.55f, 0.8f);
  return {painted([&](int sx, int sy) {
    const float phase = std::fmod(pixelOf(sy) * count / float(kSide), 1.0f);
    return scaled(phase < 0.5f ? dark : light, 1.0f + 0.06f * fine.at(sx, sy));
  })};
}

/// Light that falls off from one side to the other.
Picture slopingLight(std::uint32_t seed) {
  Random random(seed);
  const Direction to = randomDirection(random);
  const float strength = random.range(0.5f, 0.8f);
  return {relit(anySuitable(seed),
                [&](int x, int y) {
                  const float along = to.x * (float(x) / kSide - 0.5f) +
                                      to.y * (float(y) / kSide - 0.5f); // up to 0.5 to 0.71
                  return 1.0f + 2.0f * strength * along;
                }),
          false};
}

/// Grain with clouds of every size; the power falls with the cube of the frequency.
Picture clouds(std::uint32_t seed) {
  Random random(seed);
  const float gain = std::sqrt(0.5f); // an octave at f has the energy f^2 f^-3
  const Field cloud = fractalNoise(kSide, {float(kSide), 2.0f, gain}, random.bits());
  const Field fine = fractalNoise(kSide, {4.0f, 1.0f, 0.9f}, random.bits());
  const Color color = colorIn(random, 0.35f, 0.6f);
  const float strength = random.range(0.16f, 0.22f);
  return {painted([&](int sx, int sy) {
    return scaled(color, 1.0f + strength * cloud.at(sx, sy) + 0.05f * fine.at(sx, sy));
  })};
}

/// A quarter to a half of the picture is white.
Picture overexposed(std::uint32_t seed) {
  const SrgbImage image = anySuitable(seed);
  std::vector<float> least;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      least.push_back(*std::min_element(image.pixel(x, y), image.pixel(x, y) + 3));
  const float share = Random(seed).range(0.25f, 0.5f);
  const auto white = least.begin() + std::ptrdiff_t((1.0f - share) * float(least.size()));
  std::nth_element(least.begin(), white, least.end());
  return {relit(image, [&](int, int) { return 1.0f / *white; })};
}

/// A pale stone on dark gravel.
Picture oneStone(std::uint32_t seed) {
  Random random(seed);
  SrgbImage image = relit(gravel(seed), [](int, int) { return 0.5f; });
  const Color stone = colorIn(random, 0.6f, 0.8f);
  const float radius = float(kSide) * random.range(0.25f, 0.4f);
  const Field fine = fractalNoise(kSide, {6.0f, 1.0f, 0.8f}, random.bits());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (std::hypot(float(x - kSide / 2), float(y - kSide / 2)) < radius) {
        const Color color =
            scaled(stone, 1.0f + 0.05f * fine.at(kSamplesPerPixel * x, kSamplesPerPixel * y));
        const std::array<float, 3> codes{color.r, color.g, color.b};
        for (std::size_t c = 0; c < 3; ++c)
          image.pixel(x, y)[c] = std::round(255.0f * codes[c]) / 255.0f;
      }
  return {image};
}

struct Unsuitable {
  const char* name;
  Picture (*generate)(std::uint32_t seed);
  const char* risk;
};
constexpr std::array<Unsuitable, 6> kUnsuitable{{{"tiles", tiles, "structure"},
                                                 {"stripes", stripes, "structure"},
                                                 {"sloping light", slopingLight, "low-frequency"},
                                                 {"clouds", clouds, "cloudiness"},
                                                 {"overexposed", overexposed, "clipping"},
                                                 {"one stone", oneStone, "low-frequency"}}};

std::vector<Risk> risksOf(const Picture& picture) {
  Result<std::vector<Risk>> risks =
      assessSuitability(test::baseColor(picture.image), picture.periodic);
  REQUIRE(risks.ok());
  return std::move(risks).value();
}

/// No picture may be judged wrongly. TARGETS.md allows fewer than a tenth: if a tenth or more of
/// the verdicts were wrong, 30 pictures would all pass with a probability of at most 0.9^30 = 4 %.
constexpr std::uint32_t kPictures = 30;

} // namespace

TEST_CASE("held-back suitable exemplars have no risk", "[large]") {
  for (std::uint32_t seed = 1; seed <= kPictures; ++seed)
    for (const Risk& risk : risksOf({anySuitable(seed)})) {
      INFO("seed " << seed << ", " << risk.name << ": " << risk.score);
      CHECK(risk.level == Risk::Level::none);
    }
}

TEST_CASE("each held-back unsuitable exemplar has its intended risk, severe", "[large]") {
  for (std::uint32_t seed = 101; seed < 101 + kPictures; ++seed) {
    const Unsuitable& unsuitable = kUnsuitable[seed % kUnsuitable.size()];
    const std::vector<Risk> risks = risksOf(unsuitable.generate(seed));
    const auto risk = std::find_if(risks.begin(), risks.end(),
                                   [&](const Risk& r) { return r.name == unsuitable.risk; });
    REQUIRE(risk != risks.end());
    INFO(unsuitable.name << ", seed " << seed << ", " << risk->name << ": " << risk->score);
    CHECK(risk->level == Risk::Level::severe);
  }
}
