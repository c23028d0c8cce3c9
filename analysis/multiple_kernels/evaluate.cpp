// SPDX-License-Identifier: MIT
// Multiple-kernels noise on the CPU: (tables, parameters, footprint) -> value. Steps and names
// follow shaders_glsl/noise/multiple_kernels.glsl.
#include "gaussianization/value_decoder.h"
#include "kernel_impacts.h"
#include "triplanar/planes.h"

#include <lichen/multiple_kernels_evaluate.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lichen {
namespace {

using namespace multiple_kernels;

using Value = MultipleKernelsEvaluator::Value;

std::array<float, 2> positionOf(const TileFootprint& at, const shader::LichenMaterial& material) {
  return {at.position[0] + material.offsetX, at.position[1] + material.offsetY};
}

/// The squared cycles that a footprint spans of a kernel. [tiles]
float squaredCyclesOf(const WaveFootprint& footprint, const KernelRow& row, bool isRing) {
  const auto& q = row.toWindow;
  const float xx = q[0] * q[0] + q[2] * q[2], yy = q[1] * q[1] + q[3] * q[3],
              xy = q[0] * q[1] + q[2] * q[3];
  const auto [fx, fy] = row.frequency;
  // A ring has all directions, and half of its square along each axis.
  const float ofFrequency =
      isRing ? 0.5f * fx * fx * (footprint.xx + footprint.yy) : footprint.squaredCycles(fx, fy);
  return ofFrequency + row.spread * (footprint.xx * xx + footprint.yy * yy + footprint.xy * xy);
}

/// The cosine and the sine of an impact under its window.
std::array<float, 2> kernelWave(std::uint32_t word, const std::array<float, 2>& offset,
                                const KernelRow& row, const PlacedKernel& kernel, bool isRing,
                                KernelWindow window) {
  const auto& q = kernel.toWindow;
  const float value = kernelWindow(q[0] * offset[0] + q[1] * offset[1],
                                   q[2] * offset[0] + q[3] * offset[1], window);
  if (value == 0.0f)
    return {};
  const float x = offset[0] * kernel.perCell[0], y = offset[1] * kernel.perCell[1];
  float turns = row.frequency[0] * x + row.frequency[1] * y;
  if (isRing) {
    const float direction = float(pcg(word)) * 0x1p-32f;
    turns =
        row.frequency[0] * (cosineOfTurns(direction) * x + cosineOfTurns(direction - 0.25f) * y);
  }
  return {value * cosineOfTurns(turns), value * cosineOfTurns(turns - 0.25f)};
}

} // namespace

struct MultipleKernelsEvaluator::Map {
  gaussianization::ValueDecoder decoder;
  std::vector<KernelRow> rows;
};

Result<MultipleKernelsEvaluator> MultipleKernelsEvaluator::create(const Bundle& bundle,
                                                                  std::size_t noiseIndex) {
  const auto exhausted = [&] {
    return "noise " + std::to_string(noiseIndex) + ": not enough memory for its kernels";
  };
  return withinMemory(exhausted, [&]() -> Result<MultipleKernelsEvaluator> {
    if (noiseIndex >= bundle.noises.size())
      return Error{ErrorKind::usage, "noise " + std::to_string(noiseIndex) + ": the bundle has " +
                                         std::to_string(bundle.noises.size())};
    const Noise& noise = bundle.noises[noiseIndex];
    if (noise.method() != Method::multipleKernels)
      return Error{ErrorKind::usage, "noise '" + noise.name + "' has the method " +
                                         std::string(nameOf(noise.method())) +
                                         ", not multiple-kernels"};
    auto maps = std::make_shared<std::vector<Map>>();
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const auto& stored = noise.maps[m].as<MultipleKernelsMap>();
      maps->push_back(
          {gaussianization::ValueDecoder(bundle, shaderMap(bundle, noise, m), stored.inverseTable),
           kernelRows(bundle.tables[stored.kernels])});
    }
    return MultipleKernelsEvaluator(shaderNoise(bundle, noiseIndex), std::move(maps));
  });
}

std::size_t MultipleKernelsEvaluator::mapCount() const { return maps_->size(); }

Value MultipleKernelsEvaluator::gaussian(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const TileFootprint& at) const {
  const std::vector<KernelRow>& rows = (*maps_)[mapIndex].rows;
  const shader::LichenKernelsNoise shared = kernelsPart(noise_);
  const auto window = KernelWindow(shared.window);
  const WaveFootprint footprint = waveFootprint(at, noise_);
  const KernelPlace place = kernelPlaceAt(material, positionOf(at, material));
  std::array<float, 3> sum{};
  float squares = 0.0f, lost = 0.0f;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KernelRow& row = rows[k];
    const bool isRing = k >= shared.kernels - shared.rings;
    const float retained = retainedAt(squaredCyclesOf(footprint, row, isRing));
    float own = 0.0f;
    for (const std::array<float, 4>& color : row.colors)
      for (const float factor : color)
        own += factor * factor;
    squares += own;
    lost += own * (1.0f - retained * retained);
    if (retained == 0.0f)
      continue;
    const PlacedKernel kernel = placedKernel(row, place, material);
    std::array<float, 4> sums{};
    forEachKernelImpact(
        kernel, window == KernelWindow::gabor, pcg(material.seedWord + std::uint32_t(k)),
        [&](std::uint32_t word, const std::array<float, 2>& offset) {
          const auto [cosine, sine] = kernelWave(word, offset, row, kernel, isRing, window);
          for (std::size_t s = 0; s < sums.size(); ++s)
            sums[s] += ((word >> s & 1u) != 0 ? -cosine : cosine) +
                       ((word >> (s + sums.size()) & 1u) != 0 ? -sine : sine);
        });
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t s = 0; s < sums.size(); ++s)
        sum[c] += retained * kernel.amplitude * row.colors[c][s] * sums[s];
  }
  constexpr float kLeast = 1e-20f; // of a map that does not vary
  return {0.5f + material.contrast * sum[0], 0.5f + material.contrast * sum[1],
          0.5f + material.contrast * sum[2], lost / std::max(squares, kLeast)};
}

Value MultipleKernelsEvaluator::evaluate(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const TileFootprint& at) const {
  return (*maps_)[mapIndex].decoder.decode(gaussian(mapIndex, material, at), material.contrast);
}

Value MultipleKernelsEvaluator::gaussian(std::size_t mapIndex,
                                         const shader::LichenTriplanarMaterial& material,
                                         const TriplanarFootprint& at) const {
  return triplanar::blendedGaussian(
      triplanar::planesAt(at, material, noise_),
      [&](const auto& plane) { return gaussian(mapIndex, plane.material, plane.at); });
}

Value MultipleKernelsEvaluator::evaluate(std::size_t mapIndex,
                                         const shader::LichenTriplanarMaterial& material,
                                         const TriplanarFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  if (map.decoder.constants().encoding == LICHEN_ENCODING_SLOPE)
    return triplanar::blendedSlopes(
        triplanar::planesAt(at, material, noise_),
        [&](const auto& plane) { return evaluate(mapIndex, plane.material, plane.at); });
  return map.decoder.decode(gaussian(mapIndex, material, at), material.material.contrast);
}

MultipleKernelsEvaluator::Visited
MultipleKernelsEvaluator::visited(const shader::LichenMaterial& material,
                                  const TileFootprint& at) const {
  const std::vector<KernelRow>& rows = maps_->front().rows;
  const shader::LichenKernelsNoise shared = kernelsPart(noise_);
  const auto window = KernelWindow(shared.window);
  const KernelPlace place = kernelPlaceAt(material, positionOf(at, material));
  Visited result;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const PlacedKernel kernel = placedKernel(rows[k], place, material);
    forEachKernelImpact(kernel, window == KernelWindow::gabor,
                        pcg(material.seedWord + std::uint32_t(k)),
                        [&](std::uint32_t, const std::array<float, 2>& offset) {
                          ++result.cells;
                          const auto& q = kernel.toWindow;
                          if (kernelWindow(q[0] * offset[0] + q[1] * offset[1],
                                           q[2] * offset[0] + q[3] * offset[1], window) != 0.0f)
                            ++result.impacts;
                        });
  }
  return result;
}

} // namespace lichen
