// SPDX-License-Identifier: MIT
// The Gaussianized image of an exemplar: [HN18] section 4.2.
#pragma once

#include "exemplar/color_space.h"
#include "gaussian/gaussian_distribution.h"
#include "transport/assignment.h"

#include <lichen/tiling.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace lichen::tiling {

/// A Gaussianized image and how its values go with the exemplar's.
struct Gaussianized {
  int width = 0;
  int height = 0;
  int dimensions = 1;
  /// What the shader fetches: periodic, width * height points, a permutation of
  /// stratifiedGaussian(width * height, dimensions, precision).
  std::vector<Point> image;
  /// The Gaussian point matched to each pixel of the exemplar itself, before any blending of
  /// borders: the pairs from which the inverse table is fitted.
  std::vector<Point> matched;
  /// With a certificate, of each transport: how near the optimum it is.
  std::vector<TransportBound> bounds{};
};

/// Tolerances of transport::improveByAuction(), one for each transport.
struct CertificateSteps {
  double points = 0.0; ///< of the exemplar's points
  double faded = 0.0;  ///< of the image whose borders were cross-faded
};

/// Matches the exemplar's points to the stratified Gaussian set; if `periodic` is false the borders
/// are then cross-faded and the image is matched to the set once more. `certificate` has both
/// transports improved and bounded by auctions; those of one dimension are optimal as they are, and
/// their bound is their cost.
[[nodiscard]] Gaussianized gaussianize(const MapExemplar& map, const std::vector<Point>& points,
                                       int dimensions, bool periodic, gaussian::Precision precision,
                                       const transport::TransportOptions& options,
                                       const std::optional<CertificateSteps>& certificate = {});

/// What gaussianize() makes of points close to those that `near` was made from, one to one: by
/// exchanges that start from its matching.
[[nodiscard]] Gaussianized gaussianizeNear(const Gaussianized& near,
                                           const std::vector<Point>& points, bool periodic,
                                           const transport::TransportOptions& options);

/// The same of points on a line, which come in `order`, least first.
[[nodiscard]] Gaussianized gaussianizeInOrder(const Gaussianized& near,
                                              const std::vector<std::uint32_t>& order,
                                              bool periodic);

} // namespace lichen::tiling
