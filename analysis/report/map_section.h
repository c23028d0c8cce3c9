// SPDX-License-Identifier: MIT
// One map's section of the report page.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/measures.h>
#include <lichen/noise_report.h>
#include <lichen/progress.h>
#include <lichen/suitability.h>

#include <string>
#include <vector>

namespace lichen {

/// A map in the report.
struct ShownExemplar {
  const MapExemplar& exemplar;
  const std::vector<Risk>& risks;
  const ExemplarOrigin& origin;
};

struct MapSection {
  ShownExemplar shown;
  std::string markup;
  std::vector<Measure> measures;
};

/// The section of one map. The pictures of the exemplar, the original and the Gaussian version have
/// at most exemplarSide^2 pixels each, and the result has four times as many. The noise is the
/// material's. Settings that help against a risk are in `words`. Errors: as compareNoise().
[[nodiscard]] Result<MapSection> describeMap(const Bundle& bundle, const MaterialNoise& material,
                                             const ShownExemplar& shown, SettingWords words,
                                             int exemplarSide, const Progress& progress);

} // namespace lichen
