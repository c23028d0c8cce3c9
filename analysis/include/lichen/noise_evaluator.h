// SPDX-License-Identifier: MIT
// Evaluates a noise at points, for every method, by the shaders' own code. Needs only the bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace lichen {

// Where a noise is evaluated: a position, and the footprint of one pixel there. All values are
// finite; derivatives are along the result's x (dx) and y (dy), and dx = dy = 0 is a point.

/// On the plane of tiles.
struct TileFootprint {
  /// Tiles from the tile origin of the placement, without the material's offset, below 2^28 in
  /// magnitude. Floats resolve it to 2^-24 of its magnitude, so exact texels of a 256-texel tile
  /// need a magnitude below 2^15.
  std::array<float, 2> position{};
  std::array<float, 2> dx{}; ///< tiles per pixel
  std::array<float, 2> dy{};
};

/// On a surface that shows three planes.
struct TriplanarFootprint {
  /// Metres from the tile origin of the placement, below 2^28 tiles in magnitude.
  std::array<float, 3> position{};
  std::array<float, 3> dx{}; ///< metres per pixel
  std::array<float, 3> dy{};
  std::array<float, 3> normal{}; ///< not 0, any length; may point to either side
};

/// On a surface that carries impacts.
struct SurfaceFootprint {
  std::array<float, 3> position{}; ///< as TriplanarFootprint::position
  std::array<float, 3> dx{};
  std::array<float, 3> dy{};
  std::array<float, 3> normal{};  ///< not 0, any length
  std::array<float, 4> tangent{}; ///< as in glTF: any length, w is the sign of the bitangent
};

/// In a solid.
struct SolidFootprint {
  std::array<float, 3> position{}; ///< as TriplanarFootprint::position, below 2^27 tiles
  std::array<float, 3> dx{};
  std::array<float, 3> dy{};
};

/// One kind for each mapping.
using Footprint = std::variant<TileFootprint, TriplanarFootprint, SurfaceFootprint, SolidFootprint>;

/// The position of a point between the steps of a mix. Noises without a mix ignore it.
struct MixPlace {
  float weight = 0.0f;             ///< 0 is the first step, 1 the last; clamped
  std::array<float, 2> gradient{}; ///< its derivative, per tile
};

/// A point of the plane of tiles.
struct PlanePoint {
  TileFootprint at;
  MixPlace mix;
};

class MethodEvaluator;

/// A point in texture coordinates.
struct UvFootprint {
  std::array<float, 2> uv{};
  std::array<float, 2> dx{}; ///< derivative along the result's x, texture coordinates per pixel
  std::array<float, 2> dy{}; ///< the same along y; dx = dy = 0 is a point
};

/// Choices that the bundle leaves to the host.
struct EvaluationOptions {
  bool nearestTableLevel = false; ///< fetch one mip level of a table instead of blending two
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
  /// Errors: usage for a noise out of range, or a mapping or tile rotation that it does not
  /// support; resources if memory runs out. Time and memory: 16 bytes per texel.
  [[nodiscard]] static Result<std::unique_ptr<const NoiseEvaluator>>
  create(const Bundle& bundle, const MaterialNoise& material, const Placement& placement = {},
         const EvaluationOptions& options = {});

  /// Evaluates map `map` of the noise (see findMap()) at a footprint of the material's mapping. The
  /// third value of slopes is their variance lost to filtering. On the mappings triplanar and solid
  /// slopes become a gradient in space, and the fourth value is their lost variance. Only mixes use
  /// `mix`. Takes constant time, or time proportional to the impacts that reach the footprint.
  [[nodiscard]] Value evaluate(std::size_t map, const Footprint& at,
                               const MixPlace& mix = {}) const;

  /// The same at many points: by tiling and local random phase in half the time, if they have one
  /// footprint. `values` has as many.
  void evaluate(std::size_t map, std::span<const PlanePoint> points, std::span<Value> values) const;

  /// Evaluates at texture coordinates, for a material with the mapping uv. Slopes are in the
  /// tangent space that a mesh has for these coordinates. A mix uses the material's weight if that
  /// is constant or a direction, and its first step otherwise.
  [[nodiscard]] Value evaluateUv(std::size_t map, const UvFootprint& at) const;

private:
  struct Layer {
    std::shared_ptr<const MethodEvaluator> method;
    shader::LichenTriplanarMaterial material;
    std::vector<std::size_t> maps; ///< the layer's, by map of the first layer
    std::vector<Value> means;      ///< of the same values; 0 for slopes
  };
  NoiseEvaluator() = default;
  [[nodiscard]] Value layered(std::size_t map, const Footprint& at) const;

  shader::LichenLayers choice_{};
  std::vector<Layer> layers_;     ///< one if the noise is not layered
  std::vector<Layer> indices_;    ///< index maps
  std::vector<bool> holdsSlopes_; ///< per map
};

} // namespace lichen
