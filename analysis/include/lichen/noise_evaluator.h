// SPDX-License-Identifier: MIT
// The values of a noise at points, as the shaders compute them: any method, from the bundle alone.
#pragma once

#include <lichen/bundle.h>
#include <lichen/mix_place.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/surface_footprint.h>
#include <lichen/tile_footprint.h>
#include <lichen/tiling_quality.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lichen {

/// A point on texture coordinates and the footprint of one pixel there. All finite.
struct UvFootprint {
  std::array<float, 2> uv{};
  std::array<float, 2> dx{}; ///< derivative along the result's x, texture coordinates per pixel
  std::array<float, 2> dy{}; ///< likewise along y; both 0 for a point
};

/// What evaluation leaves open to a host, by method.
struct EvaluationOptions {
  TilingEvaluation tiling;
};

/// A noise as one material uses it. Immutable: any number of threads may evaluate it.
class NoiseEvaluator {
public:
  /// Light for sRGB, the stored quantity otherwise, undoing log2. Channels that the map does not
  /// have are 0, the fourth is 1. For slopes see evaluate().
  using Value = std::array<float, 4>;

  /// Decodes the tables of the noise of `material`. The bundle parsed or was baked without error:
  /// indices and sizes of tables are not checked again; it is not referred to afterwards.
  /// Errors: usage for a noise out of range, a mapping that its method does not fit, or an option
  /// out of range; resources for memory. Time and memory: 16 bytes a texel of its tables.
  [[nodiscard]] static Result<std::unique_ptr<const NoiseEvaluator>>
  create(const Bundle& bundle, const MaterialNoise& material, const Placement& placement = {},
         const EvaluationOptions& options = {});

  virtual ~NoiseEvaluator() = default;

  /// The value of map `map` of the noise (findMap()) on the plane of its tiles; for slopes the third
  /// value is the variance of a slope that filtering loses. `mix` counts for mixes only. For a
  /// material of the mapping uv. Constant time or, for textons, that of the impacts in reach.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const TileFootprint& at,
                                       const MixPlace& mix = {}) const = 0;
  /// As above for the mapping triplanar. Slopes become a gradient in space, and the fourth value the
  /// lost variance.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const TriplanarFootprint& at,
                                       const MixPlace& mix = {}) const = 0;
  /// As above for the mapping surface. Slopes are in the tangent space of normal and tangent, but
  /// for the material's rotation.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const SurfaceFootprint& at,
                                       const MixPlace& mix = {}) const = 0;

  /// The value at texture coordinates, for a material of the mapping uv. Slopes are those of the
  /// tangent space that a mesh has for these coordinates; a mix takes its weight from the material
  /// where that is constant or a direction, and is at its first step otherwise.
  [[nodiscard]] Value evaluateUv(std::size_t map, const UvFootprint& at) const;

protected:
  /// Of a noise with the constants that shaderNoise() makes of `material`.
  NoiseEvaluator(const Noise& noise, const shader::LichenNoise& constants);

  [[nodiscard]] const shader::LichenNoise& constants() const { return constants_; }

private:
  /// Where texture coordinates lie in a mix.
  [[nodiscard]] virtual MixPlace mixAt(const std::array<float, 2>&) const { return {}; }

  shader::LichenNoise constants_;
  std::vector<bool> holdsSlopes_; ///< by map
};

} // namespace lichen
