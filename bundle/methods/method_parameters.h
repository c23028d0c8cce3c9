// SPDX-License-Identifier: MIT
// How a method's data become constants of the shaders. Each method has a MethodParameters in its
// folder; methods.cpp lists them.
#pragma once

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace lichen {

/// A function may be null where its comment says so.
struct MethodParameters {
  bool (*fits)(Mapping mapping);
  /// As mappingObstacle(), for a mapping that fits the method. Null: there is none. A method that
  /// has it reads no table in setNoise, since mappingObstacle() asks for noises without a bundle.
  std::string_view (*obstacle)(const shader::LichenNoise& noise, Mapping mapping) = nullptr;
  bool isLayerable = true; ///< whether a layered noise may have it as a layer
  /// Whether the noise is a mix. Null: never.
  bool (*isMix)(const Noise& noise) = nullptr;
  /// Width and height of all maps' exemplars, in texels. Null: each exemplar is as large as its
  /// image.
  std::array<std::uint32_t, 2> (*texelsPerTile)(const Noise& noise) = nullptr;
  std::size_t (*imageOf)(const NoiseMap& map) = nullptr; ///< null with texelsPerTile
  bool readsTexels = false; ///< whether shaders fetch single texels of its images, unfiltered
  /// Whether shaders read the last channel of an image as alpha.
  bool lastChannelIsAlpha = false;
  /// The image that all maps share beside their own. Null: there is none.
  std::size_t (*sharedImage)(const NoiseMap& map) = nullptr;
  /// The bits LICHEN_FEATURE_... that shaders of the noise and the material need, but the method,
  /// the mapping, the period and what decodes. Null: none.
  std::uint32_t (*features)(const shader::LichenNoise& noise,
                            const MaterialNoise& material) = nullptr;

  /// The noise's cells on texture coordinates.
  Lattice (*cells)(const shader::LichenNoise& noise, const MaterialNoise& material,
                   const Placement& placement);
  /// The number of tiles along x and y between origins that lie at the corner of a cell, if the
  /// cells have no period. Null: 1.
  std::array<std::int64_t, 2> (*originStep)(const shader::LichenNoise& noise,
                                            const MaterialNoise& material) = nullptr;
  /// The cell, modulo 2^32, whose corner lies at an integer tile origin. The origin must be a
  /// multiple of the step.
  std::array<std::int32_t, 2> (*cellOf)(const shader::LichenNoise& noise,
                                        const MaterialNoise& material, std::int64_t tileX,
                                        std::int64_t tileY);

  /// Each sets the constants that only this method has. setConstants fills its members of the block
  /// beside `noise` and `maps`. setMaterial also sets the cells on surfaces and in solids. The last
  /// two may be null.
  void (*setMap)(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                 shader::LichenMap& constants);
  void (*setNoise)(const Bundle& bundle, const Noise& noise, shader::LichenNoise& constants);
  void (*setConstants)(const Noise& noise, shader::LichenNoiseConstants& constants) = nullptr;
  void (*setMaterial)(const shader::LichenNoise& noise, const MaterialNoise& material,
                      const Placement& placement, shader::LichenMaterial& constants) = nullptr;
};

[[nodiscard]] const MethodParameters& parametersOf(Method method);
[[nodiscard]] inline const MethodParameters& parametersOf(const Noise& noise) {
  return parametersOf(noise.method());
}
[[nodiscard]] inline const MethodParameters& parametersOf(const shader::LichenNoise& noise) {
  return parametersOf(Method(noise.method));
}

[[nodiscard]] inline std::uint32_t featureIf(bool isNeeded, std::uint32_t feature) {
  return isNeeded ? feature : 0;
}

/// Width and height of a tile in texels: as wide as the widest exemplar, as high as the highest.
[[nodiscard]] std::array<std::uint32_t, 2> tileSize(const Bundle& bundle, const Noise& noise);

} // namespace lichen
