// SPDX-License-Identifier: MIT
// Fills in colours for transparent pixels.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::exemplar {

/// Replaces the colours of transparent pixels with the colours of covered pixels around them,
/// weighted by coverage, in linear light: the pull-push algorithm of [GGSC96]. The weight of a
/// pixel's own colour is its opacity over the largest opacity. So a pixel with the largest opacity
/// does not change, and an image of constant opacity does not change at all. `opacity` has one
/// channel and any size.
void fillInvisible(MapExemplar& color, const MapExemplar& opacity);

} // namespace lichen::exemplar
