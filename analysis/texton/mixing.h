// SPDX-License-Identifier: MIT
// Textons of Gaussian textures between exemplars: along a path through them, or one with weights.
#pragma once

#include "fit.h"

#include <lichen/progress.h>
#include <lichen/result.h>

#include <Eigen/Dense>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lichen::texton {

/// What is mixed. All exemplars of a mix have the same channels in the same encoding and in units
/// that compare: of a set of maps, scaled alike.
struct MixExemplar {
  std::string name; ///< for messages: the file's
  gaussian::GaussianModel model;
  /// That the noise is to have there: of the exemplar's pixels, or modelCovariance. Its range lies
  /// inside that of the model's.
  Eigen::MatrixXd covariance;
};

struct MixOptions {
  int width = 0;  ///< coefficients, at least 1; no more than the tile has texels are made
  int height = 0; ///< likewise
  int order = 1;  ///< of the interpolating B-spline, [0, 8]
  std::uint32_t seed = 1;
  /// Steps from an exemplar to the next, at least 1; 20 for the 21 textons of [GLM17].
  int stepsPerLeg = 20;
  Progress progress; ///< empty: nobody watches
};

struct MixStep {
  std::vector<double> weights; ///< one an exemplar, of sum 1: those of the mean colour too
  /// Of the covariance of the exemplars' barycentre; of an exemplar alone, its own.
  TextonCoefficients texton;
  /// relativeModelError of the texton with the covariance of its model, as TextonQuality has it.
  double modelError = 0.0;
  double rankError = 0.0; ///< of Barycenter; 0 along a path
};

/// Textons of one tile.
struct TextonMix {
  int width = 0;  ///< texels of the tile, as onOneGrid makes it
  int height = 0; ///< texels of the tile
  std::vector<MixStep> steps;
};

/// Textons from each exemplar to the next, (exemplars - 1) stepsPerLeg + 1 of them, evenly spaced.
/// But for their covariance they lie on straight lines between the textons of the exemplars, which
/// are fitted together: neighbours are as near to each other as they can be, and the same impacts
/// make one texture turn into the other. At least two exemplars.
/// Errors: usage for numbers outside their ranges and for exemplars of different channels; badInput
/// for an exemplar whose model lacks a colour axis of its covariance; resources for memory,
/// environment when `options.progress` stops it. Same bytes for any number of threads. Time: one
/// fit for each exemplar, and relativeModelError for each step. Source: [GLM17] section 7.
[[nodiscard]] Result<TextonMix> fitTextonPath(std::span<const MixExemplar> exemplars,
                                              const MixOptions& options);

/// One texton, of the barycentre with these weights: one an exemplar, none negative, of any
/// positive sum. At least one exemplar. Errors and time as above.
[[nodiscard]] Result<TextonMix> fitTextonBarycenter(std::span<const MixExemplar> exemplars,
                                                    std::span<const double> weights,
                                                    const MixOptions& options);

} // namespace lichen::texton
