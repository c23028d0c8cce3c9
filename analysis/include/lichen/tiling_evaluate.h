// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/tiling.glsl: the noise from the bundle alone.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>

#include <array>
#include <cstddef>
#include <vector>

namespace lichen {

/// A place in tile space and the footprint of one pixel there. All finite.
struct TileFootprint {
  /// Tiles from the tile origin in LichenNoise, below 2^28 in magnitude; floats resolve it to 2^-24
  /// of its magnitude, so exact texels of a 256-texel tile ask for less than 2^15.
  std::array<float, 2> position{};
  std::array<float, 2> dx{}; ///< derivative along the result's x, tiles per pixel; 0 is a point
  std::array<float, 2> dy{}; ///< likewise along y
};

/// How the three taps are blended. The first is the method; the others serve comparison.
enum class BlendOperator {
  histogramPreserving, ///< [HN18] eq. 18
  variancePreserving,  ///< eq. 8 on the decoded values: no inverse table after the blend
  linear,              ///< eq. 3 on the decoded values
};

/// Decoded tables of one noise of a bundle. Immutable: any number of threads may evaluate it.
class TilingEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the tables of noise `noise` of a bundle that parsed or was baked without error:
  /// indices and sizes of tables are not checked again. The bundle is not referred to afterwards.
  /// Errors: usage for an index out of range, another method;
  /// resources for memory. Time and memory: 16 bytes a texel of its tables.
  [[nodiscard]] static Result<TilingEvaluator> create(const Bundle& bundle, std::size_t noise);

  [[nodiscard]] std::size_t mapCount() const { return maps_.size(); }

  /// The decoded value of map `map`, below mapCount(), with the parameters that shaderNoise() makes
  /// of the same bundle's noise: light for sRGB, the stored quantity otherwise, undoing log2;
  /// channels that the map has not are 0, the fourth is 1. Of slopes, the third is the variance of
  /// a slope that the footprint hides. Constant time, no allocation.
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenNoise& noise,
                               const TileFootprint& at,
                               BlendOperator blend = BlendOperator::histogramPreserving) const;

  /// What the texels of the Gaussian image's level 0 decode to, row by row, as many interleaved
  /// channels as map `map`, below mapCount(), has. Throws std::bad_alloc.
  [[nodiscard]] std::vector<float> decodedTexels(std::size_t map) const;

private:
  struct Mip {
    int width = 0;
    int height = 0;
    std::vector<Value> texels;
  };
  struct Map {
    shader::LichenMap constants{};
    std::vector<Mip> mips;
    std::size_t channels = 0;
    int tableSide = 0;
    std::vector<Value> table; ///< slab k, then the cells, first axis fastest; empty without one
  };

  [[nodiscard]] static Value bilinear(const Mip& mip, float u, float v);
  [[nodiscard]] static Value trilinear(const Map& map, float u, float v, float lod);
  [[nodiscard]] static Value slabLookup(const Map& map, const Value& uniform, std::size_t slab);
  [[nodiscard]] static Value decodeJoint(const Map& map, const Value& gaussian, float lost);
  [[nodiscard]] static Value decodeSeparable(const Map& map, const Value& gaussian, float lost);
  [[nodiscard]] static Value decode(const Map& map, const Value& gaussian, float lost);

  std::vector<Map> maps_;
};

} // namespace lichen
