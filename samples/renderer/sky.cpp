// SPDX-License-Identifier: MIT
// Sunlight scattered once in an atmosphere of even density, in closed form: by air molecules
// (Rayleigh) and by haze [Hoffman and Preetham 2002, Rendering Outdoor Light Scattering in Real
// Time, "Inscattering"]. Path lengths are relative air masses [Kasten and Young 1989, Revised
// Optical Air Mass Tables and Approximation Formula].
#include "sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// Optical depth of the whole atmosphere, straight up, at 650, 550 and 450 nm: of the air
// [Bodhaine et al. 1999, table 3, rounded], and of the haze of a clear day.
constexpr glm::vec3 kAirDepth{0.049f, 0.097f, 0.222f};
constexpr float kHazeDepth = 0.022f;
constexpr float kHazeForward = 0.76f; // g of Henyey and Greenstein
// What is scattered again comes from everywhere: a share of the light with no preferred direction.
constexpr float kDiffuseShare = 0.30f;
// Most light is scattered to the eye high in the air, before the sun's light has crossed all of it.
constexpr float kSunPath = 0.4f;
// Scattering more than once deepens the blue; here a factor of the distance from grey stands for
// it.
constexpr float kSaturation = 1.1f;
// The horizon is seen as if this much higher (sine): it would be too bright for a display.
constexpr float kHorizonLift = 0.10f;
constexpr float kLowestSunHeight = 0.05f; // sine of 3 degrees
// Light soil; what is seen below the horizon where a scene has no ground of its own.
constexpr glm::vec3 kGroundAlbedo{0.32f, 0.30f, 0.27f};
// The horizon is blended into the ground over this range of heights (sine), so that it has no edge.
constexpr float kHorizonBlend = 0.035f;

/// Length of the way through the air, in atmospheres, for the sine of a height above the horizon.
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

  // The upper half, and the irradiance that it lays on level ground.
  glm::dvec3 level(0.0);
  const double texelAngle = std::numbers::pi / height; // the same both ways
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

  // Scale and white balance.
  const auto mean = [](glm::vec3 v) { return (v.x + v.y + v.z) / 3.0f; };
  const glm::vec3 unscaled(level);
  const glm::vec3 fromSun = sunlight * towardSun.y;
  const float scale = irradiance / mean(unscaled);
  const glm::vec3 total = unscaled * scale + fromSun;
  sky.balance = mean(total) / total;
  const glm::vec3 factor = scale * sky.balance;

  // The ground gives back what falls on it.
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
