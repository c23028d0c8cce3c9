// SPDX-License-Identifier: MIT
// Whether a map has neither risk of what varies slowly.
#pragma once

#include "calibration.h"
#include "slow_variation.h"

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Whether `seen`, a map as an eye sees it, has neither the risk of low frequency nor that of
/// cloudiness. `cloudinessOf()`, which takes longer, is called only where the former is none.
template <class CloudinessOf>
[[nodiscard]] bool isCalm(const MapExemplar& seen, const CloudinessOf& cloudinessOf) {
  return slowVariationShare(seen) < kSlowVariation.mild && cloudinessOf() < kCloudiness.mild;
}

} // namespace lichen::suitability
