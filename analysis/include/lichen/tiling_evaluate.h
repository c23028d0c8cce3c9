// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/tiling.glsl, and of triplanar.glsl for tiling. Needs only the
// bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lichen {

/// The decoded tables of one noise. Immutable: several threads may evaluate it at once.
class TilingEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the tables of noise `noise`. The bundle must have been parsed or baked without error:
  /// indices and table sizes are not checked again. The evaluator does not refer to the bundle
  /// afterwards. `nearestTableLevel`: as in EvaluationOptions. Errors: usage for an index out of
  /// range or another method; resources if memory runs out. Time and memory: 16 bytes per texel of
  /// its tables.
  [[nodiscard]] static Result<TilingEvaluator> create(const Bundle& bundle, std::size_t noise,
                                                      bool nearestTableLevel = false);

  [[nodiscard]] std::size_t mapCount() const;

  /// Evaluates map `map`, below mapCount(), with the parameters that shaderMaterial() makes from
  /// the same bundle's noise. Returns light for roots, otherwise the stored quantity with log2
  /// undone; channels that the map does not have are 0, the fourth is 1. For slopes the third is
  /// the variance of a slope lost to filtering. Constant time, no allocation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;

  /// The same in three planes, with the parameters of a material with the mapping triplanar. For
  /// slopes the value is their gradient in space, and the fourth is the lost variance.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;

  /// The value before decoding: Gaussian with mean 1/2 and, if no variance is lost, standard
  /// deviation 1/6. The fourth is the share of the variance lost to filtering.
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;
  [[nodiscard]] Value gaussian(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;

  /// Decodes the texels of level 0 of the Gaussian image of map `map`, below mapCount(), row by
  /// row, with as many interleaved channels as the map has. Throws std::bad_alloc.
  [[nodiscard]] std::vector<float> decodedTexels(std::size_t map) const;

private:
  struct Map;

  struct Tiles;

  [[nodiscard]] Tiles tilesAt(const Map& map, const shader::LichenMaterial& material,
                              TileFootprint at) const;
  [[nodiscard]] static Value blended(const Tiles& tiles, const shader::LichenMaterial& material);
  [[nodiscard]] Value rotatedSlopes(const Map& map, const Tiles& tiles,
                                    const shader::LichenMaterial& material) const;
  [[nodiscard]] static float footprintShare(const Map& map, float loss);
  [[nodiscard]] Value decodeTile(const Map& map, const Value& tile, float lossShare,
                                 float contrast) const;
  [[nodiscard]] Value decode(const Map& map, const Value& gaussian, float contrast) const;

  TilingEvaluator(const shader::LichenNoise& noise, std::shared_ptr<const std::vector<Map>> maps,
                  bool nearestTableLevel)
      : noise_(noise), maps_(std::move(maps)), nearestTableLevel_(nearestTableLevel) {}

  shader::LichenNoise noise_;
  std::shared_ptr<const std::vector<Map>> maps_;
  bool nearestTableLevel_;
};

} // namespace lichen
