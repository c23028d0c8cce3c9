// SPDX-License-Identifier: MIT
// Cosines, vectors and structure -> the image that the shader reads.
#pragma once

#include "cosine_vectors.h"
#include "structure.h"

#include <lichen/table.h>

#include <cstddef>
#include <vector>

namespace lichen::local_random_phase {

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
