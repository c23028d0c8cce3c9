// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/local_random_phase.glsl. Needs only the bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/solid_footprint.h>
#include <lichen/tile_footprint.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lichen {

/// The decoded tables of one noise. Immutable: several threads may evaluate it at once.
class LocalRandomPhaseEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the tables of noise `noise`. The bundle must have been parsed or baked without error:
  /// indices and table sizes are not checked again. The evaluator does not refer to the bundle
  /// afterwards. Errors: usage for an index out of range or another method; resources if memory
  /// runs out.
  [[nodiscard]] static Result<LocalRandomPhaseEvaluator> create(const Bundle& bundle,
                                                                std::size_t noise);

  [[nodiscard]] std::size_t mapCount() const;

  /// Evaluates map `map`, below mapCount(), with the parameters that shaderMaterial() makes from
  /// the same bundle's noise. Values are as of TilingEvaluator::evaluate(). Time proportional to
  /// the number of cosines; no allocation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;
  /// In a solid: the noise has no structure. Slopes become a gradient in space; the fourth value is
  /// their lost variance.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const SolidFootprint& at) const;

  /// The first channel of the value and its derivatives along x and y of tile space [1 / tile], as
  /// lichenCosinesGradient (shaders_glsl/noise/cosine_gradient.glsl): exact for the cosines, by
  /// differences for a structure. The mapping is uv.
  [[nodiscard]] std::array<float, 3>
  gradient(std::size_t map, const shader::LichenMaterial& material, const TileFootprint& at) const;

  /// The value before decoding: Gaussian with mean 1/2 and, if no variance is lost, standard
  /// deviation 1/6. The fourth is the share of the variance lost to filtering, the mean over the
  /// channels.
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const SolidFootprint& at) const;

private:
  struct Map;

  LocalRandomPhaseEvaluator(const shader::LichenNoise& noise, std::vector<int> cosines,
                            std::uint32_t variants, std::shared_ptr<const std::vector<Map>> maps)
      : noise_(noise), cosines_(std::move(cosines)), variants_(variants), maps_(std::move(maps)) {}

  shader::LichenNoise noise_;
  std::vector<int> cosines_; ///< of each octave
  std::uint32_t variants_;
  std::shared_ptr<const std::vector<Map>> maps_;
};

} // namespace lichen
