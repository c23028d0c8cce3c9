// SPDX-License-Identifier: MIT
// Runs the first steps of a bake, for the tests of the later steps.
#pragma once

#include "example_exemplar.h"

#include <array>
#include <gaussian/gaussianize.h>
#include <gaussian/inverse_table.h>
#include <vector>

namespace lichen::test {

struct Baked {
  MapExemplar map;
  std::vector<Point> points;
  gaussian::Gaussianized gaussian;
};

/// Exemplar to Gaussianized image.
[[nodiscard]] Baked baked(MapExemplar map, bool periodic = true,
                          gaussian::Precision precision = gaussian::Precision::bits16);

/// The square roots of an sRGB map's light.
[[nodiscard]] std::vector<float> tableValues(const MapExemplar& map);

/// Independent, slow lookup: interpolates between cell centres with hat functions.
[[nodiscard]] double slowLookup(const gaussian::InverseTable& table,
                                const std::array<double, 3>& gaussian, int channel);

} // namespace lichen::test
