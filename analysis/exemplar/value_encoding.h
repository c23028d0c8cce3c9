// SPDX-License-Identifier: MIT
// A map's stored values -> the quantity that averages, and back.
#pragma once

#include <lichen/bundle.h>

namespace lichen::exemplar {

/// Light for srgb and log2 values, the value itself for linear ones and slopes.
[[nodiscard]] float decoded(float value, ValueEncoding encoding);
[[nodiscard]] float encoded(float value, ValueEncoding encoding);

} // namespace lichen::exemplar
