// SPDX-License-Identifier: MIT
// A 3-D table with its mips, as a clamping trilinear sampler reads it.
#pragma once

#include "texels.h"

#include <algorithm>

namespace lichen {

/// Immutable: any number of threads may fetch from it.
class ClampedVolume {
public:
  ClampedVolume() = default;
  /// Throws std::bad_alloc.
  explicit ClampedVolume(const Table& table) {
    for (std::uint32_t level = 0; level < table.mipLevels; ++level)
      mips_.push_back({{std::max(1, int(table.width >> level)),
                        std::max(1, int(table.height >> level)),
                        std::max(1, int(table.depth >> level))},
                       texelsOf(table, level)});
  }

  /// The value at a coordinate in [0, 1] along each axis, outside of which it is clamped, and at
  /// `lod` mip levels, which is clamped to those that exist.
  [[nodiscard]] Texel at(const std::array<float, 3>& coordinate, float lod) const {
    const float level = std::clamp(lod, 0.0f, float(mips_.size() - 1));
    const auto fine = std::size_t(level);
    const Texel value = trilinear(mips_[fine], coordinate);
    const float t = level - float(fine);
    return t > 0.0f ? mix(value, trilinear(mips_[fine + 1], coordinate), t) : value;
  }

private:
  struct Mip {
    std::array<int, 3> sides;
    std::vector<Texel> texels;
  };

  [[nodiscard]] static Texel trilinear(const Mip& mip, const std::array<float, 3>& coordinate) {
    std::size_t first = 0, stride = 1;
    std::array<std::size_t, 3> step{}; // to the next texel along each axis
    std::array<float, 3> fraction{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int side = mip.sides[axis];
      const float at = std::clamp(coordinate[axis] * float(side) - 0.5f, 0.0f, float(side - 1));
      const int texel = int(at);
      first += std::size_t(texel) * stride;
      step[axis] = texel + 1 < side ? stride : 0;
      fraction[axis] = at - float(texel);
      stride *= std::size_t(side);
    }
    const Texel* const texels = mip.texels.data() + first;
    const auto line = [&](std::size_t at) {
      return mix(texels[at], texels[at + step[0]], fraction[0]);
    };
    // Tables of fewer dimensions have depth 1.
    const auto square = [&](std::size_t at) {
      return step[1] > 0 ? mix(line(at), line(at + step[1]), fraction[1]) : line(at);
    };
    return step[2] > 0 ? mix(square(0), square(step[2]), fraction[2]) : square(0);
  }

  std::vector<Mip> mips_;
};

} // namespace lichen
