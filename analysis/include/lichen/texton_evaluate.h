// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/texton.glsl, surface_texton.glsl and texton_gradient.glsl, and
// of triplanar.glsl for textons: the noise from the bundle alone.
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

/// Decoded textons of one noise of a bundle. Immutable: any number of threads may evaluate it.
class TextonEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the textons of noise `noise` of a bundle that parsed or was baked without error:
  /// indices and sizes of tables are not checked again. The bundle is not referred to afterwards.
  /// Errors: usage for an index out of range, another method; resources for memory. Time and
  /// memory: 16 bytes a texel of its tables.
  [[nodiscard]] static Result<TextonEvaluator> create(const Bundle& bundle, std::size_t noise);

  [[nodiscard]] std::size_t mapCount() const;

  /// The decoded value of map `map`, below mapCount(), with the parameters that shaderNoise() and
  /// shaderTexton() make of the same bundle's noise: light for sRGB, the stored quantity otherwise,
  /// undoing log2; channels that the map has not are 0, the fourth is 1. Of slopes, the third is
  /// the variance of a slope that the footprint hides. Time: the impacts that reach the footprint.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenNoise& noise,
                               const shader::LichenTexton& texton, const TileFootprint& at,
                               const MixPlace& mix = {}) const;

  /// Before decoding: Gaussian values of mean 1/2 and, where nothing is lost, deviation 1/6; the
  /// fourth is 1.
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenNoise& noise,
                               const shader::LichenTexton& texton, const TileFootprint& at,
                               const MixPlace& mix = {}) const;

  /// The share of each channel's variance that filtering loses; 1 of channels that the map has not
  /// or that do not vary.
  [[nodiscard]] std::array<float, 3> lostVariance(std::size_t map, const shader::LichenNoise& noise,
                                                  const shader::LichenTexton& texton,
                                                  const TileFootprint& at,
                                                  const MixPlace& mix = {}) const;

  /// All three on a surface, with the parameters of a material of the mapping surface. Of slopes,
  /// the value is in the tangent space that normal and tangent span but for the material's
  /// rotation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenNoise& noise,
                               const shader::LichenTexton& texton, const SurfaceFootprint& at,
                               const MixPlace& mix = {}) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenNoise& noise,
                               const shader::LichenTexton& texton, const SurfaceFootprint& at,
                               const MixPlace& mix = {}) const;
  [[nodiscard]] std::array<float, 3> lostVariance(std::size_t map, const shader::LichenNoise& noise,
                                                  const shader::LichenTexton& texton,
                                                  const SurfaceFootprint& at,
                                                  const MixPlace& mix = {}) const;

  /// All three in three planes, with the parameters of a material of the mapping triplanar; the mix's
  /// gradient is 0. Of slopes, the value is their gradient in space, and the fourth the variance.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenNoise& noise,
                               const shader::LichenTexton& texton, const TriplanarFootprint& at,
                               const MixPlace& mix = {}) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenNoise& noise,
                               const shader::LichenTexton& texton, const TriplanarFootprint& at,
                               const MixPlace& mix = {}) const;
  [[nodiscard]] std::array<float, 3> lostVariance(std::size_t map, const shader::LichenNoise& noise,
                                                  const shader::LichenTexton& texton,
                                                  const TriplanarFootprint& at,
                                                  const MixPlace& mix = {}) const;

  /// The stored value of the map's first channel, not clamped, and its derivatives along x and y,
  /// per tile.
  [[nodiscard]] std::array<float, 3> gradient(std::size_t map, const shader::LichenNoise& noise,
                                              const shader::LichenTexton& texton,
                                              const TileFootprint& at,
                                              const MixPlace& mix = {}) const;

private:
  struct Map;
  static Value decoded(const Map& map, const shader::LichenNoise& noise, const Value& gaussian,
                       std::array<float, 3> lostVariance, const MixPlace& mix);
  explicit TextonEvaluator(std::shared_ptr<const std::vector<Map>> maps) : maps_(std::move(maps)) {}

  std::shared_ptr<const std::vector<Map>> maps_;
};

} // namespace lichen
