// SPDX-License-Identifier: MIT
// Gaussian value and lost variance -> decoded value: the CPU twin of
// shaders_glsl/noise/decode.glsl.
#pragma once

#include <lichen/bundle.h>
#include <lichen/shader_parameters.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace lichen::gaussianization {

/// Decodes the Gaussian values of one map. Immutable.
class ValueDecoder {
public:
  using Value = std::array<float, 4>;

  /// `inverseTable` is an index into the bundle's tables, absent for a map that is Gaussian itself.
  /// Throws std::bad_alloc.
  ValueDecoder(const Bundle& bundle, const shader::LichenMap& constants,
               std::optional<std::size_t> inverseTable);

  /// lichenDecode. The fourth component of `gaussian` is the share of its variance that is lost.
  /// Light for roots, otherwise the stored quantity with log2 undone; for slopes the third is their
  /// lost variance. With `nearestLevel` the table's nearest level is looked up alone.
  [[nodiscard]] Value decode(const Value& gaussian, float contrast,
                             bool nearestLevel = false) const;

  [[nodiscard]] const shader::LichenMap& constants() const { return constants_; }

  /// lichenDecodedGradient: the first channel of a decoded value and its derivatives, from the
  /// derivatives of the Gaussian value before the contrast.
  [[nodiscard]] std::array<float, 3> gradient(const Value& gaussian,
                                              const std::array<float, 3>& alongX,
                                              const std::array<float, 3>& alongY,
                                              float contrast) const;

private:
  /// A mip level of the inverse table: cells with the first axis fastest.
  struct Level {
    int side = 0;
    std::vector<Value> cells;
  };

  [[nodiscard]] Value lookup(const Value& uniform, std::size_t level) const;
  [[nodiscard]] Value decodeTable(const Value& gaussian, float lost, bool nearestLevel) const;

  shader::LichenMap constants_;
  std::vector<Level> table_; ///< empty without one
};

} // namespace lichen::gaussianization
