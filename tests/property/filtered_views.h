// SPDX-License-Identifier: MIT
// A noise on a plane as pixels see it, filtered, against the same pixels supersampled: from one
// distance, and over the frames of a camera's move.
// light of a pixel (three channels), footprints (tiles) -> means, variances, differences.
#pragma once

#include <lichen/bundle.h>
#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>
#include <lichen/tiling_quality.h>

#include <array>
#include <functional>

namespace lichen::test {

using Light = std::array<double, 3>;

/// The light of a pixel of the plane, whose position and derivatives are in tiles; with derivatives
/// of 0, of a point. Called from many threads.
using Plane = std::function<Light(const TileFootprint&)>;

/// The first map of a bundle's first noise, on texture coordinates or, with Mapping::triplanar, on
/// a plane that lies askew to all three. The quality is that of tiling.
[[nodiscard]] Plane noisePlane(const Bundle& bundle, Mapping mapping,
                               const Placement& placement = {}, const TilingQuality& quality = {},
                               double contrast = 1.0);

/// Pixels against the averages of points in them. Variances, their covariance and the squared
/// difference are sums over the channels; of the averages, without what their few points add.
struct FilteredView {
  double meanError = 0.0; ///< of the channel that is off the most
  double filteredVariance = 0.0;
  double sampledVariance = 0.0;
  double squaredDifference = 0.0;

  /// Of the deviation that an exact filter would leave.
  [[nodiscard]] double contrast() const;
  /// Root mean square difference over the deviation that an exact filter would leave.
  [[nodiscard]] double difference() const;
};

/// `pixels` pixels of these sides [tiles] at random places, each with 2 `samples` x `samples`
/// points.
[[nodiscard]] FilteredView filteredView(const Plane& plane, double width, double height, int pixels,
                                        int samples);

/// What places of a floor show over 60 frames of a camera that moves over it: sums over the places,
/// channels and frames.
struct CameraMove {
  double filteredVariance = 0.0; ///< over the frames, at a place
  double sampledVariance = 0.0;
  double filteredStep = 0.0; ///< squared, from a frame to the next
  double sampledStep = 0.0;
  double pointStep = 0.0; ///< of one point a pixel, unfiltered
};

/// A floor of one tile a unit, seen at a grazing angle in a picture of 96 x 64, from a pixel of a
/// 53rd by a 43rd of a tile to one of 0.6 by 19 tiles; each place with 2 `samples` x `samples`
/// points a frame.
[[nodiscard]] CameraMove cameraMove(const Plane& floor, int samples);

} // namespace lichen::test
