// SPDX-License-Identifier: MIT
// Splits an origin far away into a corner of cells, which integers hold, and the rest; the origin
// of solid noise in the space of tiles.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace lichen {

/// A place [tiles] as a multiple of `step` tiles, which is a corner of cells, and the rest.
struct SplitOrigin {
  std::int64_t tile;
  float offset;
};

inline SplitOrigin splitOrigin(std::int64_t origin, double offset, std::int64_t step) {
  const double whole = std::floor(offset);
  const std::int64_t tile = origin + std::int64_t(whole);
  const std::int64_t rest = (tile % step + step) % step;
  return {tile - rest, float(offset - whole + double(rest))};
}

/// The same of a place that is no whole number of tiles.
inline SplitOrigin splitOrigin(double origin, double offset, std::int64_t step) {
  const double whole = std::floor(origin);
  return splitOrigin(std::int64_t(whole), origin - whole + offset, step);
}

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
