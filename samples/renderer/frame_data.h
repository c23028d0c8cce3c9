// SPDX-License-Identifier: MIT
// The uniform block of each frame: camera, lights, and the directions that the frame looks into.
#pragma once

#include "framing.h"
#include "lighting.h"
#include "shaders/scene_interface.h"

#include <array>

namespace lichen::renderer {

// Averaging n frames takes n samples of a pixel, so each may be sharper by sqrt(n); beyond this
// many nothing is gained but noise.
inline constexpr std::uint32_t kMostSharpeningFrames = 8;

// Fewer, in a frame that is soon followed by others, would leave all of it in one shadow or none.
inline constexpr std::uint32_t kLeastSkyDirections = 4;

struct FrameInputs {
  Camera camera;
  glm::dvec3 origin{0.0}; ///< that everything is drawn relative to
  Sphere subject;
  Lighting lighting;
  float hazeDistance = 0.0f; ///< over which haze takes 63 %; 0 for none
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t frames = 1;
  std::uint32_t skyDirections = 1; ///< that each frame looks in, up to MAX_SKY_DIRECTIONS
};

struct FrameView {
  shader::FrameData data{};
  glm::mat4 clipFromWorldOfSun{1.0f};
  std::array<glm::mat4, MAX_SKY_DIRECTIONS> clipFromWorldOfSky{};
};

/// Of each of the frames of a picture.
[[nodiscard]] std::uint32_t skyDirectionsOf(std::uint32_t frames);

inline constexpr std::uint32_t kSunDepthSide = 2048;
inline constexpr std::uint32_t kSkyDepthSide = 512;

/// Frame `index` of inputs.frames. A single frame looks through pixel centres at an undivided sun.
[[nodiscard]] FrameView frameView(const FrameInputs& inputs, std::uint32_t index);

} // namespace lichen::renderer
