// SPDX-License-Identifier: MIT
// What a map must be for anything to be made of it.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/result.h>

namespace lichen::exemplar {

/// Whether the map keeps within the ranges that MapExemplar states; the Error, usage, names the
/// value that does not. Throws std::bad_alloc where memory does not suffice for the message.
[[nodiscard]] Result<void> checkRanges(const MapExemplar& map);

} // namespace lichen::exemplar
