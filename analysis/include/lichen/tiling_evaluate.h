// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/tiling.glsl, and of triplanar.glsl for it: the noise from the
// bundle alone.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>
#include <lichen/tiling_quality.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lichen {

/// Decoded tables of one noise of a bundle. Immutable: any number of threads may evaluate it.
class TilingEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the tables of noise `noise` of a bundle that parsed or was baked without error:
  /// indices and sizes of tables are not checked again. The bundle is not referred to afterwards.
  /// Errors: usage for an index out of range, another method, a quality out of range;
  /// resources for memory. Time and memory: 16 bytes a texel of its tables.
  [[nodiscard]] static Result<TilingEvaluator> create(const Bundle& bundle, std::size_t noise,
                                                      const TilingQuality& quality = {});

  [[nodiscard]] std::size_t mapCount() const;

  /// The decoded value of map `map`, below mapCount(), with the parameters that shaderNoise() makes
  /// of the same bundle's noise: light for sRGB, the stored quantity otherwise, undoing log2;
  /// channels that the map has not are 0, the fourth is 1. Of slopes, the third is the variance of
  /// a slope that the footprint hides. Constant time, no allocation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenNoise& noise,
                               const TileFootprint& at,
                               BlendOperator blend = BlendOperator::histogramPreserving) const;

  /// The same in three planes, with the parameters of a material of the mapping triplanar. Of
  /// slopes, the value is their gradient in space, and the fourth the variance.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenNoise& noise,
                               const TriplanarFootprint& at) const;

  /// Before decoding: Gaussian values of mean 1/2 and, where nothing is lost, deviation 1/6; the
  /// fourth is the share of their variance that filtering loses.
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenNoise& noise,
                               const TileFootprint& at) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenNoise& noise,
                               const TriplanarFootprint& at) const;

  /// What the texels of the Gaussian image's level 0 decode to, row by row, as many interleaved
  /// channels as map `map`, below mapCount(), has. Throws std::bad_alloc.
  [[nodiscard]] std::vector<float> decodedTexels(std::size_t map) const;

private:
  struct Map;

  [[nodiscard]] Value blended(const Map& map, const shader::LichenNoise& noise,
                              const TileFootprint& at, BlendOperator blend, float lod,
                              float lost) const;
  [[nodiscard]] Value turnedSlopes(const Map& map, const shader::LichenNoise& noise,
                                   const TileFootprint& at, float lod, float lost) const;
  [[nodiscard]] static Value decoded(const Map& map, const shader::LichenNoise& noise,
                                     const TileFootprint& at, const Value& gaussian);
  [[nodiscard]] static Value slabLookup(const Map& map, const Value& uniform, std::size_t slab);
  [[nodiscard]] static Value decodeJoint(const Map& map, const Value& gaussian, float level);
  [[nodiscard]] static Value decodeSeparable(const Map& map, const Value& gaussian, float level);
  [[nodiscard]] static Value decode(const Map& map, const Value& gaussian, float lost,
                                    float contrast);

  TilingEvaluator(std::shared_ptr<const std::vector<Map>> maps, const TilingQuality& quality)
      : maps_(std::move(maps)), quality_(quality) {}

  std::shared_ptr<const std::vector<Map>> maps_;
  TilingQuality quality_;
};

} // namespace lichen
