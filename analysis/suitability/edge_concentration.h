// SPDX-License-Identifier: MIT
// Whether what varies slowly in an image is light or clouds, or a large object with its outline.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// mean |g|^4 / (mean |g|^2)^2 of the gradient g of the map's principal component, low-passed by a
/// period of an eighth of its longer side: 1 for a ramp, 2 for a Gaussian field alike in all
/// directions (|g|^2 is exponential), 3 for one that varies along one axis (the square of a
/// Gaussian), and the inverse of the share of the area along the outline for an object. 0 for a map
/// whose component does not vary. Throws std::bad_alloc.
[[nodiscard]] double edgeConcentration(const MapExemplar& map, bool periodic);

} // namespace lichen::suitability
