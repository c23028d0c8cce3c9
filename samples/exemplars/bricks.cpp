// SPDX-License-Identifier: MIT
// Bricks in a running bond, with mortar.
#include "materials.h"
#include "periodic.h"

#include <algorithm>
#include <cmath>

namespace lichen::exemplars {

SrgbImage bricks(int side) {
  constexpr int kCourses = 10, kBricks = 4; // per side
  const Field grain = fractalNoise(side, {6.0f, 1.0f, 0.8f}, 31);
  const Field ragged = fractalNoise(side, {12.0f, 3.0f, 0.6f}, 32);
  const float height = float(side) / kCourses, length = float(side) / kBricks;
  return painted(side, [&](int sx, int sy) {
    const float x = pixelOf(sx) + 0.4f * ragged.at(sx, sy),
                y = pixelOf(sy) + 0.4f * ragged.at(sy, sx);
    const int course = int(std::floor(y / height));
    const float along = x + 0.5f * length * float(course & 1);
    const int brick = int(std::floor(along / length));
    const float fromEdge =
        std::min({y - height * float(course), height * float(course + 1) - y,
                  along - length * float(brick), length * float(brick + 1) - along});
    const float tone = hashed((brick + kBricks) % kBricks, (course + kCourses) % kCourses, 33);
    const Color fired = mix({0.52f, 0.24f, 0.18f}, {0.66f, 0.36f, 0.26f}, tone);
    const Color mortar{0.72f, 0.70f, 0.66f};
    return scaled(mix(mortar, fired, smoothStep(1.2f, 2.0f, fromEdge)),
                  1.0f + 0.06f * grain.at(sx, sy));
  });
}

} // namespace lichen::exemplars
