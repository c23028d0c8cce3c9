// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/multiple_kernels.glsl. Needs only the bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/solid_footprint.h>
#include <lichen/surface_footprint.h>
#include <lichen/tile_footprint.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lichen {

/// The decoded tables of one noise. Immutable: several threads may evaluate it at once.
class MultipleKernelsEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the tables of noise `noise`. Requirements and errors: as
  /// LocalRandomPhaseEvaluator::create().
  [[nodiscard]] static Result<MultipleKernelsEvaluator> create(const Bundle& bundle,
                                                               std::size_t noise);

  [[nodiscard]] std::size_t mapCount() const;

  /// Evaluates map `map`, below mapCount(), with the parameters that shaderMaterial() makes from
  /// the same bundle's noise. Values are as of TilingEvaluator::evaluate(). Time proportional to
  /// the number of impacts; no allocation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;

  /// In a solid: windows are of the kind gabor. Values are as of
  /// LocalRandomPhaseEvaluator::evaluate() in a solid.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const SolidFootprint& at) const;

  /// On a surface: impacts near the tangent plane are projected onto it.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const SurfaceFootprint& at) const;

  /// The value before decoding: Gaussian with mean 1/2 and, if no variance is lost, standard
  /// deviation 1/6. The fourth is the share of the variance lost to filtering, the mean over the
  /// channels.
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;

  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const SolidFootprint& at) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const SurfaceFootprint& at) const;

  /// The value of the map's first channel and its derivatives along x and y [1 / tile], for bumps.
  /// Derivatives of the Gaussian values are exact, derivatives of the table are differences.
  [[nodiscard]] std::array<float, 3>
  gradient(std::size_t map, const shader::LichenMaterial& material, const TileFootprint& at) const;

  /// The cells that an evaluation visits, and the impacts in them that reach the point.
  struct Visited {
    int cells = 0, impacts = 0;
  };
  [[nodiscard]] Visited visited(const shader::LichenMaterial& material,
                                const TileFootprint& at) const;

private:
  struct Map;

  MultipleKernelsEvaluator(const shader::LichenNoise& noise,
                           std::shared_ptr<const std::vector<Map>> maps)
      : noise_(noise), maps_(std::move(maps)) {}

  shader::LichenNoise noise_;
  std::shared_ptr<const std::vector<Map>> maps_;
};

} // namespace lichen
