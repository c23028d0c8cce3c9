// SPDX-License-Identifier: MIT
// Finds the frame around a scan or a screenshot, which is not the material.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/material_set.h>

#include <optional>

namespace lichen::exemplar {

/// The part of a picture inside its frame; nothing if it has none. A frame is at most a quarter of
/// the side wide, at one or more borders. Each of its lines has at most a quarter of the contrast
/// of the lines inside, and a mean far from theirs. Two more pixels are left out, where edges are
/// smoothed. There is no frame if the picture has fewer than 16 lines, or lines like the frame's
/// inside, such as grout. Throws std::bad_alloc.
[[nodiscard]] std::optional<PixelRectangle> insideOfFrame(const MapExemplar& map);

} // namespace lichen::exemplar
