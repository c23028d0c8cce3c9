// SPDX-License-Identifier: MIT
// Points of surfaces, and uses of materials there, with which the shader is compared with its
// twins.
#pragma once

#include "plugin_host.h"

#include <lichen/surface_footprint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace lichen::test {

/// The input layout of surface_evaluate.comp.
struct SurfacePoint {
  std::array<float, 4> position{}; ///< w: 0 if the material sets the mix weight
  std::array<float, 4> gradientX{}, gradientY{}, normal{}; ///< w: mix weight, derivatives
  std::array<float, 4> tangent{};
};

/// An orthonormal frame, as an implementation of the format makes it from a normal and a tangent.
struct SurfaceFrame {
  std::array<double, 3> right{}, down{}, outward{};
};

inline SurfaceFrame frameOf(const SurfacePoint& point, double rotation) {
  using Vec = std::array<double, 3>;
  const auto dot = [](const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  SurfaceFrame f;
  Vec tangent{};
  for (std::size_t k = 0; k < 3; ++k) {
    f.outward[k] =
        double(point.normal[k]) / std::hypot(point.normal[0], point.normal[1], point.normal[2]);
    tangent[k] = double(point.tangent[k]);
  }
  Vec right{}, down{};
  const double slant = dot(tangent, f.outward);
  for (std::size_t k = 0; k < 3; ++k)
    right[k] = tangent[k] - slant * f.outward[k];
  const double length = std::sqrt(dot(right, right));
  for (std::size_t k = 0; k < 3; ++k)
    right[k] /= length;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    down[k] = -double(point.tangent[3]) * (f.outward[a] * right[b] - f.outward[b] * right[a]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    f.right[k] = std::cos(rotation) * right[k] + std::sin(rotation) * down[k];
    f.down[k] = std::cos(rotation) * down[k] - std::sin(rotation) * right[k];
  }
  return f;
}

/// Points some tiles around the origin with any frame, a quarter of them along the grid's axes.
/// Footprints range from a quarter of a texel to beyond the last mip.
inline std::vector<SurfacePoint> surfacePoints(int texelsPerTile, std::size_t count) {
  std::mt19937 generator(11u);
  std::uniform_real_distribution<float> tiles(-3.0f, 3.0f), level(-2.0f, 6.0f), weight(-0.2f, 1.2f);
  std::normal_distribution<float> gaussian;
  std::vector<SurfacePoint> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    SurfacePoint& point = points[k];
    const float pixel = std::exp2(level(generator)) / float(texelsPerTile);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = tiles(generator);
      point.normal[axis] = gaussian(generator);
      point.tangent[axis] = gaussian(generator);
      point.gradientX[axis] = pixel * gaussian(generator);
      point.gradientY[axis] = 0.3f * pixel * gaussian(generator);
    }
    if (k % 4 == 0) {
      point.normal = point.tangent = {};
      point.normal[k / 4 % 3] = k / 12 % 2 == 0 ? 2.0f : -2.0f;
      point.tangent[(k / 4 + 1 + k / 24 % 2) % 3] = 3.0f;
    }
    point.position[3] = 1.0f;
    point.tangent[3] = k % 3 == 0 ? -1.0f : 1.0f;
    point.gradientX[3] = weight(generator);
    point.gradientY[3] = weight(generator);
    point.normal[3] = weight(generator);
  }
  return points;
}

inline MaterialUse onSurface(MaterialUse use) {
  use.parameters.mapping = LICHEN_MAPPING_SURFACE;
  return use;
}

/// Uses that together change every parameter.
inline std::vector<MaterialUse> surfaceUses(const MaterialUse& own) {
  std::vector<MaterialUse> all(3, onSurface(own));
  all[1].parameters.scale = 0.8;
  all[1].parameters.rotation = 0.6;
  all[1].parameters.offset[0] = 0.25; // has no meaning in space
  all[1].parameters.seed = 4294967295u;
  all[1].parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  all[2].placement.tileOrigin[0] = -(std::int64_t(1) << 40);
  all[2].placement.tileOrigin[1] = (std::int64_t(1) << 40) - 1;
  all[2].placement.tileOrigin[2] = -77;
  all[2].parameters.contrast = 1.4;
  all[2].parameters.impacts = 4.0;
  return all;
}

inline SurfaceFootprint footprintOf(const SurfacePoint& point) {
  SurfaceFootprint at;
  std::copy_n(point.position.begin(), 3, at.position.begin());
  std::copy_n(point.gradientX.begin(), 3, at.dx.begin());
  std::copy_n(point.gradientY.begin(), 3, at.dy.begin());
  std::copy_n(point.normal.begin(), 3, at.normal.begin());
  at.tangent = point.tangent;
  return at;
}

} // namespace lichen::test
