// SPDX-License-Identifier: MIT
// The Gaussian version of an exemplar for the methods that decode by an inverse table: its Gaussian
// values with random phases, decoded.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image.h>
#include <lichen/result.h>

#include <cstdint>

namespace lichen {

/// As large as the exemplar, which must be within its ranges; decoded values as synthesize()
/// returns them. One phase serves all channels, so that the covariance of all channels stays.
/// Errors: as bakeTiling(). Throws std::bad_alloc. Source: [GGM11].
[[nodiscard]] Result<LinearImage> randomPhaseVersion(const MapExemplar& exemplar,
                                                     std::uint32_t seed);

} // namespace lichen
