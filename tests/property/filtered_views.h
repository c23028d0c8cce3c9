// SPDX-License-Identifier: MIT
// Compares filtered pixels of a noise on a plane with the same pixels supersampled, from one
// distance and over the frames of a camera move. light of a pixel (three channels), footprints
// (tiles) -> means, variances, differences.
#pragma once

#include <lichen/bundle.h>
#include <lichen/noise_evaluator.h>
#include <lichen/shader_parameters.h>

#include <array>
#include <functional>

namespace lichen::test {

using Light = std::array<double, 3>;

/// Returns the light of a pixel of the plane. Position and derivatives are in tiles; with zero
/// derivatives the footprint is a point. Called from many threads.
using Plane = std::function<Light(const TileFootprint&)>;

/// The first map of a bundle's first noise, on texture coordinates or, with Mapping::triplanar, on
/// a plane that is oblique to all three axes. `nearestTableLevel` applies to tiling.
[[nodiscard]] Plane noisePlane(const Bundle& bundle, Mapping mapping,
                               const Placement& placement = {}, bool nearestTableLevel = false,
                               double contrast = 1.0);

/// Compares filtered pixels with averages of point samples in them. The variances, their covariance
/// and the squared difference are sums over the channels. The variance that sampling adds to the
/// averages is removed.
struct FilteredView {
  double meanError = 0.0; ///< of the channel with the largest error
  double filteredVariance = 0.0;
  double sampledVariance = 0.0;
  double squaredDifference = 0.0;
  double scatter = 0.0; ///< standard error of the sampled mean, of the channel with the largest

  /// Relative to the standard deviation that an exact filter would leave.
  [[nodiscard]] double contrast() const;
  /// Root mean square difference, relative to the standard deviation that an exact filter would
  /// leave.
  [[nodiscard]] double difference() const;
  /// The standard error of the mean error of an exact filter. It comes from the samples and from
  /// `pixels` pixels that each differ by `difference` deviations.
  [[nodiscard]] double standardError(double difference, int pixels) const;
  /// The largest mean error that passes: 0.004 (TARGETS.md) and three standard errors. The filter's
  /// own error does not enlarge it.
  [[nodiscard]] double meanTolerance(double difference, int pixels) const;
};

/// Measures `pixels` pixels with these sides [tiles] at random positions, each with 2 `samples` x
/// `samples` point samples.
[[nodiscard]] FilteredView filteredView(const Plane& plane, double width, double height, int pixels,
                                        int samples);

/// What points of a floor show over 60 frames while a camera moves over it: sums over the points,
/// channels and frames.
struct CameraMove {
  double filteredVariance = 0.0; ///< over the frames, at one point
  double sampledVariance = 0.0;
  double filteredStep = 0.0; ///< squared, between consecutive frames
  double sampledStep = 0.0;
  double pointStep = 0.0; ///< with one unfiltered point sample per pixel
};

/// A floor with one tile per unit, seen at a grazing angle in a picture of 96 x 64 pixels. Pixels
/// cover from 1/53 by 1/43 of a tile to 0.6 by 19 tiles. Each point takes 2 `samples` x `samples`
/// point samples per frame.
[[nodiscard]] CameraMove cameraMove(const Plane& floor, int samples);

} // namespace lichen::test
