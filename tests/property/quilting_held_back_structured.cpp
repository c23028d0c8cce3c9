// SPDX-License-Identifier: MIT
// A kind and a condition -> the picture.
//
// Textures belong to the cell: they are looked up by the offset from its middle.
#include "quilting_held_back_laying.h"
#include "quilting_held_back_pictures.h"
#include "verdict_held_back_drawing.h"
#include "verdict_held_back_pictures.h"

#include <utility>

namespace lichen::test {
namespace {

using namespace lichen::exemplars;

enum class Laid { plain, whole, turned, sheared, inPerspective, irregular };

struct LaidCondition {
  const char* name;
  Laid laid;
  Condition light;
};
constexpr std::array<LaidCondition, 10> kConditions{{
    {"plain", Laid::plain, Condition::cropped},
    {"whole", Laid::whole, Condition::cropped},
    {"turned", Laid::turned, Condition::cropped},
    {"sheared", Laid::sheared, Condition::cropped},
    {"in perspective", Laid::inPerspective, Condition::cropped},
    {"irregular", Laid::irregular, Condition::cropped},
    {"gradient", Laid::plain, Condition::gradient},
    {"turned in a shadow", Laid::turned, Condition::shadow},
    {"noisy", Laid::irregular, Condition::noisy},
    {"compressed", Laid::plain, Condition::compressed},
}};

std::vector<Laying> layings() {
  std::vector<Laying> all = masonryLayings();
  for (const auto& more : {woodLayings(), clothLayings()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

float either(Random& random, float low, float high) {
  const float size = random.range(low, high);
  return random.chance(0.5f) ? size : -size;
}

/// Positions of a picture -> positions of the kind.
class Ground {
public:
  Ground(const Laying& laying, int side, Laid laid, Random& random)
      : half_(0.5f * float(side)), box_(laying.box) {
    const float units = random.range(laying.fewest, laying.most);
    scale_ = {units / float(side), units / float(side)};
    shift_ = {random.range(20.0f, 40.0f), random.range(20.0f, 40.0f)};
    float irregularity = random.range(0.004f, 0.012f);
    const auto boxesIn = [&](float length) { return std::max(1.0f, std::round(units / length)); };
    switch (laid) {
    case Laid::plain:
      break;
    case Laid::whole:
      boxes_ = {int(boxesIn(box_.x)), int(boxesIn(box_.y))};
      scale_ = {boxesIn(box_.x) * box_.x / float(side), boxesIn(box_.y) * box_.y / float(side)};
      break;
    case Laid::turned: {
      const float tangent = either(random, 0.03f, 0.17f);
      const float length = std::sqrt(1.0f + tangent * tangent);
      x_ = {1.0f / length, tangent / length};
      y_ = {-tangent / length, 1.0f / length};
      break;
    }
    case Laid::sheared:
      (random.chance(0.5f) ? y_.x : x_.y) = either(random, 0.03f, 0.12f);
      break;
    case Laid::inPerspective: {
      const Direction to = randomDirection(random);
      const float narrower = random.range(0.02f, 0.05f); // at one side, and wider at the other
      tilt_ = {narrower * to.x, narrower * to.y};
      break;
    }
    case Laid::irregular:
      irregularity = random.range(0.03f, 0.08f);
      break;
    }
    const float waves = 3.0f * float(side) / units;
    for (Field& off : offsets_) {
      off = fractalNoise(side, {waves, 0.6f * waves, 1.0f}, random.bits());
      for (float& value : off.values)
        value *= irregularity;
    }
  }

  [[nodiscard]] Point at(Point picture) const {
    const float qx = picture.x - half_, qy = picture.y - half_;
    const float depth = 1.0f + (tilt_.x * qx + tilt_.y * qy) / half_;
    const float x = qx / depth, y = qy / depth;
    return {(x_.x * x + y_.x * y) * scale_.x + shift_.x + offsets_[0].atPixel(picture.x, picture.y),
            (x_.y * x + y_.y * y) * scale_.y + shift_.y +
                offsets_[1].atPixel(picture.x, picture.y)};
  }

  /// The numbers of a middle; in a whole picture they wrap.
  [[nodiscard]] std::pair<int, int> cellOf(Point middle) const {
    constexpr int kSteps = 48; // in a box, more than cells
    const auto numberOf = [](float position, float length, int boxes) {
      const int number = int(std::floor(position / length * float(kSteps) + 0.25f));
      return boxes == 0 ? number : number % (kSteps * boxes);
    };
    return {numberOf(middle.x, box_.x, boxes_[0]), numberOf(middle.y, box_.y, boxes_[1])};
  }

  [[nodiscard]] float pixelsPerUnit() const { return 1.0f / scale_.y; }

private:
  float half_;
  Point box_, scale_, shift_, tilt_;
  Point x_{1.0f, 0.0f}, y_{0.0f, 1.0f}; ///< where the kind has the axes of the picture
  std::array<int, 2> boxes_{};          ///< of a whole picture
  std::array<Field, 2> offsets_{Field(1), Field(1)};
};

/// The field between its samples.
float smoothAt(const Field& field, float x, float y) {
  const float sx = 2.0f * x - 0.5f, sy = 2.0f * y - 0.5f;
  const int i = int(std::floor(sx)), j = int(std::floor(sy));
  const float fx = sx - float(i), fy = sy - float(j);
  const float top = field.at(i, j) + fx * (field.at(i + 1, j) - field.at(i, j));
  const float low = field.at(i, j + 1) + fx * (field.at(i + 1, j + 1) - field.at(i, j + 1));
  return top + fy * (low - top);
}

/// Colours and textures of one picture.
class Paint {
public:
  Paint(const Laying& laying, int side, Random& random)
      : matter_(laying.matter), fine_(fractalNoise(side, {4.0f, 1.0f, 0.8f}, random.bits())),
        coarse_(fractalNoise(side, {24.0f, 4.0f, 0.65f}, random.bits())), seed_(random.bits()) {
    tones_ = paletteOf(random, 0.1f, 0.3f);
    if (matter_ == Matter::stone)
      tones_ = {greyed(tones_.dark), greyed(tones_.light)};
    if (matter_ == Matter::wood)
      tones_ = {brown(random.range(0.25f, 0.4f), random),
                brown(random.range(0.45f, 0.65f), random)};
    if (matter_ == Matter::yarn) // threads are dyed alike
      tones_.dark = scaled(tones_.light, random.range(0.85f, 0.95f));
    odd_ = hueOf(random, random.range(0.35f, 0.6f), 0.3f);
    const bool isDark = matter_ == Matter::wood || laying.overlaps || random.chance(0.5f);
    joint_ = hueOf(random, isDark ? random.range(0.1f, 0.25f) : random.range(0.6f, 0.75f), 0.06f);
    gap_ = matter_ == Matter::wood ? random.range(0.3f, 0.7f) : random.range(0.8f, 1.8f);
    ragged_ = matter_ == Matter::stone ? random.range(0.15f, 0.5f) : 0.1f;
    roughness_ = random.range(0.6f, 1.3f);
    const Direction lamp = randomDirection(random);
    lamp_ = {lamp.x, lamp.y};
    depth_ = random.range(0.5f, 1.0f);
  }

  /// Distance in pixels inside the face of a cell; negative in joints.
  [[nodiscard]] float insideFace(const Spot& spot, float pixels, Point picture) const {
    return spot.inside * pixels - gap_ + ragged_ * smoothAt(coarse_, picture.x, picture.y);
  }
  /// The surface's height in pixels.
  [[nodiscard]] float heightOf(const Spot& spot, float pixels) const {
    if (matter_ == Matter::yarn)
      return 0.3f * pixels * spot.height;
    const float rise = matter_ == Matter::stone ? 2.5f : 1.4f;
    const float t = clamped((spot.inside * pixels - gap_) / rise, 0.0f, 1.0f);
    return rise * 0.5f * t * (2.0f - t) + 0.08f * pixels * spot.slant;
  }
  [[nodiscard]] Color joint(Point picture) const {
    return scaled(joint_, 1.0f + 0.09f * smoothAt(fine_, picture.x, picture.y) +
                              0.05f * smoothAt(coarse_, picture.x, picture.y));
  }
  /// `local` is along and across, in pixels. `slopes` are the height's.
  [[nodiscard]] Color face(const Spot& spot, std::pair<int, int> cell, Point local, Point slopes,
                           float inside) const {
    const auto toss = [&](std::uint32_t k) { return hashed(cell.first, cell.second, seed_ + k); };
    const float u = local.x + 300.0f * toss(1), v = local.y + 300.0f * toss(2);
    Color color = mix(tones_.dark, tones_.light, toss(0));
    float tone = 1.0f;
    switch (matter_) {
    case Matter::stone:
      color = mix(color, odd_, toss(3) < 0.2f ? 0.35f : 0.0f);
      tone += roughness_ * (0.06f * smoothAt(coarse_, u, v) + 0.06f * smoothAt(fine_, u, v)) -
              0.25f * smoothStep(1.6f, 2.4f, smoothAt(fine_, v, u)) -
              0.12f * (1.0f - smoothStep(0.0f, 3.0f, inside));
      break;
    case Matter::ceramic:
      tone += 0.05f * roughness_ * smoothAt(coarse_, u, v) + 0.015f * smoothAt(fine_, u, v) +
              0.008f * (lamp_.x * local.x + lamp_.y * local.y) +
              0.12f * (1.0f - smoothStep(0.0f, 2.5f, inside));
      break;
    case Matter::wood: {
      const float rings = smoothAt(coarse_, 0.06f * u, 0.7f * v);
      tone +=
          roughness_ * (0.07f * smoothAt(fine_, 0.12f * u, v) + 0.08f * rings) -
          0.2f * smoothStep(1.4f, 2.2f,
                            smoothAt(fine_, 0.15f * v, u + 50.0f) * smoothAt(fine_, 0.1f * u, v)) -
          0.15f * (1.0f - smoothStep(0.0f, 1.5f, inside));
      break;
    }
    case Matter::yarn:
      tone += roughness_ * (0.09f * smoothAt(fine_, 0.35f * u - v, 0.35f * u + v) +
                            0.04f * smoothAt(coarse_, 0.2f * u, v)) -
              0.45f * (1.0f - spot.height) * (1.0f - spot.height);
      break;
    }
    const float lit = lamp_.x * slopes.x + lamp_.y * slopes.y;
    return scaled(color, tone * clamped(1.0f + 0.35f * depth_ * lit, 0.45f, 1.4f));
  }

private:
  static Color greyed(const Color& color) {
    const float grey = 0.3f * color.r + 0.6f * color.g + 0.1f * color.b;
    return mix(color, {grey, grey, grey}, 0.5f);
  }
  static Color brown(float level, Random& random) {
    return {1.15f * level, level * random.range(0.7f, 0.85f), level * random.range(0.4f, 0.6f)};
  }

  Matter matter_;
  Field fine_, coarse_;
  std::uint32_t seed_;
  Palette tones_;
  Color odd_, joint_;
  Point lamp_;
  float gap_ = 0.0f, ragged_ = 0.0f, roughness_ = 0.0f, depth_ = 0.0f;
};

} // namespace

HeldBackPicture structuredHeldBack(int index) {
  const std::vector<Laying> kinds = layings();
  const Laying& laying = kinds[std::size_t(index) % kinds.size()];
  const LaidCondition& condition = kConditions[std::size_t(index) / kinds.size()];
  Random random(std::uint32_t(19000 + index));
  const int side = int(random.range(float(kSmallestQuiltingSide), float(kLargestQuiltingSide + 1)));
  const Ground ground(laying, side, condition.laid, random);
  const Paint paint(laying, side, random);
  const float pixels = ground.pixelsPerUnit();
  const bool isCloth = laying.matter == Matter::yarn;

  Canvas canvas(side);
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x) {
      const Point picture{pixelOf(x), pixelOf(y)}, p = ground.at(picture);
      const Spot spot = laying.at(p);
      const float inside = isCloth ? 1.0f : paint.insideFace(spot, pixels, picture);
      const float dx = (p.x - spot.middle.x) * pixels, dy = (p.y - spot.middle.y) * pixels;
      const Point local{dx * spot.axis.x + dy * spot.axis.y, dy * spot.axis.x - dx * spot.axis.y};
      constexpr float kStep = 0.5f; // pixels
      const float step = kStep / pixels;
      const auto heightAt = [&](float ox, float oy) {
        return paint.heightOf(laying.at({p.x + ox, p.y + oy}), pixels);
      };
      const Point slopes{(heightAt(step, 0.0f) - heightAt(-step, 0.0f)) / (2.0f * kStep),
                         (heightAt(0.0f, step) - heightAt(0.0f, -step)) / (2.0f * kStep)};
      canvas.at(x, y) = mix(paint.joint(picture),
                            paint.face(spot, ground.cellOf(spot.middle), local, slopes, inside),
                            coverage(inside));
    }

  HeldBackPicture picture;
  picture.name = std::string(laying.name) + ", " + condition.name;
  picture.image = canvas.resolve();
  expose(picture.image, condition.light, random);
  round(picture.image);
  return picture;
}

} // namespace lichen::test
