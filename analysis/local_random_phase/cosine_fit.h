// SPDX-License-Identifier: MIT
// A power spectrum -> the cosines whose noise has it: their frequencies, octaves and energies.
#pragma once

#include "random_phase/power_tree.h"

#include <array>
#include <span>
#include <vector>

namespace lichen::local_random_phase {

using random_phase::FrequencyBox;
using random_phase::PowerPlane;

/// A cosine: at each vertex of its octave's lattice, one frequency of its box.
struct Cosine {
  FrequencyBox box;
  int octave = 0;
  double energy = 0.0; ///< the variance that it adds
};

/// Fits cosines with these boxes to a power plane whose values, each counted for its frequency and
/// for the mirror, sum to the variance: O(columns rows). Boxes without power have none. `isGiven`:
/// each cosine has the power of its box, as boxesAroundPower() makes them; otherwise energies are
/// fitted, and a spectrum that is 0 nearly everywhere would leave most cosines none. `edges`: those
/// of octave 0 along x and y [tiles]. The result is ordered by octave, and each octave has an even
/// number of cosines: one without frequencies and energy follows an odd number. Throws
/// std::bad_alloc.
[[nodiscard]] std::vector<Cosine> fitCosines(const PowerPlane& power,
                                             std::span<const FrequencyBox> boxes,
                                             const std::array<double, 2>& edges, bool isGiven);

} // namespace lichen::local_random_phase
