// SPDX-License-Identifier: MIT
// Part of a surface -> the same with a fault, in linear light, and the noise of a camera.
#include "photographs.h"

#include "materials.h"
#include "periodic.h"
#include "surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::exemplars {
namespace {

constexpr std::array<Material, 4> kSurfaces{{
    {"plaster", plaster},
    {"cloth", cloth},
    {"wood_grain", woodGrain},
    {"concrete", concrete},
}};

/// The materials and the surfaces.
std::vector<Material> photographed() {
  std::vector<Material> all(kMaterials.begin(), kMaterials.end());
  all.insert(all.end(), kSurfaces.begin(), kSurfaces.end());
  return all;
}

/// A part of a larger picture that tiles, so that its borders do not fit.
SrgbImage cropped(const SrgbImage& image, int side, Random& random) {
  const int spare = image.width - side;
  const int left = int(random.unit() * float(spare)), top = int(random.unit() * float(spare));
  SrgbImage part(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      std::copy_n(image.pixel(left + x, top + y), 3, part.pixel(x, y));
  return part;
}

/// Calls paint(x, y, light) for each pixel, with x and y in [-1, 1] and three values of linear
/// light to change.
template <typename Paint>
void paintLight(SrgbImage& image, const Paint& paint) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      float* pixel = image.pixel(x, y);
      std::array<float, 3> linear{};
      for (std::size_t c = 0; c < 3; ++c)
        linear[c] = srgbToLinear(pixel[c]);
      paint(2.0f * (float(x) + 0.5f) / float(image.width) - 1.0f,
            2.0f * (float(y) + 0.5f) / float(image.height) - 1.0f, linear);
      for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = linearToSrgb(std::clamp(linear[c], 0.0f, 1.0f));
    }
}

void multiply(std::array<float, 3>& light, float factor) {
  for (float& value : light)
    value *= factor;
}

/// An object of the given size, in half sides, lies wholly inside.
struct Pose {
  float x = 0.0f, y = 0.0f;
  Direction along;

  Pose(float reach, Random& random)
      : x(random.range(reach - 1.0f, 1.0f - reach)), y(random.range(reach - 1.0f, 1.0f - reach)),
        along(randomDirection(random)) {}
  /// The position along and across the object.
  [[nodiscard]] std::array<float, 2> local(float px, float py) const {
    return {(px - x) * along.x + (py - y) * along.y, (py - y) * along.x - (px - x) * along.y};
  }
  [[nodiscard]] Place around(float reach, int side) const {
    const float half = 0.5f * float(side);
    const int from = int((x - reach + 1.0f) * half), down = int((y - reach + 1.0f) * half);
    const int size = int(2.0f * reach * half) + 1;
    return {from, down, size, size};
  }
};

Place addFold(SrgbImage& image, float strength, Random& random) {
  constexpr float kReach = 0.3f, kWidth = 0.035f;
  const Pose pose(kReach, random);
  const float bend = random.range(-0.8f, 0.8f);
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const auto [along, across] = pose.local(x, y);
    const float off = (across - bend * along * along) / kWidth;
    const float ends = 1.0f - smoothStep(0.6f * kReach, 0.9f * kReach, std::abs(along));
    const float crease = std::exp(-off * off), edge = std::exp(-(off - 2.0f) * (off - 2.0f));
    multiply(light, 1.0f + strength * ends * (0.5f * edge - crease));
  });
  return pose.around(kReach, image.width);
}

Place addStain(SrgbImage& image, float strength, Random& random) {
  const float reach = random.range(0.14f, 0.24f);
  const Pose pose(reach, random);
  const Field outline =
      fractalNoise(image.width, {float(image.width) / 8.0f, 4.0f, 0.5f}, random.bits());
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const auto [along, across] = pose.local(x, y);
    const float half = 0.5f * float(image.width);
    const float radius = std::hypot(along, 1.3f * across) / reach +
                         0.06f * outline.atPixel((x + 1.0f) * half, (y + 1.0f) * half);
    const float wet = strength * (1.0f - smoothStep(0.7f, 0.95f, radius));
    light[0] *= 1.0f - 0.8f * wet;
    light[1] *= 1.0f - 0.9f * wet;
    light[2] *= 1.0f - wet;
  });
  return pose.around(reach, image.width);
}

Place addLeaf(SrgbImage& image, Random& random) {
  const float reach = random.range(0.1f, 0.2f);
  const Pose pose(reach, random);
  const std::array<float, 3> green{0.12f, 0.25f, 0.05f};
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const auto [along, across] = pose.local(x, y);
    const float t = along / reach;
    const float inside = 0.35f * reach * (1.0f - t * t) - std::abs(across);
    if (std::abs(t) >= 1.0f || inside <= 0.0f)
      return;
    const float vein = std::abs(across) < 0.02f * reach ? 1.5f : 1.0f;
    for (std::size_t c = 0; c < 3; ++c)
      light[c] = green[c] * vein * (0.7f + 0.6f * inside / reach);
  });
  return pose.around(reach, image.width);
}

void addVignette(SrgbImage& image, float strength, Random& random) {
  const float x0 = random.range(-0.2f, 0.2f), y0 = random.range(-0.2f, 0.2f);
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const float squared = 0.5f * ((x - x0) * (x - x0) + (y - y0) * (y - y0));
    multiply(light, std::max(0.05f, 1.0f - strength * squared));
  });
}

void addGradient(SrgbImage& image, float strength, Random& random) {
  const Direction to = randomDirection(random);
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const float side = (to.x * x + to.y * y) / (std::abs(to.x) + std::abs(to.y)); // [-1, 1]
    multiply(light, 1.0f - 0.5f * strength * (1.0f + side));
  });
}

void addShadow(SrgbImage& image, float strength, Random& random) {
  const Direction to = randomDirection(random);
  const float at = random.range(0.1f, 0.4f), softness = random.range(0.3f, 0.6f);
  const float bend = random.range(-0.3f, 0.3f);
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const float side = to.x * x + to.y * y, along = to.x * y - to.y * x;
    const float from = at + bend * along * along;
    multiply(light, 1.0f - strength * smoothStep(from - softness, from + softness, side));
  });
}

void addPatches(SrgbImage& image, float strength, Random& random) {
  const Field patches =
      fractalNoise(image.width, {0.45f * float(image.width), 6.0f, 0.4f}, random.bits());
  const float half = 0.5f * float(image.width);
  paintLight(image, [&](float x, float y, std::array<float, 3>& light) {
    const float t =
        strength * smoothStep(-1.5f, 1.5f, patches.atPixel((x + 1.0f) * half, (y + 1.0f) * half));
    light[0] *= 1.0f - 0.5f * t; // from the material's colour to a browner one
    light[1] *= 1.0f - 0.8f * t;
    light[2] *= 1.0f - t;
  });
}

/// Returns the place of an object.
Place addFault(SrgbImage& image, const PhotographPlan& plan, Random& random) {
  switch (plan.fault) {
  case Fault::none:
    break;
  case Fault::vignette:
    addVignette(image, plan.strength, random);
    break;
  case Fault::gradient:
    addGradient(image, plan.strength, random);
    break;
  case Fault::shadow:
    addShadow(image, plan.strength, random);
    break;
  case Fault::fold:
    return addFold(image, plan.strength, random);
  case Fault::stain:
    return addStain(image, plan.strength, random);
  case Fault::leaf:
    return addLeaf(image, random);
  case Fault::patches:
    addPatches(image, plan.strength, random);
    break;
  }
  return {};
}

/// Adds the noise of a camera and rounds to 8 bits.
void expose(SrgbImage& image, std::uint32_t seed) {
  constexpr float kNoise = 0.008f; // code values, uniform in [-1, 1] times this
  Random random(seed);
  for (float& value : image.values) {
    const float noisy = value + kNoise * random.range(-1.0f, 1.0f);
    value = std::round(255.0f * std::clamp(noisy, 0.0f, 1.0f)) / 255.0f;
  }
}

} // namespace

const char* nameOf(Fault fault) {
  switch (fault) {
  case Fault::none:
    return "even";
  case Fault::vignette:
    return "vignette";
  case Fault::gradient:
    return "gradient";
  case Fault::shadow:
    return "shadow";
  case Fault::fold:
    return "fold";
  case Fault::stain:
    return "stain";
  case Fault::leaf:
    return "leaf";
  case Fault::patches:
    break;
  }
  return "patches";
}

std::string PhotographPlan::name() const {
  const std::string kind = std::string(material) + "-" + nameOf(fault);
  return strength > 0.0f ? kind + "-" + std::to_string(std::lround(100.0f * strength)) : kind;
}

SrgbImage photographedSurface(const std::string& name, int side) {
  const std::vector<Material> all = photographed();
  return std::ranges::find(all, name, &Material::name)->generate((3 * side + 1) / 2);
}

Photograph photograph(const SrgbImage& surface, const PhotographPlan& plan) {
  Random random(plan.seed);
  Photograph taken;
  taken.even = cropped(surface, surface.width * 2 / 3, random);
  taken.image = taken.even;
  taken.object = addFault(taken.image, plan, random);
  const std::uint32_t noise = random.bits();
  expose(taken.even, noise);
  expose(taken.image, noise);
  return taken;
}

std::vector<PhotographPlan> sixtyPhotographs() {
  constexpr std::array<Fault, 2> kLights{Fault::vignette, Fault::gradient};
  constexpr std::array<Fault, 3> kObjects{Fault::fold, Fault::stain, Fault::leaf};
  std::vector<PhotographPlan> plans;
  const std::vector<Material> all = photographed();
  for (std::size_t m = 0; m < all.size(); ++m) {
    const char* material = all[m].name;
    const auto add = [&](Fault fault, float strength) {
      plans.push_back({material, fault, strength, std::uint32_t(plans.size() + 1)});
    };
    const auto more = 0.02f * float(m);
    const Fault object = kObjects[m % 3];
    add(Fault::none, 0.0f);
    add(kLights[m % 2], 0.15f + more);
    add(kLights[(m + 1) % 2], 0.4f + more);
    add(Fault::shadow, 0.25f + more);
    add(object, object == Fault::leaf ? 0.0f : 0.4f + more);
    add(Fault::patches, 0.3f + more);
  }
  return plans;
}

} // namespace lichen::exemplars
