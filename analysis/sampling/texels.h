// SPDX-License-Identifier: MIT
// The texels of a table as a shader's fetch returns them.
#pragma once

#include <lichen/bundle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lichen {

/// Red, green, blue, alpha.
using Texel = std::array<float, 4>;

/// Where the fourth component of a texel comes from: it is 1, or the table's last channel, as in
/// Gaussian images.
enum class Alpha { one, lastChannel };

/// The texels of a level: red, green and blue, which are 0 where the table has fewer channels, and
/// alpha.
[[nodiscard]] std::vector<Texel> texelsOf(const Table& table, std::uint32_t level,
                                          Alpha alpha = Alpha::one);

/// a + t (b - a). Inline: a synthesis calls it ten or more times per fetch, and a real call would
/// take a fifth of the time.
[[nodiscard]] inline Texel mix(const Texel& a, const Texel& b, float t) {
  Texel result{};
  for (std::size_t c = 0; c < result.size(); ++c)
    result[c] = a[c] + t * (b[c] - a[c]);
  return result;
}

/// Immutable: any number of threads may fetch from it.
class RepeatingImage {
public:
  using Value = Texel;

  RepeatingImage() = default;
  /// Throws std::bad_alloc.
  explicit RepeatingImage(const Table& table, Alpha alpha = Alpha::one) {
    for (std::uint32_t level = 0; level < table.mipLevels; ++level)
      mips_.push_back({std::max(1, int(table.width >> level)),
                       std::max(1, int(table.height >> level)), texelsOf(table, level, alpha)});
  }

  /// The value at (u, v), where the whole image is one unit. `lod` is in mip levels and is clamped
  /// to those that exist.
  [[nodiscard]] Value at(float u, float v, float lod) const {
    // Small integer parts, so that products with the side lose no fraction.
    u -= floorOf(u);
    v -= floorOf(v);
    const float level = std::clamp(lod, 0.0f, float(mips_.size() - 1));
    const auto fine = std::size_t(level);
    const Value value = bilinear(mips_[fine], u, v);
    const float t = level - float(fine);
    return t > 0.0f ? mix(value, bilinear(mips_[fine + 1], u, v), t) : value;
  }

  /// One texel of level 0, inside the image.
  [[nodiscard]] const Value& texel(int x, int y) const {
    return mips_[0].texels[std::size_t(y) * std::size_t(mips_[0].width) + std::size_t(x)];
  }

  [[nodiscard]] const std::vector<Value>& texels(std::size_t level) const {
    return mips_[level].texels;
  }
  [[nodiscard]] int width() const { return mips_[0].width; }
  [[nodiscard]] int height() const { return mips_[0].height; }

private:
  struct Mip {
    int width = 0;
    int height = 0;
    std::vector<Value> texels;
  };
  struct Corners {
    int x0, y0, x1, y1;
    float fx, fy; ///< from (x0, y0) to (x1, y1)
  };

  /// std::floor below 2^31, which is a call without SSE 4.1.
  [[nodiscard]] static float floorOf(float x) {
    const auto whole = float(int(x));
    return whole > x ? whole - 1.0f : whole;
  }
  /// For u and v in [0, 1].
  [[nodiscard]] static Corners cornersOf(const Mip& mip, float u, float v) {
    const float x = u * float(mip.width) - 0.5f, y = v * float(mip.height) - 0.5f;
    Corners at{};
    at.x0 = int(x + 1.0f) - 1; // both are above -1
    at.y0 = int(y + 1.0f) - 1;
    at.fx = x - float(at.x0);
    at.fy = y - float(at.y0);
    at.x1 = at.x0 + 1 < mip.width ? at.x0 + 1 : 0;
    at.y1 = at.y0 + 1 < mip.height ? at.y0 + 1 : 0;
    at.x0 = at.x0 < 0 ? mip.width - 1 : at.x0;
    at.y0 = at.y0 < 0 ? mip.height - 1 : at.y0;
    return at;
  }
  [[nodiscard]] static Value bilinear(const Mip& mip, float u, float v) {
    const Corners at = cornersOf(mip, u, v);
    const Value* const row0 = mip.texels.data() + std::size_t(at.y0) * std::size_t(mip.width);
    const Value* const row1 = mip.texels.data() + std::size_t(at.y1) * std::size_t(mip.width);
    return mix(mix(row0[at.x0], row0[at.x1], at.fx), mix(row1[at.x0], row1[at.x1], at.fx), at.fy);
  }

  std::vector<Mip> mips_;
};

/// Immutable: any number of threads may fetch from it.
class ClampedVolume {
public:
  ClampedVolume() = default;
  /// Throws std::bad_alloc.
  explicit ClampedVolume(const Table& table) {
    for (std::uint32_t level = 0; level < table.mipLevels; ++level)
      mips_.push_back(
          {{std::max(1, int(table.width >> level)), std::max(1, int(table.height >> level)),
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
