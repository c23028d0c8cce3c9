// SPDX-License-Identifier: MIT
// The simplex lattice of the tiling method. The format specifies it bit for bit.
//
// One unit of tile space is one exemplar. Rows of vertices are 1 / kLatticeRowsPerTile apart, and
// odd rows are shifted by half a cell: vertex (i, j) is at x = (i + j / 2) / columnsPerTile, y = j
// / rowsPerTile. With kLatticeRowsPerTile = 4 and columns = 2 sqrt(3), the triangles are
// equilateral with side 1 / (2 sqrt(3)), as in the shader of [HN18]. All functions are pure and
// thread-safe.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace lichen {

inline constexpr double kLatticeRowsPerTile = 4.0;
inline constexpr double kLatticeColumnsPerTile = 3.4641016151377545870548926830117; // 2 sqrt(3)

/// [JO20] "pcg": the PCG output function applied to one LCG step.
[[nodiscard]] constexpr std::uint32_t pcg(std::uint32_t value) {
  const std::uint32_t state = value * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

/// [JO20] "pcg3d": hashes three words to three.
[[nodiscard]] constexpr std::array<std::uint32_t, 3> pcg3d(std::array<std::uint32_t, 3> v) {
  for (std::uint32_t& word : v)
    word = word * 1664525u + 1013904223u;
  v[0] += v[1] * v[2];
  v[1] += v[2] * v[0];
  v[2] += v[0] * v[1];
  for (std::uint32_t& word : v)
    word ^= word >> 16u;
  v[0] += v[1] * v[2];
  v[1] += v[2] * v[0];
  v[2] += v[0] * v[1];
  return v;
}

/// The hash input that combines a noise's seed with a projection plane (0 for uv). The seed is
/// hashed so that no two seeds give the same noise shifted by a cell.
[[nodiscard]] constexpr std::uint32_t latticeSeed(std::uint32_t seed, std::uint32_t plane) {
  return pcg(pcg(seed) + plane);
}

/// log2 of the step between neighbouring tile offsets along a side of `size` >= 1 texels. The step
/// is the largest power of two that leaves at least 64 offsets. It keeps the first mip levels of a
/// power-of-two image aligned between tiles, so that minified tiles are equally sharp.
/// docs/decisions/005-tile-offsets.md explains the number 64.
[[nodiscard]] constexpr std::uint32_t tileOffsetShift(std::uint32_t size) {
  constexpr std::uint32_t kLeastOffsetsLog2 = 6;
  const auto log2 = std::uint32_t(std::bit_width(size)) - 1u;
  return log2 > kLeastOffsetsLog2 ? log2 - kLeastOffsetsLog2 : 0u;
}

/// The tile offset of a vertex, as an index into `countX` x `countY` offsets. Scaling the high 16
/// bits of the hash has a bias of at most 128 / 65536 for the at most 127 offsets along each side.
[[nodiscard]] constexpr std::array<std::uint32_t, 2>
tileOffsetIndex(std::uint32_t i, std::uint32_t j, std::uint32_t seedWord, std::uint32_t countX,
                std::uint32_t countY) {
  const std::array<std::uint32_t, 3> h = pcg3d({i, j, seedWord});
  return {((h[0] >> 16u) * countX) >> 16u, ((h[1] >> 16u) * countY) >> 16u};
}

/// The rotation of a vertex's tile: a number of steps, in [0, steps), of 2 pi / steps each; `steps`
/// <= 2^16. Uses the hash word that the offset does not use.
[[nodiscard]] constexpr std::uint32_t tileRotationStep(std::uint32_t i, std::uint32_t j,
                                                       std::uint32_t seedWord,
                                                       std::uint32_t steps) {
  return ((pcg3d({i, j, seedWord})[2] >> 16u) * steps) >> 16u;
}

/// The tile offset of a vertex in whole texels: components in [0, width) x [0, height), multiples
/// of the step.
[[nodiscard]] constexpr std::array<std::uint32_t, 2>
tileOffsetTexels(std::uint32_t i, std::uint32_t j, std::uint32_t seedWord, std::uint32_t width,
                 std::uint32_t height) {
  const std::uint32_t shiftX = tileOffsetShift(width);
  const std::uint32_t shiftY = tileOffsetShift(height);
  const auto index = tileOffsetIndex(i, j, seedWord, width >> shiftX, height >> shiftY);
  return {index[0] << shiftX, index[1] << shiftY};
}

/// The lattice that a material uses: infinite, or periodic with an integer number of cells.
struct Lattice {
  double columnsPerTile = kLatticeColumnsPerTile;
  double rowsPerTile = kLatticeRowsPerTile;
  std::int32_t periodColumns = 0; ///< 0 if not periodic
  std::int32_t periodRows = 0;    ///< even; 0 if not periodic
};

/// The periodic lattice over a rectangle of tiles. It has the nearest number of columns and the
/// nearest even number of rows, at least 3 columns and 4 rows, so it is slightly non-equilateral.
/// Both sides must be > 0 and at least about half a tile.
[[nodiscard]] Lattice periodicLattice(double widthTiles, double heightTiles);

/// The position of an integer tile origin in the lattice's skewed coordinates: the cell, modulo
/// 2^32 as in the hash, and the fraction within it in [0, 1), to the nearest float for |tile| up to
/// 2^40.
struct LatticeOrigin {
  std::array<std::int32_t, 2> cell{0, 0};
  std::array<float, 2> fraction{0.0f, 0.0f};
};
[[nodiscard]] LatticeOrigin latticeOrigin(std::int64_t tileX, std::int64_t tileY);

} // namespace lichen
