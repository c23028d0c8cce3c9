// SPDX-License-Identifier: MIT
// The origin of solid noise in the space of tiles.
#pragma once

#include "split_origin.h"

#include <lichen/shader_parameters.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace lichen {

/// The host's tile origin in the axes of the exemplar: to its right, down and along z, in tiles,
/// along z as long as wide. Each as a multiple of `step` tiles and the rest.
inline std::array<SplitOrigin, 3> solidOrigin(const shader::LichenNoise& noise,
                                              const MaterialNoise& material,
                                              const Placement& placement, std::int64_t step) {
  // The exemplar lies as on the plane that looks along z, to the right and down. It may be rotated
  // and not square; tiles of the origin are cubes.
  const double right = double(placement.tileOriginX), downward = -double(placement.tileOriginY);
  const double cosine = std::cos(material.rotation), sine = std::sin(material.rotation);
  const double aspect = double(noise.tileTexelsX) / double(noise.tileTexelsY);
  return {splitOrigin(cosine * right + sine * downward, material.offset[0], step),
          splitOrigin(aspect * (cosine * downward - sine * right), material.offset[1], step),
          splitOrigin(placement.tileOriginZ, 0.0, step)};
}

} // namespace lichen
