// SPDX-License-Identifier: MIT
// One map of a bake as the report's page shows it.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/json_tree.h>
#include <lichen/noise_report.h>
#include <lichen/progress.h>
#include <lichen/suitability.h>

namespace lichen {

/// A map that is shown.
struct ShownExemplar {
  const MapExemplar& exemplar;
  const std::vector<Risk>& risks;
  const ExemplarOrigin& origin;
};

/// What the page's script reads for a map: pictures as data URIs, measures, charts' values.
/// The exemplar's picture has as many pixels as a square of `exemplarSide`, at most. The noise is
/// the material's. Errors as compareNoise().
[[nodiscard]] Result<JsonTree> describeMap(const Bundle& bundle, const MaterialNoise& material,
                                           const ShownExemplar& shown, int exemplarSide,
                                           const Progress& progress);

} // namespace lichen
