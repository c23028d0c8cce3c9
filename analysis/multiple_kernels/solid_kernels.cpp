// SPDX-License-Identifier: MIT
// A point in space and its footprint -> the sums over impacts around it. Steps and names follow
// shaders_glsl/noise/solid_kernels.glsl.
#include "solid_kernels.h"

#include "kernel_impacts.h"

#include <algorithm>
#include <cmath>

namespace lichen::multiple_kernels {
namespace {

using solid::Vec3;
using Vec2 = std::array<float, 2>;
using Waves = std::array<float, 4>;

/// A kernel in space, and where a point lies in its layers.
struct SolidKernel {
  PlacedKernel plane; ///< its window as wide as in space
  Vec2 frequency{};   ///< [cycles / tile width]; of a ring, (radius, 0)
  float aspect = 1.0f;
  bool isRing = false;
  float perLayer = 1.0f;   ///< [tile widths]
  float toWindowZ = 1.0f;  ///< from an offset in layers
  std::uint32_t layer = 0; ///< the one that holds the point
  float place = 0.0f;      ///< in it
  Vec3 cycles{};           ///< of a third frequency z: cycles[0] + z (cycles[1] + z cycles[2])
  float trace = 0.0f, determinant = 0.0f;        ///< of the window, as kernelRetained() takes them
  float depthSpread = 0.0f, planarSpread = 0.0f; ///< of the window [cycles^2 / tile width^2]

  [[nodiscard]] float retained(float z) const {
    return kernelRetained(cycles[0] + z * (cycles[1] + z * cycles[2]), trace, determinant);
  }
};

struct SolidPlace {
  KernelPlace plane;
  std::uint32_t groupZ = 0;
  float insideZ = 0.0f;
  std::array<Vec3, 2> axes{};
};

SolidPlace placeAt(const shader::LichenMaterial& material, const shader::LichenNoise& noise,
                   const SolidFootprint& at) {
  const shader::LichenKernelsMaterial own = kernelsPart(material);
  const Vec3 offset{material.offsetX, material.offsetY, own.offsetZ};
  const Vec3 position =
      solid::combined(1.0f, offset, 1.0f, solid::inTiles(at.position, material, noise));
  SolidPlace place;
  place.plane = kernelPlaceAt(material, {position[0], position[1]});
  const float inGroups = position[2] / float(kKernelTiles), group = std::floor(inGroups);
  place.insideZ = inGroups - group;
  place.groupZ = std::uint32_t(std::int32_t(group)) + std::uint32_t(own.cellK);
  place.axes = solid::footprintOf(at, material, noise);
  return place;
}

/// lichenSolidKernelAt
SolidKernel kernelAt(const KernelRow& row, bool isRing, const SolidPlace& place,
                     const shader::LichenMaterial& material, const shader::LichenNoise& noise) {
  SolidKernel kernel;
  kernel.plane = placedKernel(row, place.plane, material);
  kernel.aspect = noise.tileAspect;
  kernel.isRing = isRing;
  kernel.frequency = row.frequency;
  if (!isRing)
    kernel.frequency[1] *= kernel.aspect;
  const float layersPerTile = float(row.layers) / float(kKernelTiles);
  kernel.plane.amplitude *=
      std::sqrt(row.toWindowZ / (std::pow(kSolidWider, 3.0f) * kSolidIntegral * layersPerTile));
  kernel.perLayer = 1.0f / layersPerTile;
  const float position = place.insideZ * float(row.layers), corner = std::floor(position);
  kernel.place = position - corner;
  kernel.layer =
      std::uint32_t(std::int32_t(corner)) + place.groupZ * std::uint32_t(std::int32_t(row.layers));
  const float spread = kernelSpread(KernelWindow::gabor);
  const auto& q = row.toWindow;
  std::array<Vec3, 2> windows{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3& axis = place.axes[k];
    windows[k] = {q[0] * axis[0] + q[1] * axis[1], q[2] * axis[0] + q[3] * axis[1],
                  row.toWindowZ * axis[2]};
    const float along = row.frequency[0] * axis[0] + row.frequency[1] * axis[1];
    // A ring has all directions, and half of its square along each axis.
    kernel.cycles[0] += isRing ? 0.5f * row.frequency[0] * row.frequency[0] *
                                     (axis[0] * axis[0] + axis[1] * axis[1])
                               : along * along;
    kernel.cycles[1] += isRing ? 0.0f : 2.0f * along * axis[2];
    kernel.cycles[2] += axis[2] * axis[2];
  }
  const float a = spread * solid::dot(windows[0], windows[0]);
  const float b = spread * solid::dot(windows[1], windows[1]);
  const float both = spread * solid::dot(windows[0], windows[1]);
  kernel.trace = a + b;
  kernel.determinant = a * b - both * both;
  kernel.depthSpread = spread * row.toWindowZ * row.toWindowZ;
  kernel.planarSpread =
      0.5f * spread *
      (q[0] * q[0] + q[2] * q[2] + kernel.aspect * kernel.aspect * (q[1] * q[1] + q[3] * q[3]));
  for (float& factor : kernel.plane.toWindow)
    factor /= kSolidWider;
  kernel.toWindowZ = row.toWindowZ / kSolidWider * kernel.perLayer;
  return kernel;
}

/// The mean over all third frequencies of the squared amplitude that the footprint leaves.
float retainedSquare(const SolidKernel& kernel) {
  const float most = solid::kMostDepth * std::hypot(kernel.frequency[0], kernel.frequency[1]);
  constexpr float kNode = 0.774596669f; // of Gauss's three points
  const float low = kernel.retained(-kNode * most), middle = kernel.retained(0.0f),
              high = kernel.retained(kNode * most);
  return (5.0f * low * low + 8.0f * middle * middle + 5.0f * high * high) / 18.0f;
}

/// The four waves of an impact, and the slope along z for one along x and one along y.
struct Impact {
  Waves waves{};
  Vec2 slope{};
};

/// lichenAddSolidImpact
Impact impactOf(const SolidKernel& kernel, std::uint32_t word, std::uint32_t ring, float depth,
                const Vec3& offset) {
  const auto& q = kernel.plane.toWindow;
  const Vec3 place{q[0] * offset[0] + q[1] * offset[1], q[2] * offset[0] + q[3] * offset[1],
                   kernel.toWindowZ * offset[2]};
  const float left = std::max(1.0f - solid::dot(place, place), 0.0f);
  Impact impact;
  if (left == 0.0f)
    return impact;
  Vec2 planar = kernel.frequency;
  if (kernel.isRing) {
    const Vec2 direction = ringDirection(ring);
    planar = {kernel.frequency[0] * direction[0],
              kernel.aspect * kernel.frequency[0] * direction[1]};
  }
  const float square = planar[0] * planar[0] + planar[1] * planar[1];
  const float z = solid::kMostDepth * depth * std::sqrt(square);
  const float turns = planar[0] * offset[0] * kernel.plane.perCell[0] +
                      planar[1] * offset[1] * kernel.plane.perCell[1] / kernel.aspect +
                      z * offset[2] * kernel.perLayer + kernelPhase(word);
  const float value = left * left * left * kernel.retained(z);
  impact.waves = kernelWaves(value * cosineOfTurns(turns), word);
  const float ratio = std::sqrt((z * z + kernel.depthSpread) / (square + kernel.planarSpread));
  const float x = planar[0] + 1e-6f; // the slope of a kernel without a wave lies along x
  const float perSlope = (depth < 0.0f ? -ratio : ratio) / std::hypot(x, planar[1]);
  impact.slope = {perSlope * x, -perSlope * planar[1]};
  return impact;
}

/// Calls act(impact) for each impact in the cells that the support may reach.
template <class Act>
void forEachImpact(const SolidKernel& kernel, std::uint32_t seed, const Act& act) {
  const auto& q = kernel.plane.toWindow;
  const float xx = q[0] * q[0] + q[2] * q[2], xy = q[0] * q[1] + q[2] * q[3],
              yy = q[1] * q[1] + q[3] * q[3];
  const float perY = yy - xy * xy / xx, perZ = kernel.toWindowZ * kernel.toWindowZ;
  const float reachY = 1.0f / std::sqrt(perY), reachZ = 1.0f / kernel.toWindowZ;
  const float shear = xy / xx;
  const Vec2& place = kernel.plane.place;
  for (int k = int(std::floor(kernel.place - reachZ)); k <= int(std::floor(kernel.place + reachZ));
       ++k)
    for (int j = int(std::floor(place[1] - reachY)); j <= int(std::floor(place[1] + reachY)); ++j) {
      const float lowY = place[1] - float(j) - 1.0f, lowZ = kernel.place - float(k) - 1.0f;
      const float nearY = std::clamp(0.0f, lowY, lowY + 1.0f);
      const float nearZ = std::clamp(0.0f, lowZ, lowZ + 1.0f);
      const float rest = 1.0f - nearY * nearY * perY - nearZ * nearZ * perZ;
      if (rest <= 0.0f)
        continue;
      const float chord = std::sqrt(rest / xx);
      const float middleLow = -shear * lowY, middleHigh = -shear * (lowY + 1.0f);
      const int end = int(std::floor(place[0] - std::min(middleLow, middleHigh) + chord));
      const std::uint32_t layer = kernel.layer + std::uint32_t(k), layerSeed = pcg(seed + layer);
      for (int i = int(std::floor(place[0] - std::max(middleLow, middleHigh) - chord)); i <= end;
           ++i) {
        const std::uint32_t column = kernel.plane.corner[0] + std::uint32_t(i),
                            row = kernel.plane.corner[1] + std::uint32_t(j);
        const std::uint32_t word = vertexHash(column, row, layerSeed);
        const std::uint32_t other = pcg(~word);
        const float above = (float(other >> 16) + 0.5f) * 0x1p-16f;
        const std::array<float, 2> inCell = placeOfImpact(word);
        act(impactOf(kernel, word, ringTurns(column, row, seed + layer * 0xABC98389u),
                     float(std::int32_t(other << 16)) * 0x1p-31f,
                     {place[0] - float(i) - inCell[0], place[1] - float(j) - inCell[1],
                      kernel.place - float(k) - above}));
      }
    }
}

} // namespace

solid::Sum solidSumAt(std::span<const KernelRow> rows, const shader::LichenNoise& noise,
                      const shader::LichenMap& map, const shader::LichenMaterial& material,
                      const SolidFootprint& at) {
  const shader::LichenKernelsNoise shared = kernelsPart(noise);
  const SolidPlace place = placeAt(material, noise, at);
  solid::Sum sum;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KernelRow& row = rows[k];
    const SolidKernel kernel =
        kernelAt(row, k >= shared.kernels - shared.rings, place, material, noise);
    const float own = kernelSquares(row);
    sum.squares += own;
    sum.lost += own * (1.0f - retainedSquare(kernel));
    if (own == 0.0f)
      continue;
    Waves waves{}, depthX{}, depthY{};
    forEachImpact(kernel, pcg(material.seedWord + std::uint32_t(k)), [&](const Impact& impact) {
      for (std::size_t s = 0; s < waves.size(); ++s) {
        waves[s] += impact.waves[s];
        depthX[s] += impact.slope[0] * impact.waves[s];
        depthY[s] += impact.slope[1] * impact.waves[s];
      }
    });
    for (std::size_t s = 0; s < waves.size(); ++s) {
      const float amplitude = kernel.plane.amplitude;
      for (std::size_t c = 0; c < 3; ++c)
        sum.gaussian[c] += amplitude * row.colors[c][s] * waves[s];
      const float x = map.row0.x * row.colors[0][s] + map.row0.y * row.colors[1][s];
      const float y = map.row1.x * row.colors[0][s] + map.row1.y * row.colors[1][s];
      sum.depthSlope += amplitude * (x * depthX[s] + y * depthY[s]);
    }
  }
  return sum;
}

} // namespace lichen::multiple_kernels
