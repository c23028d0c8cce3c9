// SPDX-License-Identifier: MIT
// Cosines, vectors and structure -> the image that the shader reads.
#pragma once

#include "cosine_vectors.h"

#include <lichen/local_random_phase_map.h>
#include <lichen/table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lichen::local_random_phase {

/// Frequencies of a half plane, as in PowerPlane.
class FrequencySet {
public:
  FrequencySet(int columns, int rows)
      : columns_(columns), rows_(rows), holds_(std::size_t(columns) * std::size_t(rows), 0) {}

  [[nodiscard]] bool holds(int u, int v) const { return holds_[index(u, v)] != 0; }
  void add(int u, int v) { holds_[index(u, v)] = 1; }
  /// The largest |u| and |v|; 0 of an empty set.
  [[nodiscard]] std::array<int, 2> largest() const;
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }

private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    return std::size_t(v + rows_ / 2) * std::size_t(columns_) + std::size_t(u);
  }

  int columns_, rows_;
  std::vector<std::uint8_t> holds_;
};

/// The frequencies around which power is highest, so many that they hold at least the proportion
/// `share` of it, in [0, 1]: none for 0, all for 1. Whole regions, as random waves between single
/// fixed ones would show as stripes. Both mirrors of column 0 are in it, or neither.
[[nodiscard]] FrequencySet strongestFrequencies(const PowerPlane& power, double share);

/// Splits a spectrum into what has the frequencies of the set and the rest.
struct SplitSpectrum {
  MapSpectrum inside, outside;
};
[[nodiscard]] SplitSpectrum split(MapSpectrum spectrum, const FrequencySet& set);

/// The columns and rows of an image that holds a set: powers of two.
[[nodiscard]] std::array<int, 2> structureSize(const FrequencySet& set);

/// One map's structure: B-spline coefficients, in standard deviations, at each level.
struct StructureImage {
  struct Level {
    int columns = 0, rows = 0;
    std::vector<std::array<float, 3>> texels; ///< row by row; unused channels are 0
  };
  std::vector<Level> levels;
  std::vector<double> deviations; ///< of each level: root mean square over the map's channels
};

/// `inside`: of the structure's frequencies. Level l is what footprints of
/// 2^l of its own texels leave. `offsets` [tiles]: the image is the mean over all of them; none
/// stand for offset 0. Throws std::bad_alloc.
[[nodiscard]] StructureImage structureImage(const MapSpectrum& inside,
                                            const CosineStructure& structure,
                                            const std::vector<std::array<double, 2>>& offsets);

/// The number of cosines of each octave, as LocalRandomPhaseNoise has it.
[[nodiscard]] std::vector<int> cosinesByOctave(const std::vector<Cosine>& cosines);

/// The rows of a map in CosineVectors: its number, and its first channel and their number, which is
/// 0 for a map that does not vary.
struct MapRows {
  std::size_t map = 0;
  std::size_t first = 0;
  std::size_t channels = 0;
};

/// The structure of a map: its image, and the mean of that over the offsets of the list [tiles].
struct MapStructure {
  StructureImage image;
  StructureImage mean; ///< without levels if there is no list
  std::vector<std::array<double, 2>> offsets;

  /// The largest magnitude of a coefficient of channel `channel`, in standard deviations.
  [[nodiscard]] double largest(std::size_t channel) const;
};

/// The image of a map, as LocalRandomPhaseMap specifies it. The number of cosines is even.
[[nodiscard]] Table cosineTable(const LocalRandomPhaseNoise& shared,
                                const std::vector<Cosine>& cosines, const CosineVectors& vectors,
                                const MapRows& rows, const MapStructure& structure);

} // namespace lichen::local_random_phase
