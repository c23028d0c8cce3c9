// SPDX-License-Identifier: MIT
// The smoothest part of a plane: what light from one side, or a vignette, adds to an image.
#pragma once

#include "low_pass.h"

namespace lichen::suitability {

/// The least-squares polynomial of degree 4 in x and y, of which only terms remain that stand out
/// from the material's own slow variation: the non-negative garrote [B95] makes an orthonormal term
/// c to c (1 - 4 S / c^2), or 0 if that is less, with S the mean square of the terms of degree 5 to
/// 8. A vignette by the fourth power of the cosine and a ramp are nearly such polynomials; of a
/// material without either, 1 term in 20 stands out. If `periodic`, it has only even powers of
/// both, about the middle, so that opposite borders stay alike. Throws std::bad_alloc.
[[nodiscard]] Plane trendOf(const Plane& plane, bool periodic);

} // namespace lichen::suitability
