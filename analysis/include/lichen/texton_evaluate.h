// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/texton.glsl, surface_texton.glsl and texton_gradient.glsl, and
// of triplanar.glsl for textons. Needs only the bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/mix_place.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/surface_footprint.h>
#include <lichen/tile_footprint.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lichen {

/// The decoded textons of one noise. Immutable: several threads may evaluate it at once.
class TextonEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the textons of noise `noise`. The bundle must have been parsed or baked without error:
  /// indices and table sizes are not checked again. The evaluator does not refer to the bundle
  /// afterwards. Errors: usage for an index out of range or another method; resources if memory
  /// runs out. Time and memory: 16 bytes per texel of its tables.
  [[nodiscard]] static Result<TextonEvaluator> create(const Bundle& bundle, std::size_t noise);

  [[nodiscard]] std::size_t mapCount() const;

  /// Evaluates map `map`, below mapCount(), with the parameters that shaderMaterial() makes
  /// from the same bundle's noise. Returns light for sRGB, otherwise the stored
  /// quantity with log2 undone; channels that the map does not have are 0, the fourth is 1. For
  /// slopes the third is the variance of a slope lost to filtering. Takes time proportional to the
  /// impacts that reach the footprint.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at, const MixPlace& mix = {}) const;

  /// The value before decoding: Gaussian with mean 1/2 and, if no variance is lost, standard
  /// deviation 1/6; the fourth is 1.
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at, const MixPlace& mix = {}) const;

  /// The share of each channel's variance lost to filtering; 1 for channels that the map does not
  /// have or that do not vary.
  [[nodiscard]] std::array<float, 3> lostVariance(std::size_t map,
                                                  const shader::LichenMaterial& material,
                                                  const TileFootprint& at,
                                                  const MixPlace& mix = {}) const;

  /// The three functions above on a surface, with the parameters of a material with the mapping
  /// surface. Slopes are in the tangent space of the normal and tangent, rotated by the material's
  /// rotation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const SurfaceFootprint& at, const MixPlace& mix = {}) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const SurfaceFootprint& at, const MixPlace& mix = {}) const;
  [[nodiscard]] std::array<float, 3> lostVariance(std::size_t map,
                                                  const shader::LichenMaterial& material,
                                                  const SurfaceFootprint& at,
                                                  const MixPlace& mix = {}) const;

  /// The three functions above in three planes, with the parameters of a material with the mapping
  /// triplanar; the mix's gradient is 0. For slopes the value is their gradient in space, and the
  /// fourth is the lost variance.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at, const MixPlace& mix = {}) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at, const MixPlace& mix = {}) const;
  [[nodiscard]] std::array<float, 3> lostVariance(std::size_t map,
                                                  const shader::LichenTriplanarMaterial& material,
                                                  const TriplanarFootprint& at,
                                                  const MixPlace& mix = {}) const;

  /// Returns the stored value of the map's first channel, not clamped, and its derivatives along x
  /// and y, per tile.
  [[nodiscard]] std::array<float, 3> gradient(std::size_t map,
                                              const shader::LichenMaterial& material,
                                              const TileFootprint& at,
                                              const MixPlace& mix = {}) const;

private:
  struct Map;
  static Value decoded(const Map& map, const shader::LichenMaterial& material,
                       const Value& gaussian, std::array<float, 3> lostVariance,
                       const MixPlace& mix);
  TextonEvaluator(const shader::LichenNoise& noise, std::shared_ptr<const std::vector<Map>> maps)
      : noise_(noise), maps_(std::move(maps)) {}

  shader::LichenNoise noise_;
  std::shared_ptr<const std::vector<Map>> maps_;
};

} // namespace lichen
