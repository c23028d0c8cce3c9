// SPDX-License-Identifier: MIT
// The data of a multiple-kernels noise [MKN12]: few kernels, thrown at random points.
#pragma once

#include <lichen/table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace lichen {

inline constexpr int kMostKernels = 64;
inline constexpr int kMostPatternCosines = 96;
/// The number of tiles that hold whole columns and rows of each kernel's grid.
inline constexpr int kKernelTiles = 8;
inline constexpr int kMostKernelCells = 1 << 15; ///< columns, rows, cubes or layers in those

/// The windows of kernels, which are 0 outside the unit disk, or outside the square [-1, 1]^2.
enum class KernelWindow {
  gabor,       ///< (1 - p^2 - q^2)^3, close to a Gaussian
  sinc,        ///< sinc(2 p) sinc(2 q)
  gaussianSinc ///< the same times ((1 - p^2)(1 - q^2))^2
};
[[nodiscard]] std::string_view nameOf(KernelWindow value);
[[nodiscard]] std::optional<KernelWindow> kernelWindowFrom(std::string_view name);

/// What all maps of a noise share. Each kernel has a grid of its own, with one impact in each cell.
struct MultipleKernelsNoise {
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int kernels = 1;        ///< [1, kMostKernels]
  int rings = 0;          ///< the last so many kernels have a direction at random, [0, kernels]
  int cosines = 0;        ///< of a pattern that the kernels perturb, [0, kMostPatternCosines]
  KernelWindow window = KernelWindow::gabor;
  /// As LocalRandomPhaseNoise::hasGivenSpectrum.
  bool hasGivenSpectrum = false;

  [[nodiscard]] bool operator==(const MultipleKernelsNoise&) const = default;
};

/// A map's kernels and inverse table. The image has a row for each kernel, of RGBA32F texels:
/// - column 0: the frequency f along x and y [cycles / tile], of a ring its length and 0; columns
///   and rows of the grid in kKernelTiles tiles, whole numbers in [1, kMostKernelCells];
/// - column 1: the matrix Q, row by row [1 / tile]: at the offset d from an impact [tiles] the
///   kernel is cos(2 pi f.d) w(Q d);
/// - column 2: the amplitude of the kernel, with which the squares over all impacts sum to 1 in the
///   mean; on a surface the cubes of its grid in kKernelTiles tile widths, and in a solid the
///   layers, whole numbers in [1, kMostKernelCells]; and Q along z [1 / tile width], above 0;
/// - columns 3, 4 and 5: of the first, second and third channel, the deviation that each of the
///   four waves of an impact adds [Gaussian values].
/// Columns 0 to 2 are the same for all maps.
/// Below the kernels lies the pattern, three cosines in a row, each in two texels: its frequency
/// along x and y [whole cycles / tile], then for the first, second and third channel the amplitudes
/// of its cosine and its sine [Gaussian values]. Texels that no cosine has are 0.
struct MultipleKernelsMap {
  std::size_t kernels = 0;                 ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< as TilingMap::inverseTable
  int dimensions = 1;                      ///< D, [1, 3]

  /// As in TilingMap.
  [[nodiscard]] std::size_t imageTable() const { return kernels; }
  [[nodiscard]] std::optional<std::size_t> decodingTable() const { return inverseTable; }

  /// Calls visit(index) for each table index.
  template <class Self, class Visit>
  static void visitTables(Self& self, const Visit& visit) {
    visit(self.kernels);
    if (self.inverseTable)
      visit(*self.inverseTable);
  }

  [[nodiscard]] bool operator==(const MultipleKernelsMap&) const = default;
};

/// One row of the image.
struct KernelRow {
  std::array<float, 2> frequency{};
  int columns = 1, rows = 1;
  std::array<float, 4> toWindow{}; ///< Q, row by row
  float amplitude = 0.0f;
  int cubes = 1;  ///< on surfaces
  int layers = 1; ///< in solids
  float toWindowZ = 1.0f;
  std::array<std::array<float, 4>, 3> colors{};
};
inline constexpr std::uint32_t kKernelTexels = 6;

/// A wave of a pattern: of channel c, waves[c][0] cos(2 pi f.x) + waves[c][1] sin(2 pi f.x).
struct PatternCosine {
  std::array<float, 2> frequency{}; ///< f [cycles / tile]
  std::array<std::array<float, 2>, 3> waves{};
};
inline constexpr std::uint32_t kRowPatternCosines = 3;

/// The rows of an image that a pattern of so many cosines has.
[[nodiscard]] constexpr std::uint32_t patternRows(int cosines) {
  return (std::uint32_t(cosines) + kRowPatternCosines - 1u) / kRowPatternCosines;
}

/// The kernels of an image, and its pattern.
[[nodiscard]] std::vector<KernelRow> kernelRows(const Table& image,
                                                const MultipleKernelsNoise& noise);
[[nodiscard]] std::vector<PatternCosine> patternCosines(const Table& image,
                                                        const MultipleKernelsNoise& noise);
[[nodiscard]] Table kernelTable(const std::vector<KernelRow>& rows,
                                const std::vector<PatternCosine>& pattern = {});

/// The largest magnitudes in the image: of frequencies, of Q, whose determinant is at least
/// kLeastKernelDeterminant in magnitude, and of amplitudes and colours.
inline constexpr float kMostKernelFrequency = 16384.0f, kMostToWindow = 65536.0f,
                       kLeastToWindowZ = 1e-3f, kLeastKernelDeterminant = 1e-3f,
                       kMostKernelValue = 1024.0f;
/// The most impacts of all kernels that may reach a point, of each mapping, on average, and cells
/// that a support may reach along any axis. The largest bake has a quarter of that.
inline constexpr double kMostKernelImpacts = 16384.0, kMostKernelReach = 256.0;

} // namespace lichen
