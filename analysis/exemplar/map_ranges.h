// SPDX-License-Identifier: MIT
// The conditions that a map must meet before a bake.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <span>

namespace lichen::exemplar {

/// Checks the ranges that MapExemplar states. On failure returns a usage error that names the
/// offending value. Throws std::bad_alloc if there is no memory for the message.
[[nodiscard]] Result<void> checkRanges(const MapExemplar& map);
/// The same for all of at least one map.
[[nodiscard]] Result<void> checkRanges(std::span<const MapExemplar> maps);

} // namespace lichen::exemplar
