// SPDX-License-Identifier: MIT
// One map of a bake as the report's page shows it.
#pragma once

#include <lichen/bundle.h>
#include <lichen/json_tree.h>
#include <lichen/progress.h>
#include <lichen/tiling.h>

namespace lichen {

/// What the page's script reads for a map: pictures as data URIs, measures, charts' values.
/// `exemplarSide` is the longer side of the exemplar's picture in pixels, at most. The noise is the
/// bundle's first. Errors as compareNoise().
[[nodiscard]] Result<JsonTree> describeMap(const Bundle& bundle, std::uint32_t seed,
                                           const MapExemplar& exemplar, bool exemplarWasPeriodic,
                                           int exemplarSide, const Progress& progress);

} // namespace lichen
