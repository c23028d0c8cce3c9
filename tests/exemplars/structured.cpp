// SPDX-License-Identifier: MIT
// A structured material and a condition -> its photograph and the cells of its pixels.
//
// The material is evaluated at the point that each sample shows, so that the cells under a turn or
// a perspective are exact. Light falls from the upper left; heights shade, and hide each other from
// it.
#include "structured.h"

#include "structured_sheet.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lichen::exemplars {
namespace {

const StructuredMaterial& materialOf(const std::string& name) {
  return **std::ranges::find(kStructuredMaterials, name, &StructuredMaterial::name);
}

/// Where on the sheet a position of the picture is.
class View {
public:
  View(int side, const StructuredMaterial& material, const StructuredPlan& plan)
      : condition_(plan.condition), half_(0.5f * float(side)) {
    constexpr float kRadians = 3.14159265f / 180.0f;
    const float angle = kRadians * condition_.turnDegrees, half = 0.5f * angle;
    // The tangent's series to its seventh power; sine and cosine of the C library differ by
    // machine.
    const float square = half * half;
    const float t =
        half * (1.0f + square * (1.0f / 3.0f + square * (2.0f / 15.0f + square * 17.0f / 315.0f)));
    cosine_ = (1.0f - t * t) / (1.0f + t * t);
    sine_ = 2.0f * t / (1.0f + t * t);
    Random random(plan.seed);
    shift_ = {random.range(0.0f, 4.0f * material.box.x), random.range(0.0f, 4.0f * material.box.y)};
    if (condition_.whole) {
      const auto boxes = [side](float length) {
        return std::max(1.0f, std::floor(float(side) / length + 0.5f));
      };
      extent_ = {boxes(material.box.x) * material.box.x, boxes(material.box.y) * material.box.y};
      scale_ = {extent_.x / float(side), extent_.y / float(side)};
    }
  }

  [[nodiscard]] Point extent() const { return extent_; }

  [[nodiscard]] Point onSheet(Point picture) const {
    // A row is wider by this factor than the middle row.
    const float squeeze = condition_.keystone / (2.0f - condition_.keystone);
    const float depth = 1.0f + squeeze * (picture.y - half_) / half_;
    const Point p = turned({(picture.x - half_) / depth, (picture.y - half_) / depth});
    return {p.x * scale_.x + shift_.x, p.y * scale_.y + shift_.y};
  }

  /// The offset in the picture, near its middle, of an offset on the sheet.
  [[nodiscard]] Point inPicture(Point sheet) const {
    const Point p{sheet.x / scale_.x, sheet.y / scale_.y};
    const float x = cosine_ * p.x + sine_ * p.y, y = cosine_ * p.y - sine_ * p.x;
    return {x - condition_.shear * y, y};
  }

private:
  /// Shears, then turns.
  [[nodiscard]] Point turned(Point p) const {
    const float x = p.x + condition_.shear * p.y;
    return {cosine_ * x - sine_ * p.y, sine_ * x + cosine_ * p.y};
  }

  StructuredCondition condition_;
  float half_;
  float cosine_ = 1.0f, sine_ = 0.0f;
  Point shift_, extent_, scale_{1.0f, 1.0f};
};

constexpr int kMargin = 16; // pixels around the picture that shade it

/// Colour, height and gloss at every sample of the picture and its margin.
struct Relit {
  explicit Relit(int side) : canvas(side), height(canvas.side()), gloss(canvas.side()) {}
  Canvas canvas;
  Field height, gloss;
};

/// How much less of the sky a place sees than a flat one; negative where it stands out.
class Hollows {
public:
  explicit Hollows(const Field& height)
      : height_(height), near_(blurred(height, 3)), far_(blurred(height, 9)) {}
  [[nodiscard]] float at(int x, int y) const {
    const float here = height_.at(x, y);
    return clamped(0.16f * (near_.at(x, y) - here) + 0.07f * (far_.at(x, y) - here), -0.2f, 0.75f);
  }

private:
  const Field& height_;
  Field near_, far_;
};

/// Multiplies by the light of the sky and of a low sun in the upper left.
void shade(Relit& relit) {
  constexpr float kX = -0.48f, kY = -0.56f, kZ = 0.675f; // toward the sun
  constexpr float kSky = 0.42f;                          // its share of the light
  constexpr int kShadow = 24;                            // samples
  const Field& height = relit.height;
  const Hollows hollows(height);
  for (int y = 0; y < height.side; ++y)
    for (int x = 0; x < height.side; ++x) {
      const float here = height.at(x, y);
      const float slopeX = height.at(x + 1, y) - height.at(x - 1, y); // two samples are a pixel
      const float slopeY = height.at(x, y + 1) - height.at(x, y - 1);
      const float length = std::sqrt(1.0f + slopeX * slopeX + slopeY * slopeY);
      const float facing = (kZ - slopeX * kX - slopeY * kY) / length;
      // What stands between the point and the sun; its edge is soft, as the sun is hazy.
      float above = 0.0f;
      for (int step = 1; step <= kShadow; step += step < 6 ? 1 : 2) {
        const float t = float(step) / float(kSamplesPerPixel);
        const float ray = here + 0.3f + t * kZ / 0.738f; // 0.738 is the sun's share in the plane
        const int sx = x + int(std::floor(float(step) * kX / 0.738f + 0.5f));
        const int sy = y + int(std::floor(float(step) * kY / 0.738f + 0.5f));
        above = std::max(above, height.at(sx, sy) - ray);
      }
      const float sun = 1.0f - smoothStep(0.0f, 1.6f, above);
      const float light =
          kSky * (1.0f - hollows.at(x, y)) + (1.0f - kSky) * sun * std::max(facing, 0.0f) / kZ;
      // Gloss: the sun in a mirror, as seen from above.
      const float halfway = std::max(0.0f, (1.0f + kZ - slopeX * kX - slopeY * kY) /
                                               (length * 1.8303f)); // sqrt(2 + 2 kZ)
      const float second = halfway * halfway, fourth = second * second, eighth = fourth * fourth;
      const float glint = relit.gloss.at(x, y) * sun * eighth * eighth * eighth * fourth;
      Color& color = relit.canvas.at(x, y);
      const auto lit = [&](float code) {
        return std::sqrt(clamped(code * code * light + 0.5f * glint, 0.0f, 1.0f));
      };
      color = {lit(color.r), lit(color.g), lit(color.b)};
    }
}

/// The share of light that the condition leaves at a position in [-1, 1].
class Lamp {
public:
  Lamp(const StructuredCondition& condition, Random& random)
      : condition_(condition), to_(randomDirection(random)), middle_{random.range(-0.2f, 0.2f),
                                                                     random.range(-0.2f, 0.2f)} {}
  [[nodiscard]] float at(float x, float y) const {
    const float side = (to_.x * x + to_.y * y) / (std::abs(to_.x) + std::abs(to_.y));
    const float dx = x - middle_.x, dy = y - middle_.y;
    return (1.0f - 0.5f * condition_.gradient * (1.0f + side)) *
           std::max(0.05f, 1.0f - 0.5f * condition_.vignette * (dx * dx + dy * dy));
  }

private:
  StructuredCondition condition_;
  Direction to_;
  Point middle_;
};

/// The picture without its margin, with the lens and the sensor.
SrgbImage exposed(const Canvas& canvas, int side, const StructuredCondition& condition,
                  Random& random) {
  const SrgbImage sharp = canvas.resolve();
  SrgbImage image(side, side, 3);
  const int reach = condition.blurPixels > 0.0f ? 3 : 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c) {
        float sum = 0.0f, weights = 0.0f;
        for (int j = -reach; j <= reach; ++j)
          for (int i = -reach; i <= reach; ++i) {
            const float radius = std::sqrt(float(i * i + j * j));
            const float weight = clamped(condition.blurPixels + 0.5f - radius, 0.0f, 1.0f);
            sum += weight * sharp.pixel(x + kMargin + i, y + kMargin + j)[c];
            weights += weight;
          }
        const float noisy = sum / weights + condition.noise * random.range(-1.0f, 1.0f);
        image.pixel(x, y)[c] = std::round(255.0f * clamped(noisy, 0.0f, 1.0f)) / 255.0f;
      }
  return image;
}

/// What the picture and its margin show, unlit.
Relit unlit(int side, const StructuredMaterial& material, const View& view, const Sheet& sheet) {
  Relit relit(side + 2 * kMargin);
  for (int y = 0; y < relit.canvas.side(); ++y)
    for (int x = 0; x < relit.canvas.side(); ++x) {
      const Point at{pixelOf(x) - float(kMargin), pixelOf(y) - float(kMargin)};
      const Surface surface = material.at(view.onSheet(at), sheet);
      relit.canvas.at(x, y) = surface.color;
      relit.height.at(x, y) = surface.height;
      relit.gloss.at(x, y) = surface.gloss;
    }
  return relit;
}

Sheet sheetOf(const StructuredPlan& plan, const View& view) {
  return {pcg3d({plan.seed, 1, 2})[0], plan.condition.irregularity, view.extent()};
}

/// The picture of `channels` codes a pixel, without the margin; codesAt(x, y, codes) writes those
/// of a sample.
template <typename CodesAt>
SrgbImage mapOf(int side, int channels, const CodesAt& codesAt) {
  SrgbImage image(side, side, channels);
  constexpr int kSamples = kSamplesPerPixel * kSamplesPerPixel;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      std::array<float, 3> sums{}, codes{};
      for (int k = 0; k < kSamples; ++k) {
        codesAt(kSamplesPerPixel * (x + kMargin) + k % kSamplesPerPixel,
                kSamplesPerPixel * (y + kMargin) + k / kSamplesPerPixel, codes);
        for (std::size_t c = 0; c < sums.size(); ++c)
          sums[c] += codes[c] / float(kSamples);
      }
      for (int c = 0; c < channels; ++c)
        image.pixel(x, y)[c] =
            std::round(255.0f * clamped(sums[std::size_t(c)], 0.0f, 1.0f)) / 255.0f;
    }
  return image;
}

} // namespace

std::string StructuredPlan::name() const { return std::string(material) + "-" + condition.name; }

StructuredPicture structured(int side, const StructuredPlan& plan) {
  const StructuredMaterial& material = materialOf(plan.material);
  const View view(side, material, plan);
  const Sheet sheet = sheetOf(plan, view);
  Random random(plan.seed + 1000);
  const Lamp lamp(plan.condition, random);
  Relit relit = unlit(side, material, view, sheet);
  shade(relit);
  const float half = 0.5f * float(side);
  for (int y = 0; y < relit.canvas.side(); ++y)
    for (int x = 0; x < relit.canvas.side(); ++x) {
      const float light = lamp.at((pixelOf(x) - float(kMargin)) / half - 1.0f,
                                  (pixelOf(y) - float(kMargin)) / half - 1.0f);
      relit.canvas.at(x, y) = scaled(relit.canvas.at(x, y), std::sqrt(light));
    }
  StructuredPicture picture;
  picture.image = exposed(relit.canvas, side, plan.condition, random);
  for (std::size_t k = 0; k < 2; ++k)
    picture.periods[k] = view.inPicture(material.periods[k]);
  if (!material.hasCells)
    return picture;
  std::map<std::pair<int, int>, int> numbers;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Surface surface = material.at(view.onSheet({float(x) + 0.5f, float(y) + 0.5f}), sheet);
      picture.cells.push_back(
          surface.joint ? -1
                        : numbers.try_emplace({surface.column, surface.row}, int(numbers.size()))
                              .first->second);
    }
  return picture;
}

StructuredMaps structuredMaps(int side, const StructuredPlan& plan) {
  const StructuredMaterial& material = materialOf(plan.material);
  const View view(side, material, plan);
  const Relit relit = unlit(side, material, view, sheetOf(plan, view));
  const Field& height = relit.height;
  const Hollows hollows(height);
  const auto ends = std::ranges::minmax(height.values);
  const float range = std::max(ends.max - ends.min, 1e-6f);
  StructuredMaps maps;
  const SrgbImage color = relit.canvas.resolve();
  maps.color = SrgbImage(side, side, 3);
  for (int y = 0; y < side; ++y)
    std::copy_n(color.pixel(kMargin, y + kMargin), 3 * side, maps.color.pixel(0, y));
  maps.normal = mapOf(side, 3, [&](int x, int y, std::array<float, 3>& codes) {
    const float slopeX = height.at(x + 1, y) - height.at(x - 1, y); // two samples are a pixel
    const float slopeY = height.at(x, y + 1) - height.at(x, y - 1);
    const float half = 0.5f / std::sqrt(1.0f + slopeX * slopeX + slopeY * slopeY);
    codes = {0.5f - half * slopeX, 0.5f + half * slopeY, 0.5f + half};
  });
  maps.roughness = mapOf(side, 1, [&](int x, int y, std::array<float, 3>& codes) {
    codes[0] = 0.9f - 0.7f * relit.gloss.at(x, y);
  });
  maps.occlusion = mapOf(side, 1, [&](int x, int y, std::array<float, 3>& codes) {
    codes[0] = 1.0f - hollows.at(x, y);
  });
  maps.height = mapOf(side, 1, [&](int x, int y, std::array<float, 3>& codes) {
    codes[0] = (height.at(x, y) - ends.min) / range;
  });
  return maps;
}

std::vector<StructuredPlan> structuredPlans() {
  constexpr std::array<StructuredCondition, 11> kConditions{{
      {},
      {.name = "whole", .whole = true},
      {.name = "turned-3", .turnDegrees = 3.0f},
      {.name = "turned-10", .turnDegrees = -10.0f},
      {.name = "sheared-8", .shear = 0.08f},
      {.name = "keystone-10", .keystone = 0.1f},
      {.name = "gradient-40", .gradient = 0.4f},
      {.name = "vignette-40", .vignette = 0.4f},
      {.name = "irregular-15", .irregularity = 0.15f},
      {.name = "noisy", .blurPixels = 1.2f, .noise = 0.04f},
      {.name = "mixed",
       .turnDegrees = 5.0f,
       .shear = -0.03f,
       .keystone = 0.05f,
       .gradient = 0.15f,
       .vignette = 0.2f,
       .irregularity = 0.07f,
       .blurPixels = 0.8f,
       .noise = 0.015f},
  }};
  std::vector<StructuredPlan> plans;
  for (const StructuredMaterial* material : kStructuredMaterials)
    for (const StructuredCondition& condition : kConditions)
      plans.push_back({material->name, condition, std::uint32_t(plans.size() + 1)});
  return plans;
}

} // namespace lichen::exemplars
