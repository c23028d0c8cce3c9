// SPDX-License-Identifier: MIT
// Single scattering of sunlight in an atmosphere of constant density, in closed form, by air
// molecules (Rayleigh) and haze [Hoffman and Preetham 2002, Rendering Outdoor Light Scattering in
// Real Time, "Inscattering"]. Path lengths are relative air masses [Kasten and Young 1989, Revised
// Optical Air Mass Tables and Approximation Formula].
#include "sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// Optical depth of the whole atmosphere toward the zenith at 650, 550 and 450 nm: of air [Bodhaine
// et al. 1999, table 3, rounded], and of haze on a clear day.
constexpr glm::vec3 kAirDepth{0.049f, 0.097f, 0.222f};
constexpr float kHazeDepth = 0.022f;
constexpr float kHazeForward = 0.76f; // g of the Henyey-Greenstein phase function
// Share of the light that is scattered more than once and therefore isotropic.
constexpr float kDiffuseShare = 0.30f;
// Share of the air mass that sunlight crosses before scattering: most scattering toward the eye
// happens high in the air.
constexpr float kSunPath = 0.4f;
// Multiple scattering deepens the blue; this factor of the distance from grey approximates it.
constexpr float kSaturation = 1.1f;
// Sine. The horizon gets the radiance of directions this much higher, because its own is too bright
// for a display.
constexpr float kHorizonLift = 0.10f;
constexpr float kLowestSunHeight = 0.05f; // sine of 3 degrees
// Light soil, visible below the horizon of scenes without a ground of their own.
constexpr glm::vec3 kGroundAlbedo{0.32f, 0.30f, 0.27f};
// Sine. Sky and ground blend over this range below the horizon, which hides the edge.
constexpr float kHorizonBlend = 0.035f;

/// Relative air mass for the sine of the height above the horizon.
float airMass(float sine) {
  const float degrees = std::asin(std::clamp(sine, 0.0f, 1.0f)) * 180.0f / kPi;
  return 1.0f / (sine + 0.50572f * std::pow(degrees + 6.07995f, -1.6364f));
}

/// Radiance above the horizon for sunlight of irradiance 1 outside the atmosphere.
glm::vec3 radiance(glm::vec3 towardSun, glm::vec3 direction) {
  const float cosine = glm::dot(direction, towardSun);
  const float isotropic = 1.0f / (4.0f * kPi);
  const float rayleigh = 0.75f * (1.0f + cosine * cosine) * isotropic;
  const float g = kHazeForward;
  const float haze = (1.0f - g * g) / std::pow(1.0f + g * g - 2.0f * g * cosine, 1.5f) * isotropic;
  const glm::vec3 depth = kAirDepth + kHazeDepth;
  const glm::vec3 single = (kAirDepth * rayleigh + kHazeDepth * haze) / depth;
  const glm::vec3 phase = glm::mix(single, glm::vec3(isotropic), kDiffuseShare);
  const glm::vec3 sunlight = glm::exp(-kSunPath * depth * airMass(towardSun.y));
  const float height = std::max(direction.y, 0.0f);
  const glm::vec3 scattered =
      1.0f - glm::exp(-depth * airMass(kHorizonLift + (1.0f - kHorizonLift) * height));
  const glm::vec3 rgb = sunlight * phase * scattered;
  // IEC 61966-2-1 luminance.
  return glm::mix(glm::vec3(glm::dot(rgb, glm::vec3(0.2126f, 0.7152f, 0.0722f))), rgb, kSaturation);
}

} // namespace

glm::vec3 panoramaDirection(glm::vec2 uv) {
  const float longitude = (uv.x - 0.5f) * 2.0f * kPi;
  const float angle = uv.y * kPi;
  return {std::sin(longitude) * std::sin(angle), std::cos(angle),
          -std::cos(longitude) * std::sin(angle)};
}

glm::vec2 panoramaCoordinate(glm::vec3 d) {
  return {0.5f + std::atan2(d.x, -d.z) / (2.0f * kPi),
          std::acos(std::clamp(d.y, -1.0f, 1.0f)) / kPi};
}

Sky makeSky(glm::vec3 towardSun, glm::vec3 sunlight, float irradiance, int height) {
  towardSun.y = std::max(towardSun.y, kLowestSunHeight);
  towardSun = glm::normalize(towardSun);
  Sky sky;
  LinearImage& panorama = sky.panorama;
  panorama = LinearImage(2 * height, height, 3);
  const auto directionAt = [&](int x, int y) {
    return panoramaDirection(
        {(float(x) + 0.5f) / float(2 * height), (float(y) + 0.5f) / float(height)});
  };

  // Fill the panorama with sky, and integrate its irradiance on level ground.
  glm::dvec3 level(0.0);
  const double texelAngle = std::numbers::pi / height; // radians, in both directions
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < panorama.width; ++x) {
      const glm::vec3 direction = directionAt(x, y);
      const glm::vec3 value = radiance(towardSun, direction);
      for (int c = 0; c < 3; ++c)
        panorama.pixel(x, y)[c] = value[c];
      const double sine = std::sqrt(std::max(0.0, 1.0 - double(direction.y) * double(direction.y)));
      if (direction.y > 0.0f)
        level += glm::dvec3(value) * (double(direction.y) * sine * texelAngle * texelAngle);
    }

  // Scale to the irradiance, and balance white.
  const auto mean = [](glm::vec3 v) { return (v.x + v.y + v.z) / 3.0f; };
  const glm::vec3 unscaled(level);
  const glm::vec3 fromSun = sunlight * towardSun.y;
  const float scale = irradiance / mean(unscaled);
  const glm::vec3 total = unscaled * scale + fromSun;
  sky.balance = mean(total) / total;
  const glm::vec3 factor = scale * sky.balance;

  // The ground reflects its irradiance.
  const glm::vec3 ground = kGroundAlbedo / kPi * total * sky.balance;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < panorama.width; ++x) {
      float* pixel = panorama.pixel(x, y);
      const float above = glm::smoothstep(-kHorizonBlend, 0.0f, directionAt(x, y).y);
      for (int c = 0; c < 3; ++c)
        pixel[c] = glm::mix(ground[c], pixel[c] * factor[c], above);
    }
  return sky;
}

} // namespace lichen::renderer
