// SPDX-License-Identifier: MIT
// Fills the uniform structs of the shader library from a bundle. The engine plugin uploads them,
// and the C++ evaluator reads them.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lattice.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <lichen_interface.h>
#include <span>
#include <string_view>

namespace lichen {

/// The constants of one map. `map` is a valid index into `noise.maps`, and the map's table indices
/// are valid.
[[nodiscard]] shader::LichenMap shaderMap(const Bundle& bundle, const Noise& noise,
                                          std::size_t map);

/// What all maps of a noise share. `noise` is a valid index.
[[nodiscard]] shader::LichenNoise shaderNoise(const Bundle& bundle, std::size_t noise);

/// The block of a noise: the above, each map at the place of its role, and its layers.
[[nodiscard]] shader::LichenNoiseConstants shaderConstants(const Bundle& bundle, std::size_t noise);

/// The role of a map in the shader, LICHEN_BASE_COLOR and so on.
[[nodiscard]] std::uint32_t roleOf(MapTarget target);

/// The step table of a map with `laterSteps`. The shader reads it from the binding of the inverse
/// table. Throws std::bad_alloc.
[[nodiscard]] Table mixTable(const NoiseMap& map);

/// Why this noise does not support a mapping that its method supports, such as "it has a structure,
/// which lies in a plane". Empty if it does support it.
[[nodiscard]] std::string_view mappingObstacle(const shader::LichenNoise& noise, Mapping mapping);
[[nodiscard]] std::string_view mappingObstacle(const Noise& noise, Mapping mapping);

/// Whether a noise takes a MaterialNoise::tileRotation. Methods other than tiling ignore it, and so
/// take 4 of any tiles.
[[nodiscard]] bool takesTileRotation(const shader::LichenNoise& noise, std::uint32_t tileRotation);

/// Settings that place a material's noise on a surface.
struct Placement {
  /// Whole tiles added to every coordinate, |.| up to 2^40. If an origin is not 0 and the placement
  /// is periodic, the period along that axis is a whole number of tiles.
  std::int64_t tileOriginX = 0;
  std::int64_t tileOriginY = 0;
  /// For triplanar, surface and solid noise, which evaluate at 3-D positions. These tiles are as
  /// high as wide.
  std::int64_t tileOriginZ = 0;
  bool periodic = false;     ///< repeat every periodTilesX x periodTilesY tiles; Mapping::uv only
  double periodTilesX = 0.0; ///< at least about half a tile; whole texels for an exact seam
  double periodTilesY = 0.0;
  double maxAnisotropy = 1.0; ///< of the sampler for the Gaussian images
};

/// Factor from the impacts that cover a point of a plane to those that cover a point of a surface.
/// Surface noise needs more because many have a low weight: with the weights of [GLM17] section 6,
/// the excess kurtosis of the sum is 9/5 of an unweighted sum's.
inline constexpr double kSurfaceImpacts = 2.0;

/// The plane argument of latticeSeed() for surface and for solid noise. Plane 0 is uv; 0 to 2 are
/// triplanar's.
inline constexpr std::uint32_t kSurfacePlane = 3, kSolidPlane = 4;

/// The block of a material at `placement`, of a noise with these constants. Needs no bundle. The
/// planes are zero but for the mapping triplanar.
[[nodiscard]] shader::LichenTriplanarMaterial shaderMaterial(const shader::LichenNoise& noise,
                                                             const MaterialNoise& material,
                                                             const Placement& placement);
/// The same of a bundle's noise, `material.noise`, a valid index.
[[nodiscard]] shader::LichenTriplanarMaterial
shaderMaterial(const Bundle& bundle, const MaterialNoise& material, const Placement& placement);

/// The material of one layer, or of one index map, of a layered noise: the seed is its own, and an
/// index map has a contrast of 1.
[[nodiscard]] MaterialNoise layerMaterial(const MaterialNoise& material, std::size_t layer);
[[nodiscard]] MaterialNoise indexMaterial(const MaterialNoise& material, std::size_t node);

/// The block of a material of a layered noise; the constants belong to its layers and to its index
/// maps. Without index maps only `first` is set.
[[nodiscard]] shader::LichenLayeredMaterial
shaderLayeredMaterial(std::span<const shader::LichenNoise> layers,
                      std::span<const shader::LichenNoise> indices, const MaterialNoise& material,
                      const Placement& placement);

/// What a material and a noise hold for their method in own0 and so on, and back: structs of the
/// method's, such as LichenTextonNoise.
template <class Part>
Part partOf(const shader::LichenMaterial& material) {
  const std::array words{material.own0, material.own1, material.own2};
  static_assert(sizeof(Part) <= sizeof words);
  Part part;
  std::memcpy(&part, words.data(), sizeof part);
  return part;
}

template <class Part>
void setPart(shader::LichenMaterial& material, const Part& part) {
  std::array<shader::uvec4, 3> words{};
  std::memcpy(words.data(), &part, sizeof part);
  material.own0 = words[0];
  material.own1 = words[1];
  material.own2 = words[2];
}

template <class Part>
Part partOf(const shader::LichenNoise& noise) {
  const std::array words{noise.own0, noise.own1};
  static_assert(sizeof(Part) <= sizeof words);
  Part part;
  std::memcpy(&part, words.data(), sizeof part);
  return part;
}

template <class Part>
void setPart(shader::LichenNoise& noise, const Part& part) {
  std::array<shader::uvec4, 2> words{};
  std::memcpy(words.data(), &part, sizeof part);
  noise.own0 = words[0];
  noise.own1 = words[1];
}

} // namespace lichen
