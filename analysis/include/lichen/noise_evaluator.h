// SPDX-License-Identifier: MIT
// Evaluates a noise at points, for every method, as the shaders do. Needs only the bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/mix_place.h>
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

/// A point in texture coordinates and the footprint of one pixel there. All values are finite.
struct UvFootprint {
  std::array<float, 2> uv{};
  std::array<float, 2> dx{}; ///< derivative along the result's x, texture coordinates per pixel
  std::array<float, 2> dy{}; ///< the same along y; dx = dy = 0 is a point
};

/// Choices that the bundle leaves to the host.
struct EvaluationOptions {
  /// Tiling: fetch the nearest mip level of an inverse table instead of blending two. In shaders it
  /// is LICHEN_NEAREST_TABLE_LEVEL (shaders_glsl/noise/decode.glsl).
  bool nearestTableLevel = false;
};

/// A noise as one material uses it. Immutable: several threads may evaluate it at once.
class NoiseEvaluator {
public:
  /// Light for sRGB; otherwise the stored quantity, with log2 undone. Channels that the map does
  /// not have are 0, the fourth is 1. For slopes see evaluate().
  using Value = std::array<float, 4>;

  /// Decodes the tables of the noise of `material`. The bundle must have been parsed or baked
  /// without error: indices and table sizes are not checked again. The evaluator does not refer to
  /// the bundle afterwards.
  /// Errors: usage for a noise out of range, or a mapping or tile rotation that it does not take;
  /// resources if memory runs out. Time and memory: 16 bytes per texel.
  [[nodiscard]] static Result<std::unique_ptr<const NoiseEvaluator>>
  create(const Bundle& bundle, const MaterialNoise& material, const Placement& placement = {},
         const EvaluationOptions& options = {});

  virtual ~NoiseEvaluator() = default;

  /// Evaluates map `map` of the noise (see findMap()) on the plane of its tiles. For slopes the
  /// third value is the variance of a slope lost to filtering. Only mixes use `mix`. The material's
  /// mapping must be uv. Takes constant time, or for textons time proportional to the impacts that
  /// reach the footprint.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const TileFootprint& at,
                                       const MixPlace& mix = {}) const = 0;
  /// As above for the mapping triplanar. Slopes become a gradient in space; the fourth value is
  /// their lost variance.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const TriplanarFootprint& at,
                                       const MixPlace& mix = {}) const = 0;
  /// As above for the mapping surface. Slopes are in the tangent space of the normal and tangent,
  /// rotated by the material's rotation.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const SurfaceFootprint& at,
                                       const MixPlace& mix = {}) const = 0;
  /// As above for the mapping solid. Slopes become a gradient in space; the fourth value is their
  /// lost variance.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const SolidFootprint& at) const = 0;

  /// The value of a map's first channel and its derivatives along x and y [1 / tile], as
  /// LICHEN_GRADIENT has them: of textons the stored value, not clamped, otherwise that of
  /// evaluate(). Tiling, quilting and layered noises have the derivatives 0. The material's mapping
  /// must be uv.
  [[nodiscard]] virtual std::array<float, 3> evaluateGradient(std::size_t map,
                                                              const TileFootprint& at,
                                                              const MixPlace& mix = {}) const;

  /// Evaluates at texture coordinates, for a material with the mapping uv. Slopes are in the
  /// tangent space that a mesh has for these coordinates. A mix uses the material's weight if that
  /// is constant or a direction, and its first step otherwise.
  [[nodiscard]] Value evaluateUv(std::size_t map, const UvFootprint& at) const;

protected:
  /// The constants are those that shaderMaterial() makes from `material`.
  NoiseEvaluator(const Noise& noise, const shader::LichenTriplanarMaterial& constants);

  [[nodiscard]] const shader::LichenMaterial& constants() const { return constants_.material; }
  [[nodiscard]] const shader::LichenTriplanarMaterial& planes() const { return constants_; }
  [[nodiscard]] bool holdsSlopes(std::size_t map) const { return holdsSlopes_[map]; }

private:
  /// Converts texture coordinates to a position in the mix.
  [[nodiscard]] virtual MixPlace mixAt(const std::array<float, 2>&) const { return {}; }

  shader::LichenTriplanarMaterial constants_;
  std::vector<bool> holdsSlopes_; ///< per map
};

} // namespace lichen
