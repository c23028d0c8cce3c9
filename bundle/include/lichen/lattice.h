// SPDX-License-Identifier: MIT
// The simplex lattice of the tiling method. The format specifies it bit for bit.
//
// One unit of tile space is one exemplar. Rows of vertices are 1 / kLatticeRowsPerTile apart, and
// odd rows are shifted by half a cell: vertex (i, j) is at x = (i + j / 2) / columnsPerTile, y = j
// / rowsPerTile. 4 rows and 3.5 columns a tile put the vertices of every second tile at its
// corners; the triangles are equilateral to 1 %, with the side of those in the shader of [HN18].
// With a grain, triangles are twice as long along it.
// All functions are pure and thread-safe.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

namespace lichen {

inline constexpr double kLatticeRowsPerTile = 4.0;
inline constexpr double kLatticeColumnsPerTile = 3.5; // equilateral: 2 sqrt(3), or 3.46

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
/// docs/decisions/001-tiling.md explains the number 64.
[[nodiscard]] constexpr std::uint32_t tileOffsetShift(std::uint32_t size) {
  constexpr std::uint32_t kLeastOffsetsLog2 = 6;
  const auto log2 = std::uint32_t(std::bit_width(size)) - 1u;
  return log2 > kLeastOffsetsLog2 ? log2 - kLeastOffsetsLog2 : 0u;
}

/// A vertex of the lattice -> two random halves of 16 bits.
[[nodiscard]] constexpr std::uint32_t vertexHash(std::uint32_t i, std::uint32_t j,
                                                 std::uint32_t seedWord) {
  // i is mixed before j is added: of a sum of products vertices would repeat in rows. The seed
  // comes in between, so that no two seeds give one field shifted by less than 2^31 rows.
  // Then the finalizer of MurmurHash3 [A16] with other shifts.
  std::uint32_t h = i * 0x9E3779B1u;
  h = ((h ^ (h >> 15u)) + j) ^ seedWord;
  h *= 0x85EBCA6Bu;
  h = (h ^ (h >> 15u)) * 0xC2B2AE35u;
  return h ^ (h >> 16u);
}

/// The tile offset of a vertex in steps of 2^tileOffsetShift texels, 11 bits along each side. Steps
/// wrap around the tile. A side of `size` texels has m = size / gcd(size, step) different offsets.
/// - If the step divides the size, as for powers of two, m is 64 to 127 (less below 64 texels), and
///   no offset is more than a sixteenth likelier than another.
/// - Otherwise m is larger, and an offset occurs for floor(2048 / m) of the 2048 values or for one
///   more: of 375 offsets of 1500 texels for 5 or 6, of 1023 offsets of 1023 texels for 2 or 3, and
///   above 2048 offsets for 0 or 1.
[[nodiscard]] constexpr std::array<std::uint32_t, 2>
tileOffsetSteps(std::uint32_t i, std::uint32_t j, std::uint32_t seedWord) {
  const std::uint32_t h = vertexHash(i, j, seedWord);
  return {h & 0x7FFu, h >> 21u};
}

/// The quarter turns, [0, 3], by which a vertex's tile is rotated. `tileRotation` is 4, or 2 for
/// half turns alone. Hashes again what gives the offset.
[[nodiscard]] constexpr std::uint32_t tileQuarterTurns(std::uint32_t i, std::uint32_t j,
                                                       std::uint32_t seedWord,
                                                       std::uint32_t tileRotation) {
  return (pcg(vertexHash(i, j, seedWord)) >> 30u) & (tileRotation == 2u ? 2u : 3u);
}

/// The tile offset of a vertex in whole texels, components in [0, width) x [0, height).
[[nodiscard]] constexpr std::array<std::uint32_t, 2>
tileOffsetTexels(std::uint32_t i, std::uint32_t j, std::uint32_t seedWord, std::uint32_t width,
                 std::uint32_t height) {
  const auto steps = tileOffsetSteps(i, j, seedWord);
  return {(steps[0] << tileOffsetShift(width)) % width,
          (steps[1] << tileOffsetShift(height)) % height};
}

/// The axis nearest to the long streaks of an exemplar such as wood; none without such streaks.
enum class Grain { none, x, y };
/// "none", "x" or "y". grainFrom() knows "x" and "y", since files leave out the member otherwise.
[[nodiscard]] std::string_view nameOf(Grain grain);
[[nodiscard]] std::optional<Grain> grainFrom(std::string_view name);

/// The lattice of a noise with a grain has cells longer along it by this factor, so that borders of
/// tiles cut half as many streaks. docs/decisions/006-light-and-grain.md chose it.
inline constexpr double kGrainStretch = 2.0;

/// The lattice that a material uses: infinite, or periodic with an integer number of cells.
struct Lattice {
  double columnsPerTile = kLatticeColumnsPerTile;
  double rowsPerTile = kLatticeRowsPerTile;
  std::int32_t periodColumns = 0; ///< 0 if not periodic
  std::int32_t periodRows = 0;    ///< even; 0 if not periodic
};

/// The lattice without a period.
[[nodiscard]] Lattice infiniteLattice(Grain grain);

/// The periodic lattice over a rectangle of tiles. It has the columns of infiniteLattice() to the
/// nearest number and its rows to the nearest even number, at least 3 columns and 4 rows, so its
/// triangles are slightly different, and less stretched in a small rectangle. Both sides must be >
/// 0 and at least about half a tile.
[[nodiscard]] Lattice periodicLattice(double widthTiles, double heightTiles,
                                      Grain grain = Grain::none);

/// The number of tiles side by side in which an infinite lattice has a whole number of columns: 2,
/// or 4 with a grain along x.
[[nodiscard]] std::int64_t latticeOriginStep(Grain grain);

/// The cell of an integer tile origin in the skewed coordinates of an infinite lattice, modulo 2^32
/// as in the hash. `tileX` must be a multiple of latticeOriginStep(): other origins do not lie at
/// the corner of a cell.
[[nodiscard]] std::array<std::int32_t, 2> latticeCell(std::int64_t tileX, std::int64_t tileY,
                                                      Grain grain = Grain::none);

} // namespace lichen
