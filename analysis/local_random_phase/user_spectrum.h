// SPDX-License-Identifier: MIT
// A spectrum that the user gives in place of the exemplar's.
#pragma once

#include "cosine_vectors.h"

#include <lichen/local_random_phase.h>

namespace lichen::local_random_phase {

/// The transform of a random field with the powers of `picture` in each channel, and the variances
/// of `exemplar`. The channels do not correlate. Throws std::bad_alloc.
[[nodiscard]] MapSpectrum withPowersOf(const SpectrumPicture& picture, MapSpectrum exemplar);

} // namespace lichen::local_random_phase
