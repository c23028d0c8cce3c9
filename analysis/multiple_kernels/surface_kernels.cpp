// SPDX-License-Identifier: MIT
// A point of a surface and its footprint -> the sums over impacts around it. Steps and names follow
// shaders_glsl/noise/surface_kernels.glsl.
#include "surface_kernels.h"

#include "kernel_impacts.h"
#include "sampling/surface_cubes.h"

#include <algorithm>
#include <cmath>

namespace lichen::multiple_kernels {
namespace {

using surface::Vec3;
using Waves = std::array<float, 4>;

/// Where a point lies among groups of kKernelTiles tile widths, and its frame.
struct SurfacePlace {
  std::array<std::uint32_t, 3> group{};
  Vec3 inside{}; ///< [0, 1)
  surface::Point point;
};

SurfacePlace placeAt(const surface::Point& point, const shader::LichenMaterial& material) {
  const shader::LichenKernelsMaterial own = kernelsPart(material);
  const Vec3 offset{material.offsetX, material.offsetY, own.offsetZ};
  const std::array<std::int32_t, 3> origin{material.cellI, material.cellJ, own.cellK};
  SurfacePlace place;
  place.point = point;
  for (std::size_t k = 0; k < 3; ++k) {
    const float at = (point.position[k] + offset[k]) / float(kKernelTiles);
    const float group = std::floor(at);
    place.inside[k] = at - group;
    place.group[k] = std::uint32_t(std::int32_t(group)) + std::uint32_t(origin[k]);
  }
  return place;
}

/// lichenKernelCubes
surface::Cubes cubesOf(const KernelRow& row, const SurfacePlace& place, float aspect,
                       float greatestHeight, std::uint32_t seed) {
  const auto count = float(row.cubes);
  const float side = float(kKernelTiles) / count;
  const auto& q = row.toWindow;
  const auto& [position, right, down, outward, plane] = place.point;
  surface::Cubes cubes;
  cubes.axes = {space::combined(side * q[0], right, side * aspect * q[1], down),
                space::combined(side * q[2], right, side * aspect * q[3], down),
                space::scaled(side / greatestHeight, outward)};
  cubes.radius = {1.0f, 1.0f, 1.0f};
  cubes.seed = seed;
  Vec3 inside{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float grid = place.inside[k] * count;
    const float corner = std::floor(grid);
    inside[k] = grid - corner;
    cubes.cell[k] = std::uint32_t(std::int32_t(corner)) + place.group[k] * std::uint32_t(row.cubes);
  }
  surface::place(cubes, inside, {});
  return cubes;
}

/// lichenSurfaceKernelSums
Waves sumsOf(const KernelRow& row, bool isRing, const SurfacePlace& place, float aspect,
             std::uint32_t seed, KernelWindow window) {
  const auto& q = row.toWindow;
  const float determinant = q[0] * q[3] - q[1] * q[2];
  const float supportArea = (window == KernelWindow::gabor ? 3.14159265f : 4.0f) /
                            (std::abs(determinant) * aspect); // [tile widths^2]
  const float thickness = std::sqrt(supportArea);
  const float cellsPerTile =
      float(row.columns) * float(row.rows) / float(kKernelTiles * kKernelTiles);
  const float density = std::pow(float(row.cubes) / float(kKernelTiles), 3.0f);
  constexpr float kOfWave = 1.41421356f;
  const float amplitude =
      kOfWave * row.amplitude * std::sqrt(3.0f * cellsPerTile * aspect / (density * thickness));
  // The wave in the window's coordinates.
  const auto inWindow = [&](const std::array<float, 2>& f) {
    return std::array<float, 2>{(f[0] * q[3] - f[1] * q[2]) / determinant,
                                (f[1] * q[0] - f[0] * q[1]) / determinant};
  };
  const std::array<float, 2> own = inWindow(row.frequency);
  Waves sums{};
  surface::forEachImpact(
      cubesOf(row, place, aspect, 0.5f * thickness, seed), [&](const surface::Impact& impact) {
        const std::uint32_t word = pcg(~impact.word);
        std::array<float, 2> frequency = own;
        if (isRing) {
          const std::array<float, 2> direction = ringDirection(
              ringTurns(impact.cell[0], impact.cell[1], seed + impact.cell[2] * 0xABC98389u));
          frequency = inWindow({row.frequency[0] * direction[0], row.frequency[0] * direction[1]});
        }
        const auto& [p, r] = impact.offset;
        const float turns = frequency[0] * p + frequency[1] * r + kernelPhase(word);
        const Waves waves =
            kernelWaves(impact.weight * kernelWindow(p, r, window) * cosineOfTurns(turns), word);
        for (std::size_t s = 0; s < sums.size(); ++s)
          sums[s] += amplitude * waves[s];
      });
  return sums;
}

} // namespace

std::array<float, 4> surfaceGaussianAt(std::span<const KernelRow> rows,
                                       const shader::LichenNoise& noise,
                                       const shader::LichenMaterial& material,
                                       const SurfaceFootprint& at) {
  const shader::LichenKernelsNoise shared = kernelsPart(noise);
  const auto window = KernelWindow(shared.window);
  const surface::Point point = surface::pointAt(at, material, noise);
  const SurfacePlace place = placeAt(point, material);
  const WaveFootprint footprint = waveFootprint(point.plane, noise);
  std::array<float, 3> sum{};
  float squares = 0.0f, lost = 0.0f;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KernelRow& row = rows[k];
    const bool isRing = k >= shared.kernels - shared.rings;
    const float retained = kernelRetained(row, isRing, footprint, window);
    const float own = kernelSquares(row);
    squares += own;
    lost += own * (1.0f - retained * retained);
    if (retained == 0.0f || own == 0.0f)
      continue;
    const Waves waves = sumsOf(row, isRing, place, noise.tileAspect,
                               pcg(material.seedWord + std::uint32_t(k)), window);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t s = 0; s < waves.size(); ++s)
        sum[c] += retained * row.colors[c][s] * waves[s];
  }
  constexpr float kLeast = 1e-20f; // of a map that does not vary
  return {0.5f + material.contrast * sum[0], 0.5f + material.contrast * sum[1],
          0.5f + material.contrast * sum[2], lost / std::max(squares, kLeast)};
}

} // namespace lichen::multiple_kernels
