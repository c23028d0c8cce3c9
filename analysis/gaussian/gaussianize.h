// SPDX-License-Identifier: MIT
// The Gaussianized image of an exemplar: [HN18] section 4.2.
#pragma once

#include "cross_fade.h"
#include "exemplar/color_space.h"
#include "gaussian_distribution.h"
#include "progress_part.h"
#include "transport/assignment.h"

#include <lichen/gaussianization.h>

#include <cstdint>
#include <vector>

namespace lichen::gaussian {

/// A Gaussianized image and its correspondence with the exemplar's values.
struct Gaussianized {
  int width = 0;
  int height = 0;
  int dimensions = 1;
  /// The image that the shader fetches: periodic, width * height points, a permutation of
  /// stratifiedGaussian(width * height, dimensions, precision).
  std::vector<Point> image;
  /// The Gaussian point matched to each pixel of the exemplar, before borders are blended: the
  /// pairs that the inverse table is fitted to.
  std::vector<Point> matched;
};

/// Matches the exemplar's points to the stratified Gaussian set. If the borders do not
/// fit, they are then cross-faded and the image is matched to the set again.
[[nodiscard]] Gaussianized gaussianize(const MapExemplar& map, const std::vector<Point>& points,
                                       int dimensions, gaussian::BorderTreatment borders,
                                       gaussian::Precision precision,
                                       const transport::TransportOptions& options);

/// Gaussianizes points close to those that `near` was made from, in the same order, by exchanges
/// that start from the matching of `near`.
[[nodiscard]] Gaussianized gaussianizeNear(const Gaussianized& near,
                                           const std::vector<Point>& points,
                                           gaussian::BorderTreatment borders,
                                           const transport::TransportOptions& options);

/// The same for points in one dimension; `order` lists them from smallest to largest.
[[nodiscard]] Gaussianized gaussianizeInOrder(const Gaussianized& near,
                                              const std::vector<std::uint32_t>& order,
                                              gaussian::BorderTreatment borders);

/// G = 1/2 + A^-1 (x - mean) / 6, with A the lower Cholesky factor of the map's covariance, which
/// must be positive definite. If the borders do not fit they are then cross-faded. Mean 1/2 and
/// covariance I/36 are exact, even in 8 bits, where values beyond three standard deviations are
/// clamped. `matched` is empty.
[[nodiscard]] Gaussianized gaussianImage(const MapExemplar& map, gaussian::BorderTreatment borders,
                                         gaussian::Precision precision, ProgressPart progress = {});

} // namespace lichen::gaussian
