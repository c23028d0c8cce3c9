// SPDX-License-Identifier: MIT
// Fills the uniform block of a frame: camera, lights, and the sky directions that the frame
// samples.
#pragma once

#include "framing.h"
#include "lighting.h"
#include "shaders/scene_interface.h"

#include <array>

namespace lichen::renderer {

// Averaging n frames takes n samples of each pixel, so texture gradients may shrink by sqrt(n).
// Beyond this n, sharper textures only add noise.
inline constexpr std::uint32_t kMostSharpeningFrames = 8;

// The minimum for a single frame: with fewer directions, the sky's shadows look like one hard
// shadow or none.
inline constexpr std::uint32_t kLeastSkyDirections = 4;

struct FrameInputs {
  Camera camera;
  glm::dvec3 origin{0.0}; ///< positions on the device are relative to this point of the world
  Sphere subject;
  Lighting lighting;
  float hazeDistance = 0.0f; ///< distance at which haze absorbs 63 % of the light; 0 for no haze
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t frames = 1;
  std::uint32_t skyDirections = 1; ///< per frame, up to MAX_SKY_DIRECTIONS
};

struct FrameView {
  shader::FrameData data{};
  glm::mat4 clipFromWorldOfSun{1.0f};
  std::array<glm::mat4, MAX_SKY_DIRECTIONS> clipFromWorldOfSky{};
};

/// Sky directions that each frame samples when a picture averages `frames` frames.
[[nodiscard]] std::uint32_t skyDirectionsOf(std::uint32_t frames);

inline constexpr std::uint32_t kSunDepthSide = 2048;
inline constexpr std::uint32_t kSkyDepthSide = 512;

/// The view of frame `index` of inputs.frames. A single frame samples pixel centres and treats the
/// sun as a point.
[[nodiscard]] FrameView frameView(const FrameInputs& inputs, std::uint32_t index);

} // namespace lichen::renderer
