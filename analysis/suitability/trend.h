// SPDX-License-Identifier: MIT
// The smoothest part of a plane: what light from one side, or a vignette, adds to an image.
#pragma once

#include "low_pass.h"

namespace lichen::suitability {

/// A polynomial of degree 4 in x and y: the least-squares fit, with its terms shrunk. An
/// orthonormal term c becomes c (1 - 4 S / c^2), or 0 if that is less, with S the mean square of
/// the terms of degree 5 to 8, which measures the material's own slow variation (non-negative
/// garrote, [B95]). Only the mean for planes of a few pixels, which have fewer than four such
/// terms. A vignette by the fourth power of the cosine and a ramp are nearly such polynomials; of a
/// material without either, 1 term in 20 stands out. If `periodic`, it has only even powers of
/// both, about the middle, so that opposite borders stay alike. Throws std::bad_alloc.
[[nodiscard]] Plane trendOf(const Plane& plane, bool periodic);

} // namespace lichen::suitability
