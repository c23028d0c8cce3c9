// SPDX-License-Identifier: MIT
// Fits textons to Gaussian textures between exemplars: along a path through them, or for one set of
// weights.
#pragma once

#include "fit.h"

#include <lichen/result.h>

#include <Eigen/Dense>

#include <span>
#include <string>
#include <vector>

namespace lichen::texton {

/// One exemplar of a mix. All exemplars have the same channels, encoding and units: of several
/// maps, each is scaled alike in all exemplars.
struct MixExemplar {
  std::string name; ///< the file's name, for messages
  GaussianModel model;
  /// The covariance that the noise must have at this exemplar: its pixels' covariance, or
  /// modelCovariance(). Its range lies inside the range of the model's covariance.
  Eigen::MatrixXd covariance;
};

struct MixStep {
  std::vector<double> weights; ///< one per exemplar, with sum 1; they also weight the mean colour
  /// Its noise has the covariance of the exemplars' barycentre; at an exemplar, that exemplar's.
  TextonCoefficients texton;
  ModelErrors errors{};   ///< of the texton with its model's covariance, as in TextonQuality
  double rankError = 0.0; ///< from Barycenter; 0 along a path
};

/// The textons of one tile.
struct TextonMix {
  std::vector<MixStep> steps;
};

/// Fits textons from each exemplar to the next: (exemplars - 1) stepsPerLeg + 1 of them, evenly
/// spaced, for at least two exemplars. The exemplars' textons are fitted together. The others lie
/// on straight lines between them, apart from their covariance. So neighbours are as close as
/// possible, and the same impacts morph one texture into the other.
/// Textons are no larger than the tile. Errors: badInput for an exemplar whose model has no
/// variance along a colour axis of its covariance; environment when `options.progress` stops it.
/// Throws std::bad_alloc. The bytes do not depend on the number of threads. Time: one fit per
/// exemplar, and modelErrors() for each step. Source: [GLM17] section 7.
[[nodiscard]] Result<TextonMix> fitTextonPath(std::span<const MixExemplar> exemplars,
                                              int stepsPerLeg, const FitOptions& options);

/// Fits one texton to the barycentre with these weights: one per exemplar, none negative, with any
/// positive sum. Takes at least one exemplar. Errors and time as for fitTextonPath(), and usage for
/// other weights.
[[nodiscard]] Result<TextonMix> fitTextonBarycenter(std::span<const MixExemplar> exemplars,
                                                    std::span<const double> weights,
                                                    const FitOptions& options);

} // namespace lichen::texton
