// SPDX-License-Identifier: MIT
// The first steps of a bake, for the tests of those that follow.
#pragma once

#include "example_exemplar.h"

#include <array>
#include <tiling/gaussianize.h>
#include <tiling/inverse_table.h>
#include <vector>

namespace lichen::test {

struct Baked {
  MapExemplar map;
  std::vector<Point> points;
  tiling::Gaussianized gaussian;
};

/// Exemplar to Gaussianized image.
[[nodiscard]] Baked baked(MapExemplar map, bool periodic = true,
                          gaussian::Precision precision = gaussian::Precision::bits16);

/// The values of an sRGB map as light.
[[nodiscard]] std::vector<float> light(const MapExemplar& map);

/// An independent, slow lookup: interpolates between cell middles by their hat functions.
[[nodiscard]] double slowLookup(const tiling::InverseTable& table,
                                const std::array<double, 3>& gaussian, int channel);

} // namespace lichen::test
