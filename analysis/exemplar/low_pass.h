// SPDX-License-Identifier: MIT
// The slow part of a plane: a low-pass filter, the trend of light from one side or a vignette, and
// whether it is light and clouds or a large object with an outline.
#pragma once

#include "planes.h"

#include <lichen/exemplar.h>

#include <cmath>
#include <vector>

namespace lichen::exemplar {

/// A period along each axis, in pixels.
struct Period {
  double x = 0.0;
  double y = 0.0;
};

/// The plane and its mirror images, 2 width x 2 height: periodic, and continuous at the borders.
[[nodiscard]] Plane mirrored(const Plane& plane);

/// `trend`, and what lowPassGain() leaves of the rest of the plane, which repeats beyond the
/// borders if `periodic` and is mirrored otherwise. Without trendOf(), a mirrored ramp would have a
/// crease that no filter follows. Throws std::bad_alloc.
[[nodiscard]] Plane lowPassed(const Plane& plane, Plane trend, const Period& period, bool periodic);

/// The gain of a Gaussian low-pass that halves the amplitude at one cycle per period:
/// 2^-(x^2 + y^2) at a frequency (x, y) in cycles per period.
[[nodiscard]] inline double lowPassGain(double cyclesX, double cyclesY) {
  return std::exp2(-(cyclesX * cyclesX + cyclesY * cyclesY));
}

/// A polynomial of degree 4 in x and y: the least-squares fit, with its terms shrunk. An
/// orthonormal term c becomes c (1 - 4 S / c^2), or 0 if that is less, with S the mean square of
/// the terms of degree 5 to 8, which measures the material's own slow variation (non-negative
/// garrote, [B95]). Only the mean for planes of a few pixels, which have fewer than four such
/// terms. A vignette by the fourth power of the cosine and a ramp are nearly such polynomials; of a
/// material without either, 1 term in 20 stands out. If `periodic`, it has only even powers of
/// both, about the middle, so that opposite borders stay alike. Throws std::bad_alloc.
[[nodiscard]] Plane trendOf(const Plane& plane, bool periodic);

/// Above this, slow variation is an object with an outline, not light. The geometric mean of 3.3,
/// the largest value of light and clouds, and 5.4, the smallest value of objects, in
/// docs/decisions/006-light-and-grain.md.
inline constexpr double kEdgeConcentration = 4.2;

/// The shortest period of uneven light, as a share of the exemplar's longer side: faster variation
/// is the material itself.
inline constexpr double kShortestLight = 1.0 / 8.0;

/// mean |g|^4 / (mean |g|^2)^2 of the gradient g of the map's principal component, after a low-pass
/// at a period of an eighth of the longer side. 1 for a ramp; 2 for an isotropic Gaussian field,
/// where |g|^2 is exponential; 3 for a Gaussian field that varies along one axis, where |g|^2 is
/// the square of a Gaussian; for an object, the inverse of the share of the area along its outline.
/// 0 if the component does not vary. Throws std::bad_alloc.
[[nodiscard]] double edgeConcentration(const MapExemplar& map, bool periodic);

} // namespace lichen::exemplar
