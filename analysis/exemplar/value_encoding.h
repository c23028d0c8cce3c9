// SPDX-License-Identifier: MIT
// A map's stored values -> the quantity that averages correctly, and back; and the conditions that
// a map must meet before a bake.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <span>
#include <vector>

namespace lichen::exemplar {

/// Returns linear light for srgb, root and log2 values, the value itself for linear ones and
/// slopes.
[[nodiscard]] float decoded(float value, ValueEncoding encoding);
[[nodiscard]] float encoded(float value, ValueEncoding encoding);

/// The value that an inverse table holds for a stored value, and back: the square root of light for
/// srgb and root, otherwise the decoded value.
[[nodiscard]] float tableValue(float stored, ValueEncoding encoding);
[[nodiscard]] float storedOfTable(float tableValue, ValueEncoding encoding);

/// The encoding in which a noise stores values of this encoding: roots of light in place of sRGB
/// codes.
[[nodiscard]] ValueEncoding storedEncoding(ValueEncoding encoding);
/// The map with its values in that encoding. Throws std::bad_alloc.
[[nodiscard]] MapExemplar asStored(const MapExemplar& map);
/// The same for several maps.
[[nodiscard]] std::vector<MapExemplar> asStored(std::span<const MapExemplar> maps);

/// Checks the ranges that MapExemplar states. On failure returns a usage error that names the
/// offending value. Throws std::bad_alloc if there is no memory for the message.
[[nodiscard]] Result<void> checkRanges(const MapExemplar& map);
/// The same for all of at least one map.
[[nodiscard]] Result<void> checkRanges(std::span<const MapExemplar> maps);

} // namespace lichen::exemplar
