// SPDX-License-Identifier: MIT
// Cosines and vectors -> the image that the shader reads.
#pragma once

#include "cosine_vectors.h"

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

/// The image of a map, as LocalRandomPhaseMap specifies it. The number of cosines is even.
[[nodiscard]] Table cosineTable(const std::vector<Cosine>& cosines, const CosineVectors& vectors,
                                const MapRows& rows);

} // namespace lichen::local_random_phase
