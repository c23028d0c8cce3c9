// SPDX-License-Identifier: MIT
// The impacts of one kernel that may reach a point: the CPU twin of lichenKernelAt and
// lichenKernelSums (shaders_glsl/noise/multiple_kernels.glsl).
#pragma once

#include "sampling/wave.h"

#include <lichen/lattice.h>
#include <lichen/multiple_kernels_map.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace lichen::multiple_kernels {

/// Where a point lies: the group of kKernelTiles tiles, modulo 2^32, and the place in it, or the
/// place in the period.
struct KernelPlace {
  std::array<std::uint32_t, 2> group{};
  std::array<float, 2> inside{}; ///< [0, 1)
};
[[nodiscard]] inline KernelPlace kernelPlaceAt(const shader::LichenMaterial& material,
                                               const std::array<float, 2>& position) {
  const bool isPeriodic = material.periodRows != 0;
  const std::array<float, 2> tiles{isPeriodic ? material.periodTilesX : float(kKernelTiles),
                                   isPeriodic ? material.periodTilesY : float(kKernelTiles)};
  const std::array<std::int32_t, 2> origin{material.cellI, material.cellJ};
  KernelPlace place;
  for (std::size_t k = 0; k < 2; ++k) {
    const float at = position[k] / tiles[k];
    const float group = std::floor(at);
    place.inside[k] = at - group;
    place.group[k] = std::uint32_t(std::int32_t(group)) + std::uint32_t(origin[k]);
  }
  return place;
}

/// A kernel and the cell of its grid that holds a point. Offsets are in cells.
struct PlacedKernel {
  std::array<float, 2> perCell{};        ///< [tiles] sides of a cell
  std::array<float, 4> toWindow{};       ///< from an offset in cells, row by row
  std::array<std::uint32_t, 2> corner{}; ///< the cell
  std::array<float, 2> place{};          ///< in it, [0, 1)
  std::array<std::int32_t, 2> period{};  ///< [cells]; 0 without one
  float amplitude = 0.0f;
};
[[nodiscard]] inline PlacedKernel placedKernel(const KernelRow& row, const KernelPlace& at,
                                               const shader::LichenMaterial& material) {
  PlacedKernel kernel;
  const std::array<int, 2> own{row.columns, row.rows};
  const std::array<float, 2> tiles{material.periodTilesX, material.periodTilesY};
  constexpr float kOfWave = 1.41421356f; // whose square is 1 in the mean
  kernel.amplitude = kOfWave * row.amplitude;
  float fitted = 1.0f;
  for (std::size_t k = 0; k < 2; ++k) {
    auto cells = float(own[k]);
    float perTile = cells / float(kKernelTiles);
    if (material.periodRows != 0) {
      cells = std::max(std::floor(perTile * tiles[k] + 0.5f), 1.0f);
      kernel.period[k] = std::int32_t(cells);
      fitted *= perTile / (cells / tiles[k]);
      perTile = cells / tiles[k];
    }
    const float position = at.inside[k] * cells;
    const float corner = std::floor(position);
    kernel.place[k] = position - corner;
    kernel.corner[k] = std::uint32_t(std::int32_t(corner));
    if (material.periodRows == 0)
      kernel.corner[k] += at.group[k] * std::uint32_t(std::int32_t(cells));
    kernel.perCell[k] = 1.0f / perTile;
  }
  kernel.amplitude *= std::sqrt(fitted);
  for (std::size_t i = 0; i < 4; ++i)
    kernel.toWindow[i] = row.toWindow[i] * kernel.perCell[i % 2];
  return kernel;
}

/// lichenKernelPlace: of an impact in its cell.
inline std::array<float, 2> placeOfImpact(std::uint32_t word) {
  constexpr float kStep = 1.0f / 2048.0f; // 11 bits per axis
  return {(float(word >> 21) + 0.5f) * kStep, (float(word >> 10 & 2047u) + 0.5f) * kStep};
}

/// lichenRingTurns [2^-32 turns]
inline std::uint32_t ringTurns(std::uint32_t column, std::uint32_t row, std::uint32_t seed) {
  return column * 0xC13FA9A9u + row * 0x91E10DA5u + seed;
}

/// lichenRingDirection
inline std::array<float, 2> ringDirection(std::uint32_t turns) {
  const float direction = float(std::int32_t(turns)) * 0x1p-32f;
  return {cosineOfTurns(direction), cosineOfTurns(direction - 0.25f)};
}

/// lichenKernelPhase [turns]
inline float kernelPhase(std::uint32_t word) { return (word >> 4 & 1u) != 0 ? 0.125f : -0.125f; }

/// lichenKernelWaves
inline std::array<float, 4> kernelWaves(float wave, std::uint32_t word) {
  std::array<float, 4> waves{};
  for (std::size_t s = 0; s < waves.size(); ++s)
    waves[s] = (word >> s & 1u) != 0 ? -wave : wave;
  return waves;
}

/// Calls act(word, direction of a ring [2^-32 turns], offset from the impact to the point [cells])
/// for each impact in the cells that the support may reach.
template <class Act>
void forEachKernelImpact(const PlacedKernel& kernel, bool isDisk, std::uint32_t seed,
                         const Act& act) {
  const auto& q = kernel.toWindow;
  const float xx = q[0] * q[0] + q[2] * q[2], xy = q[0] * q[1] + q[2] * q[3],
              yy = q[1] * q[1] + q[3] * q[3];
  const float determinant = xx * yy - xy * xy;
  const float reachY = isDisk ? std::sqrt(xx / determinant) : 1.0f / std::abs(q[3]);
  const float shear = isDisk ? xy / xx : 0.0f;
  const auto wrapped = [](std::uint32_t cell, std::int32_t period) {
    if (period == 0)
      return cell;
    const std::int32_t rest = std::int32_t(cell) % period;
    return std::uint32_t(rest < 0 ? rest + period : rest);
  };
  const int last = int(std::floor(kernel.place[1] + reachY));
  for (int j = int(std::floor(kernel.place[1] - reachY)); j <= last; ++j) {
    const float low = kernel.place[1] - float(j) - 1.0f, high = kernel.place[1] - float(j);
    const float near = std::clamp(0.0f, low, high);
    const float chord =
        std::sqrt(std::max(1.0f - (isDisk ? near * near * determinant / xx : 0.0f), 0.0f) / xx);
    const float middleLow = -shear * low, middleHigh = -shear * high;
    const int end = int(std::floor(kernel.place[0] - std::min(middleLow, middleHigh) + chord));
    const std::uint32_t row = wrapped(kernel.corner[1] + std::uint32_t(j), kernel.period[1]);
    for (int i = int(std::floor(kernel.place[0] - std::max(middleLow, middleHigh) - chord));
         i <= end; ++i) {
      const std::uint32_t column = wrapped(kernel.corner[0] + std::uint32_t(i), kernel.period[0]);
      const std::uint32_t word = vertexHash(column, row, seed);
      const std::array<float, 2> place = placeOfImpact(word);
      act(word, ringTurns(column, row, seed),
          std::array<float, 2>{kernel.place[0] - float(i) - place[0],
                               kernel.place[1] - float(j) - place[1]});
    }
  }
}

/// lichenKernelRetained
inline float kernelRetained(float cycles, float trace, float determinant) {
  constexpr float kSlope = 6.57973627f, kFaint = 0.3f;
  const float wider = std::sqrt(std::max(1.0f + kSlope * (trace + kSlope * determinant), 1.0f));
  return std::max((1.0f + kFaint) * retainedAt(cycles / wider) / std::sqrt(wider) - kFaint, 0.0f);
}

/// lichenKernelSpread
inline float kernelSpread(KernelWindow window) {
  if (window == KernelWindow::gabor)
    return 0.106387243f;
  return window == KernelWindow::sinc ? 0.297779771f : 0.292652321f;
}

/// lichenKernelRetained of a row
inline float kernelRetained(const KernelRow& row, bool isRing, const WaveFootprint& footprint,
                            KernelWindow window) {
  const auto& q = row.toWindow;
  const float xx = q[0] * q[0] + q[2] * q[2], yy = q[1] * q[1] + q[3] * q[3],
              xy = q[0] * q[1] + q[2] * q[3];
  const auto [fx, fy] = row.frequency;
  const float spread = kernelSpread(window);
  // A ring has all directions, and half of its square along each axis.
  const float cycles =
      isRing ? 0.5f * fx * fx * (footprint.xx + footprint.yy) : footprint.squaredCycles(fx, fy);
  const float area = spread * (q[0] * q[3] - q[1] * q[2]);
  return kernelRetained(
      cycles, spread * (footprint.xx * xx + footprint.yy * yy + footprint.xy * xy),
      area * area * (footprint.xx * footprint.yy - 0.25f * footprint.xy * footprint.xy));
}

/// lichenKernelSquares
inline float kernelSquares(const KernelRow& row) {
  float squares = 0.0f;
  for (const std::array<float, 4>& color : row.colors)
    for (const float factor : color)
      squares += factor * factor;
  return squares;
}

/// lichenKernelSinc
inline float kernelSinc(float t) {
  constexpr float kPerTurn = 0.159154943f, kLeast = 1e-3f;
  return std::abs(t) < kLeast ? 1.0f : cosineOfTurns(t - 0.25f) * kPerTurn / t;
}

/// lichenKernelSincSlope
inline float kernelSincSlope(float t) {
  constexpr float kLeast = 0.1f, kRadians = 6.28318531f;
  const float x = kRadians * t, square = x * x;
  const float near = kRadians * x * (square * (1.0f / 30.0f - square / 840.0f) - 1.0f / 3.0f);
  return std::abs(t) < kLeast ? near : (cosineOfTurns(t) - kernelSinc(t)) / t;
}

/// lichenKernelWindowSlope
inline std::array<float, 2> kernelWindowSlope(float p, float q, KernelWindow window) {
  if (window == KernelWindow::gabor) {
    const float left = std::max(1.0f - p * p - q * q, 0.0f);
    return {-6.0f * left * left * p, -6.0f * left * left * q};
  }
  const std::array<float, 2> place{p, q};
  std::array<float, 2> sinc{}, slope{};
  for (std::size_t k = 0; k < 2; ++k) {
    const float left = std::max(1.0f - place[k] * place[k], 0.0f);
    if (left == 0.0f)
      return {};
    sinc[k] = kernelSinc(place[k]);
    slope[k] = kernelSincSlope(place[k]);
    if (window == KernelWindow::gaussianSinc) {
      slope[k] = left * (left * slope[k] - 4.0f * place[k] * sinc[k]);
      sinc[k] *= left * left;
    }
  }
  return {slope[0] * sinc[1], slope[1] * sinc[0]};
}

/// lichenKernelWindow
inline float kernelWindow(float p, float q, KernelWindow window) {
  if (window == KernelWindow::gabor) {
    const float left = std::max(1.0f - p * p - q * q, 0.0f);
    return left * left * left;
  }
  const float leftP = std::max(1.0f - p * p, 0.0f), leftQ = std::max(1.0f - q * q, 0.0f);
  if (leftP * leftQ == 0.0f)
    return 0.0f;
  const float product = kernelSinc(p) * kernelSinc(q), taper = leftP * leftQ;
  return window == KernelWindow::sinc ? product : product * taper * taper;
}

} // namespace lichen::multiple_kernels
