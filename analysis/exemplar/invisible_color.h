// SPDX-License-Identifier: MIT
// Colours for the pixels of which nobody has seen one.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::exemplar {

/// Replaces the colours of transparent pixels by those of covered pixels around them, weighted by
/// coverage, in light: the pull-push algorithm of [GGSC96]. A pixel keeps the share
/// of its own colour that its opacity has of the largest; so one that is covered most keeps it all,
/// and where opacity is the same everywhere nothing changes. `opacity` has one channel and any
/// size.
void fillInvisible(MapExemplar& color, const MapExemplar& opacity);

} // namespace lichen::exemplar
