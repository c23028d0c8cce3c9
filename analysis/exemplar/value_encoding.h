// SPDX-License-Identifier: MIT
// A map's stored values -> the quantity that averages correctly, and back.
#pragma once

#include <lichen/bundle.h>

namespace lichen::exemplar {

/// Returns linear light for srgb and log2 values, the value itself for linear ones and slopes.
[[nodiscard]] float decoded(float value, ValueEncoding encoding);
[[nodiscard]] float encoded(float value, ValueEncoding encoding);

} // namespace lichen::exemplar
