// SPDX-License-Identifier: MIT
// Maps -> the part that holds whole periods -> how clearly something repeats in it.
#include "exemplar/grain.h"
#include "exemplar/value_encoding.h"
#include "near_periods.h"
#include "suitability/gaussian_plane.h"
#include "suitability/spectral_measures.h"
#include "whole_periods.h"

#include <lichen/fft.h>
#include <lichen/regularity.h>

#include <algorithm>

namespace lichen {

namespace {

/// Whether the lattice is clearer than those that streaks have by chance. Source:
/// docs/decisions/012-quilting.md.
bool isClear(const placement::WholePeriods& periods) {
  constexpr double kLeastCorrelation = 0.4, kLeastContrast = 0.15;
  return periods.areSure && periods.correlation >= kLeastCorrelation &&
         periods.contrast >= kLeastContrast;
}

/// How coherent the phases of the map are across scales.
double outlinesOf(const MapExemplar& map, bool fit) {
  const std::optional<suitability::GaussianPlane> plane =
      suitability::gaussianPlane(map, {fit, exemplar::grainOf(map)});
  return plane ? suitability::phaseCoherence(forwardFft(plane->values, plane->width, plane->height))
               : 0.0;
}

} // namespace

Result<Regularity> regularityOf(std::span<const MapExemplar> maps, Periodic periodic) {
  const auto exhausted = [] { return "structure: not enough memory to look for periods"; };
  return withinMemory(exhausted, [&]() -> Result<Regularity> {
    Regularity regularity;
    if (std::min(maps.front().width, maps.front().height) < kLeastRegularSide)
      return regularity;
    const bool fit = bordersFit(maps, periodic);
    regularity.outlines = outlinesOf(maps.front(), fit);
    std::vector<MapExemplar> stored = exemplar::asStored(maps);
    const placement::WholePeriods periods = placement::wholePeriods(stored.front(), fit);
    regularity.hasLattice = isClear(periods);
    if (regularity.outlines < kLeastOutlines && !regularity.hasLattice)
      return regularity;
    if (!fit || periodic == Periodic::detect)
      regularity.wholePeriods = periods.part;
    if (regularity.wholePeriods)
      if (Result<void> made = rectify(stored, *regularity.wholePeriods); !made)
        return made.error();
    constexpr double kNoShifts = 0.0;
    regularity.strength = placement::nearPeriods(stored, 0, kNoShifts).strength;
    if (!regularity.repeats())
      regularity.wholePeriods.reset();
    return regularity;
  });
}

} // namespace lichen
