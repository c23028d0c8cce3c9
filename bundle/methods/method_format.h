// SPDX-License-Identifier: MIT
// What the format asks of a method: how its data is read, checked, written and handed to the
// shaders. Each method implements it in its own folder; methods.cpp lists them.
#pragma once

#include "extension_reader.h"

#include <lichen/json_tree.h>
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

  /// The members of a map's JSON object that are indices of tables.
  [[nodiscard]] virtual std::span<const std::string_view> tableMembers() const = 0;
  /// Reads and checks the members of a noise that its maps share.
  [[nodiscard]] virtual MethodNoise readNoise(ObjectReader& reader,
                                              FindingList& findings) const = 0;
  /// Reads and checks the members of one map that belong to the method. `noise` has been read up to
  /// its maps, `map` up to its moments; members at fault may be missing from both. A table that
  /// could not be read is null.
  [[nodiscard]] virtual MethodMap readMap(ObjectReader& reader, const Noise& noise,
                                          const NoiseMap& map, const Tables& tables,
                                          FindingList& findings) const = 0;
  /// Whether the noise changes along the weight of a mix.
  [[nodiscard]] virtual bool isMix(const Noise&) const { return false; }

  /// Appends the members that readNoise() and readMap() read.
  virtual void writeNoise(const Noise& noise, JsonTree& json) const = 0;
  virtual void writeMap(const NoiseMap& map, JsonTree& json) const = 0;

  /// Width and height in texels of the exemplar of one map, and of a tile of the whole noise.
  [[nodiscard]] virtual std::array<std::uint32_t, 2>
  exemplarSize(const Bundle& bundle, const Noise& noise, const NoiseMap& map) const = 0;
  [[nodiscard]] virtual std::array<std::uint32_t, 2> tileSize(const Bundle& bundle,
                                                              const Noise& noise) const = 0;

  /// The cells of the noise on texture coordinates, and the cell in which an integer tile origin
  /// lies. Skewed rows are each shifted by half a column against the one before.
  [[nodiscard]] virtual Lattice cells(const Noise& noise, const MaterialNoise& material,
                                      const Placement& placement) const = 0;
  [[nodiscard]] virtual LatticeOrigin cellOf(const Lattice& cells, std::int64_t tileX,
                                             std::int64_t tileY) const = 0;
  [[nodiscard]] virtual bool hasSkewedRows() const = 0;

  /// Sets the members of a noise's constants that place it on surfaces; called where it fits them.
  virtual void setSurface(const Noise&, const MaterialNoise&, const Placement&,
                          shader::LichenNoise&) const {}

  /// Sets the members of a map's and of a noise's constants that only this method has.
  virtual void setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                      shader::LichenMap& constants) const = 0;
  virtual void setNoise(const Bundle& bundle, const MaterialNoise& material,
                        const Placement& placement, shader::LichenNoise& constants) const = 0;
};

/// Every method, in the order of Method.
[[nodiscard]] std::span<const MethodFormat* const> methodFormats();
[[nodiscard]] const MethodFormat& formatOf(Method method);
[[nodiscard]] inline const MethodFormat& formatOf(const Noise& noise) {
  return formatOf(noise.method());
}

} // namespace lichen
