// SPDX-License-Identifier: MIT
// Covariances between the maps of a set, of an exemplar and of its results.
#pragma once

#include <lichen/image.h>
#include <lichen/tiling.h>

#include <span>
#include <vector>

namespace lichen::test {

/// Covariances of each channel of `a` with each of `b`, those of `b` fastest; images of one size.
[[nodiscard]] std::vector<double> crossCovariances(const LinearImage& a, const LinearImage& b);

/// The exemplar's maps as `synthesize` gives maps: light, slopes, data.
[[nodiscard]] std::vector<LinearImage> decodedMaps(std::span<const MapExemplar> maps);

[[nodiscard]] double norm(const std::vector<double>& values);

} // namespace lichen::test
