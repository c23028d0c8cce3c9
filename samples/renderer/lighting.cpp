// SPDX-License-Identifier: MIT
// Ratios of irradiance at the subject -> intensities; see lighting.h.
#include "lighting.h"

#include "relative_to.h"
#include "shaders/scene_interface.h"

#include <algorithm>
#include <numbers>

namespace lichen::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// The sun is about three times as strong as the sky, as on a day with thin haze. On a clear day the
// ratio is about six, but then shadows are too dark for a display.
constexpr float kKeyIrradiance = 1.05f * kPi;
constexpr float kSkyIrradiance = 0.42f * kPi;
// Without a sun, the sky is as dim as at dusk: it fills the shadows of lamps without competing with
// them.
constexpr float kDuskIrradiance = 0.10f * kPi;
constexpr glm::vec3 kDefaultTowardSun{-0.62f, 0.66f, 0.43f};
constexpr glm::vec3 kDefaultSunColor{1.0f, 0.95f, 0.88f};

float irradianceAt(const Light& light, const Sphere& subject) {
  const float strongest = std::max(light.color.r, std::max(light.color.g, light.color.b));
  if (light.kind == LightKind::directional)
    return light.intensity * strongest;
  const glm::vec3 toLight = relativeTo(subject.center, light.position);
  const float squared = std::max(glm::dot(toLight, toLight), subject.radius * subject.radius);
  return light.intensity * strongest / squared;
}

} // namespace

Lighting arrangeLights(const Scene& scene, const Sphere& subject, bool environmentFile) {
  Lighting result;
  result.lights = scene.lights;
  float strongest = 0.0f;
  for (const Light& light : result.lights)
    strongest = std::max(strongest, irradianceAt(light, subject));
  if (strongest <= 0.0f) {
    result.lights.clear();
    if (environmentFile)
      return result;
    Light sun;
    sun.direction = -glm::normalize(kDefaultTowardSun);
    sun.color = kDefaultSunColor;
    result.lights.push_back(sun);
    strongest = 1.0f;
  }
  // In double, because the factor for a faint light may overflow a float.
  const double factor = double(kKeyIrradiance) / double(strongest);
  for (Light& light : result.lights)
    light.intensity = float(double(light.intensity) * factor);
  std::stable_sort(result.lights.begin(), result.lights.end(), [&](const Light& a, const Light& b) {
    return irradianceAt(a, subject) > irradianceAt(b, subject);
  });
  // The strongest directional light comes first, because light 0 casts shadows.
  const auto sun = std::find_if(result.lights.begin(), result.lights.end(), [](const Light& light) {
    return light.kind == LightKind::directional;
  });
  if (sun != result.lights.end())
    std::rotate(result.lights.begin(), sun, sun + 1);
  if (result.lights.size() > MAX_LIGHTS) {
    result.dropped = result.lights.size() - MAX_LIGHTS;
    result.lights.resize(MAX_LIGHTS);
  }
  const Light& first = result.lights.front();
  result.hasSun = first.kind == LightKind::directional && first.intensity > 0.0f;
  if (result.hasSun)
    result.towardSun = -first.direction;
  if (!environmentFile)
    result.skyIrradiance = result.hasSun ? kSkyIrradiance : kDuskIrradiance;
  return result;
}

} // namespace lichen::renderer
