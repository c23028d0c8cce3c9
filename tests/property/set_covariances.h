// SPDX-License-Identifier: MIT
// Covariances between the maps of a set, for an exemplar and for its results.
#pragma once

#include <lichen/image.h>
#include <lichen/tiling.h>

#include <span>
#include <vector>

namespace lichen::test {

/// Covariances of each channel of `a` with each channel of `b`; the channels of `b` vary fastest.
/// Both images have the same size.
[[nodiscard]] std::vector<double> crossCovariances(const LinearImage& a, const LinearImage& b);

/// Decodes the exemplar's maps as `synthesize` outputs maps: light, slopes, data.
[[nodiscard]] std::vector<LinearImage> decodedMaps(std::span<const MapExemplar> maps);

[[nodiscard]] double norm(const std::vector<double>& values);

} // namespace lichen::test
