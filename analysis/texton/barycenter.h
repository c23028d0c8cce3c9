// SPDX-License-Identifier: MIT
// The Gaussian texture between others: their barycentre for the transport distance.
#pragma once

#include "fit.h"

#include <span>

namespace lichen::texton {

struct Barycenter {
  gaussian::GaussianModel model;
  /// The root of the transport distance between the model and the barycentre proper, over the
  /// variance of the latter: what one kernel a channel cannot express. Of up to three textures, and
  /// of one channel, nothing but rounding and the few frequencies that are their own mirror.
  double rankError = 0.0;
};

/// The model of least sum_k weights[k] (transport distance to models[k])^2 [GLM17 section 7].
/// `models` at least one, of one size and number of channels; a weight each, none negative, of
/// sum 1. Those of weight 0 do not count; the barycentre of one model is itself.
/// Between n textures a frequency's power may need several kernels, up to sqrt(n); from four on
/// this is the best that one kernel can be (docs/decisions/016-mixing.md). Same bytes for any
/// number of threads. For n of three and more, up to 200 (n + 2) products of small matrices a
/// frequency. Throws std::bad_alloc.
[[nodiscard]] Barycenter barycenter(std::span<const gaussian::GaussianModel> models,
                                    std::span<const double> weights);

/// The same textures with other phases, so that each one goes with the next: the cross-spectrum of
/// neighbours, summed over the channels, is nowhere negative. Then (1 - rho) [k] + rho [k + 1] is
/// the barycentre of models k and k + 1. The last model is as it was. [GLM17] section 7.
[[nodiscard]] std::vector<gaussian::GaussianModel>
alignedModels(std::span<const gaussian::GaussianModel> models);

/// (1 - rho) first + rho second, frequency by frequency; of one size and number of channels.
[[nodiscard]] gaussian::GaussianModel between(const gaussian::GaussianModel& first,
                                              const gaussian::GaussianModel& second, double rho);

} // namespace lichen::texton
