// SPDX-License-Identifier: MIT
// Camera, lights and frame index -> the uniform block; see frame_data.h.
#include "frame_data.h"

#include "directions.h"
#include "environment.h"
#include "relative_to.h"
#include "sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// Radians. Four times the real sun's radius: accounts for haze around the sun, and shows the
// penumbra of an object a metre or two across.
constexpr float kSunRadius = 0.02f;
// Sine of the lowest sky direction. Lower directions graze the ground, and its depth map would only
// alias.
constexpr float kLeastSkyHeight = 0.12f;
// Sky directions per picture, over all its frames: enough to hide the edges of single shadows, even
// in a room with a window that few directions reach.
constexpr std::uint32_t kSkyDirections = 256;

/// From clip space to the texture space of a depth map.
glm::mat4 textureFromClip() {
  glm::mat4 m(1.0f);
  m[0][0] = m[1][1] = 0.5f;
  m[3][0] = m[3][1] = 0.5f;
  return m;
}

shader::LightData lightData(const Light& light, const glm::dvec3& origin) {
  shader::LightData data{};
  const float kind = light.kind == LightKind::directional ? float(LIGHT_DIRECTIONAL)
                     : light.kind == LightKind::point     ? float(LIGHT_POINT)
                                                          : float(LIGHT_SPOT);
  constexpr float kLeastConeWidth = 1e-3f; // the bound that KHR_lights_punctual uses
  data.positionAndKind = glm::vec4(relativeTo(origin, light.position), kind);
  data.directionAndRange = glm::vec4(light.direction, light.range);
  data.color = glm::vec4(light.color * light.intensity, 0.0f);
  data.cone.x = light.outerConeCosine;
  data.cone.y = 1.0f / std::max(light.innerConeCosine - light.outerConeCosine, kLeastConeWidth);
  return data;
}

glm::vec3 tilted(glm::vec3 direction, glm::vec2 disc, float radius) {
  const glm::mat3 frame = frameAlong(direction);
  return glm::normalize(direction + radius * (frame[0] * disc.x + frame[1] * disc.y));
}

/// Point i of a uniform distribution over the sky above kLeastSkyHeight.
glm::vec3 skyDirection(std::uint32_t i) {
  const glm::vec2 p = spreadPoint(i);
  const float height = kLeastSkyHeight + (1.0f - kLeastSkyHeight) * p.x;
  const float across = std::sqrt(1.0f - height * height);
  return {across * std::cos(2.0f * kPi * p.y), height, across * std::sin(2.0f * kPi * p.y)};
}

void fillLights(const FrameInputs& inputs, std::uint32_t index, FrameView& view) {
  const Lighting& lighting = inputs.lighting;
  view.data.counts.x = int(lighting.lights.size());
  for (std::size_t i = 0; i < lighting.lights.size(); ++i)
    view.data.lights[i] = lightData(lighting.lights[i], inputs.origin);
  glm::vec3 towardSun = lighting.towardSun;
  if (inputs.frames > 1)
    towardSun = tilted(towardSun, spreadOnDisc(index), kSunRadius);
  view.clipFromWorldOfSun = clipFromWorldAlong(towardSun, inputs.subject, inputs.origin);
  view.data.sunFromWorld = textureFromClip() * view.clipFromWorldOfSun;
  view.data.environment.w = lighting.hasSun ? 1.0f : 0.0f;
  const std::uint32_t directions = inputs.skyDirections;
  view.data.counts.y = int(directions);
  for (std::uint32_t k = 0; k < directions; ++k) {
    const glm::vec3 direction = skyDirection(index * directions + k);
    view.clipFromWorldOfSky[k] = clipFromWorldAlong(direction, inputs.subject, inputs.origin);
    view.data.skyFromWorld[k] = textureFromClip() * view.clipFromWorldOfSky[k];
    view.data.skyDirection[k] = glm::vec4(direction, 0.0f);
  }
  view.data.shadow.x = 2.0f * inputs.subject.radius / float(kSunDepthSide);
  view.data.shadow.y = 2.0f * inputs.subject.radius / float(kSkyDepthSide);
}

} // namespace

std::uint32_t skyDirectionsOf(std::uint32_t frames) {
  return std::clamp((kSkyDirections + frames - 1) / frames, kLeastSkyDirections,
                    std::uint32_t(MAX_SKY_DIRECTIONS));
}

FrameView frameView(const FrameInputs& inputs, std::uint32_t index) {
  FrameView view;
  const glm::vec2 jitter = inputs.frames > 1 ? spreadPoint(index) - 0.5f : glm::vec2(0.0f);
  const glm::vec2 size(inputs.width, inputs.height);
  const glm::mat4 pose = relativeTo(inputs.origin, inputs.camera.worldFromCamera);
  const auto clipFrom = [&](const glm::dvec3& origin) {
    return clipFromWorld(inputs.camera, origin, size.x / size.y, 2.0f * jitter / size);
  };
  view.data.clipFromWorld = clipFrom(inputs.origin);
  view.data.worldFromClip = glm::inverse(clipFrom(eyeOf(inputs.camera)));
  view.data.cameraPosition = glm::vec4(glm::vec3(pose[3]), inputs.camera.perspective ? 1.0f : 0.0f);
  view.data.cameraForward = -pose[2];
  view.data.environment.x = inputs.hazeDistance > 0.0f ? 1.0f / inputs.hazeDistance : 0.0f;
  view.data.environment.y = float(kSpecularLevels - 1);
  view.data.environment.z = 1.0f / std::sqrt(float(std::min(inputs.frames, kMostSharpeningFrames)));
  fillLights(inputs, index, view);
  return view;
}

} // namespace lichen::renderer
