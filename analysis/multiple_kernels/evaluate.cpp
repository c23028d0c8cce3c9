// SPDX-License-Identifier: MIT
// Multiple-kernels noise on the CPU: (tables, parameters, footprint) -> value. Steps and names
// follow shaders_glsl/noise/multiple_kernels.glsl.
#include "gaussianization/value_decoder.h"
#include "kernel_impacts.h"
#include "kernel_pattern.h"
#include "solid_kernels.h"
#include "surface_kernels.h"
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

/// The sums over impacts of their four waves, and derivatives of these along x and y [1 / cell].
struct KernelSums {
  std::array<float, 4> waves{}, alongX{}, alongY{};
};

/// lichenAddKernelImpact
void addImpact(KernelSums& sums, std::uint32_t word, std::uint32_t ring,
               const std::array<float, 2>& offset, const KernelRow& row, const PlacedKernel& kernel,
               bool isRing, KernelWindow window, bool hasSlopes) {
  const auto& q = kernel.toWindow;
  const std::array<float, 2> place{q[0] * offset[0] + q[1] * offset[1],
                                   q[2] * offset[0] + q[3] * offset[1]};
  const float value = kernelWindow(place[0], place[1], window);
  if (value == 0.0f && !hasSlopes)
    return;
  std::array<float, 2> frequency = row.frequency;
  if (isRing) {
    const std::array<float, 2> direction = ringDirection(ring);
    frequency = {row.frequency[0] * direction[0], row.frequency[0] * direction[1]};
  }
  for (std::size_t k = 0; k < 2; ++k)
    frequency[k] *= kernel.perCell[k];
  const float turns = frequency[0] * offset[0] + frequency[1] * offset[1] + kernelPhase(word);
  const float wave = cosineOfTurns(turns);
  const auto add = [&](std::array<float, 4>& to, float of) {
    const std::array<float, 4> waves = kernelWaves(of, word);
    for (std::size_t s = 0; s < to.size(); ++s)
      to[s] += waves[s];
  };
  add(sums.waves, value * wave);
  if (!hasSlopes)
    return;
  const std::array<float, 2> ofWindow = kernelWindowSlope(place[0], place[1], window);
  const float turned = 6.28318531f * value * cosineOfTurns(turns + 0.25f);
  add(sums.alongX, (ofWindow[0] * q[0] + ofWindow[1] * q[2]) * wave + turned * frequency[0]);
  add(sums.alongY, (ofWindow[0] * q[1] + ofWindow[1] * q[3]) * wave + turned * frequency[1]);
}

/// A Gaussian value and its derivatives along x and y [1 / tile].
struct Gradient {
  Value gaussian{};
  std::array<float, 3> alongX{}, alongY{};
};

/// lichenKernelsGaussian
Gradient gradientAt(const std::vector<KernelRow>& rows, const std::vector<PatternCosine>& pattern,
                    const shader::LichenNoise& noise, const shader::LichenMaterial& material,
                    const TileFootprint& at, bool hasSlopes) {
  const shader::LichenKernelsNoise shared = kernelsPart(noise);
  const auto window = KernelWindow(shared.window);
  const WaveFootprint footprint = waveFootprint(at, noise);
  const KernelPlace place = kernelPlaceAt(material, positionOf(at, material));
  Gradient result;
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
    const PlacedKernel kernel = placedKernel(row, place, material);
    KernelSums sums;
    forEachKernelImpact(
        kernel, window == KernelWindow::gabor, pcg(material.seedWord + std::uint32_t(k)),
        [&](std::uint32_t word, std::uint32_t ring, const std::array<float, 2>& offset) {
          addImpact(sums, word, ring, offset, row, kernel, isRing, window, hasSlopes);
        });
    const float amplitude = retained * kernel.amplitude;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t s = 0; s < sums.waves.size(); ++s) {
        const float factor = amplitude * row.colors[c][s];
        sum[c] += factor * sums.waves[s];
        result.alongX[c] += factor / kernel.perCell[0] * sums.alongX[s];
        result.alongY[c] += factor / kernel.perCell[1] * sums.alongY[s];
      }
  }
  const PatternSum own = patternAt(pattern, place, footprint, material);
  for (std::size_t c = 0; c < 3; ++c) {
    sum[c] += own.gaussian[c];
    result.alongX[c] += own.alongX[c];
    result.alongY[c] += own.alongY[c];
  }
  squares += own.squares;
  lost += own.lost;
  constexpr float kLeast = 1e-20f; // of a map that does not vary
  result.gaussian = {0.5f + material.contrast * sum[0], 0.5f + material.contrast * sum[1],
                     0.5f + material.contrast * sum[2], lost / std::max(squares, kLeast)};
  return result;
}

} // namespace

struct MultipleKernelsEvaluator::Map {
  gaussianization::ValueDecoder decoder;
  std::vector<KernelRow> rows;
  std::vector<PatternCosine> pattern;
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
    const auto& shared = noise.as<MultipleKernelsNoise>();
    auto maps = std::make_shared<std::vector<Map>>();
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const auto& stored = noise.maps[m].as<MultipleKernelsMap>();
      maps->push_back(
          {gaussianization::ValueDecoder(bundle, shaderMap(bundle, noise, m), stored.inverseTable),
           kernelRows(bundle.tables[stored.kernels], shared),
           patternCosines(bundle.tables[stored.kernels], shared)});
    }
    return MultipleKernelsEvaluator(shaderNoise(bundle, noiseIndex), std::move(maps));
  });
}

std::size_t MultipleKernelsEvaluator::mapCount() const { return maps_->size(); }

Value MultipleKernelsEvaluator::gaussian(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const TileFootprint& at) const {
  return gradientAt((*maps_)[mapIndex].rows, (*maps_)[mapIndex].pattern, noise_, material, at,
                    false)
      .gaussian;
}

std::array<float, 3> MultipleKernelsEvaluator::gradient(std::size_t mapIndex,
                                                        const shader::LichenMaterial& material,
                                                        const TileFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  const Gradient here = gradientAt(map.rows, map.pattern, noise_, material, at, true);
  return map.decoder.gradient(here.gaussian, here.alongX, here.alongY, material.contrast);
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

Value MultipleKernelsEvaluator::gaussian(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const SolidFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  return solid::gaussianOf(solidSumAt(map.rows, noise_, map.decoder.constants(), material, at),
                           material);
}

Value MultipleKernelsEvaluator::evaluate(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const SolidFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  return solid::valueOf(solidSumAt(map.rows, noise_, map.decoder.constants(), material, at),
                        map.decoder, material);
}

Value MultipleKernelsEvaluator::gaussian(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const SurfaceFootprint& at) const {
  return surfaceGaussianAt((*maps_)[mapIndex].rows, noise_, material, at);
}

Value MultipleKernelsEvaluator::evaluate(std::size_t mapIndex,
                                         const shader::LichenMaterial& material,
                                         const SurfaceFootprint& at) const {
  return (*maps_)[mapIndex].decoder.decode(gaussian(mapIndex, material, at), material.contrast);
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
                        [&](std::uint32_t, std::uint32_t, const std::array<float, 2>& offset) {
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
