// SPDX-License-Identifier: MIT
// Whether a map varies too little at low frequencies to be at risk.
#pragma once

#include "calibration.h"
#include "slow_variation.h"

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Whether `seen`, a map as an eye sees it, has neither the low-frequency nor the cloudiness risk.
/// Calls `cloudinessOf()`, which takes longer, only if the first risk is absent.
template <class CloudinessOf>
[[nodiscard]] bool hasNoSlowRisk(const MapExemplar& seen, const CloudinessOf& cloudinessOf) {
  return slowVariationShare(seen) < kSlowVariation.mild && cloudinessOf() < kCloudiness.mild;
}

} // namespace lichen::suitability
