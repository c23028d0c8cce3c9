// SPDX-License-Identifier: MIT
// Whether the slow variation of an image is light and clouds, or a large object with an outline.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// mean |g|^4 / (mean |g|^2)^2 of the gradient g of the map's principal component, after a low-pass
/// at a period of an eighth of the longer side. 1 for a ramp; 2 for an isotropic Gaussian field,
/// where |g|^2 is exponential; 3 for a Gaussian field that varies along one axis, where |g|^2 is
/// the square of a Gaussian; for an object, the inverse of the share of the area along its outline.
/// 0 if the component does not vary. Throws std::bad_alloc.
[[nodiscard]] double edgeConcentration(const MapExemplar& map, bool periodic);

} // namespace lichen::suitability
