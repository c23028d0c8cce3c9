// SPDX-License-Identifier: MIT
// The interface through which the format reads, checks and writes a method's data and passes it to
// the shaders. Each method implements it in its own folder; methods.cpp lists the methods.
#pragma once

#include "extension_reader.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace lichen {

class MethodFormat {
public:
  virtual ~MethodFormat() = default;

  /// The method's name in the JSON.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// The revision that this version reads, writes and evaluates.
  [[nodiscard]] virtual int revision() const = 0;
  [[nodiscard]] virtual bool fits(Mapping mapping) const = 0;
  /// As mappingObstacle(), for a mapping that fits the method.
  [[nodiscard]] virtual std::string_view obstacle(const Noise&, Mapping) const { return {}; }
  [[nodiscard]] virtual std::string_view obstacle(const shader::LichenNoise&, Mapping) const {
    return {};
  }

  /// The members of a map's JSON object that are table indices.
  [[nodiscard]] virtual std::span<const std::string_view> tableMembers() const = 0;
  /// Reads and checks the members of a noise that its maps share.
  [[nodiscard]] virtual MethodNoise readNoise(ObjectReader& reader,
                                              FindingList& findings) const = 0;
  /// Reads and checks the method's members of one map. `noise` is read up to its maps and `map` up
  /// to its moments; faulty members may be missing from both. A table that could not be read is
  /// empty.
  [[nodiscard]] virtual MethodMap readMap(ObjectReader& reader, const Noise& noise,
                                          const NoiseMap& map, const Tables& tables,
                                          FindingList& findings) const = 0;
  /// Whether a layered noise may have it as a layer.
  [[nodiscard]] virtual bool isLayerable() const { return true; }
  /// Whether the noise is a mix.
  [[nodiscard]] virtual bool isMix(const Noise&) const { return false; }

  /// Appends the members that readNoise() and readMap() read.
  virtual void writeNoise(const Noise& noise, nlohmann::ordered_json& json) const = 0;
  virtual void writeMap(const NoiseMap& map, nlohmann::ordered_json& json) const = 0;

  /// Width and height in texels of a map's exemplar (exemplarSize), and of a tile of the noise
  /// (tileSize).
  [[nodiscard]] virtual std::array<std::uint32_t, 2>
  exemplarSize(const Bundle& bundle, const Noise& noise, const NoiseMap& map) const = 0;
  [[nodiscard]] virtual std::array<std::uint32_t, 2> tileSize(const Bundle& bundle,
                                                              const Noise& noise) const = 0;

  /// The noise's cells on texture coordinates.
  [[nodiscard]] virtual Lattice cells(const shader::LichenNoise& noise,
                                      const MaterialNoise& material,
                                      const Placement& placement) const = 0;
  /// The number of tiles along x and y between origins that lie at the corner of a cell, if the
  /// cells have no period.
  [[nodiscard]] virtual std::array<std::int64_t, 2> originStep(const shader::LichenNoise&,
                                                               const MaterialNoise&) const {
    return {1, 1};
  }
  /// The cell, modulo 2^32, whose corner lies at an integer tile origin. The origin must be a
  /// multiple of originStep().
  [[nodiscard]] virtual std::array<std::int32_t, 2> cellOf(const shader::LichenNoise& noise,
                                                           const MaterialNoise& material,
                                                           std::int64_t tileX,
                                                           std::int64_t tileY) const = 0;

  /// Sets the constants that only this method has: of a map, of a noise, and of a material, of
  /// which for Mapping::surface and Mapping::solid, where they fit, also the cells.
  virtual void setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                      shader::LichenMap& constants) const = 0;
  virtual void setNoise(const Bundle& bundle, const Noise& noise,
                        shader::LichenNoise& constants) const = 0;
  /// Sets what a method has in the block of a noise beside `noise` and `maps`.
  virtual void setConstants(const Noise&, shader::LichenNoiseConstants&) const {}
  virtual void setMaterial(const shader::LichenNoise& noise, const MaterialNoise& material,
                           const Placement& placement, shader::LichenMaterial& constants) const = 0;
};

/// All methods, in the order of Method.
[[nodiscard]] std::span<const MethodFormat* const> methodFormats();
[[nodiscard]] const MethodFormat& formatOf(Method method);
[[nodiscard]] inline const MethodFormat& formatOf(const Noise& noise) {
  return formatOf(noise.method());
}

} // namespace lichen
