// SPDX-License-Identifier: MIT
// Barycentres of Gaussian textures for the optimal transport distance.
#pragma once

#include "fit.h"

#include <span>
#include <vector>

namespace lichen::texton {

struct Barycenter {
  GaussianModel model;
  /// Transport distance between the model and the exact barycentre, over the standard deviation of
  /// that barycentre: what one kernel per channel cannot express. With up to three textures or with
  /// one channel, only rounding and the few frequencies that are their own mirror contribute.
  double rankError = 0.0;
};

/// Returns the model that minimizes sum_k weights[k] (transport distance to models[k])^2 [GLM17
/// section 7]. `models` has at least one entry; all have one size and number of channels. There is
/// one weight per model, none negative, with sum 1. Models of weight 0 have no effect. The
/// barycentre of one model is that model.
/// At one frequency, the barycentre of n textures may need up to sqrt(n) kernels. From four
/// textures on, the result is the best that one kernel can do (docs/decisions/008-textons.md). The
/// bytes do not depend on the number of threads. With three or more textures the cost is up to 200
/// (n + 2) products of small matrices per frequency. Throws std::bad_alloc.
[[nodiscard]] Barycenter barycenter(std::span<const GaussianModel> models,
                                    std::span<const double> weights);

/// Returns the same textures with their phases aligned: the cross-spectrum of neighbours, summed
/// over the channels, is nowhere negative. Then (1 - rho) [k] + rho [k + 1] is the barycentre of
/// models k and k + 1. The last model does not change. [GLM17] section 7.
[[nodiscard]] std::vector<GaussianModel> alignedModels(std::span<const GaussianModel> models);

/// Returns (1 - rho) first + rho second at each frequency. Both have one size and number of
/// channels.
[[nodiscard]] GaussianModel between(const GaussianModel& first, const GaussianModel& second,
                                    double rho);

/// Returns the same textures sampled at the texels of one tile. The tile is as wide as the widest
/// model, and as high as the highest model at that width. Every exemplar spans the tile's width, as
/// in a bundle: its number of pixels says how fine it is, not how large.
/// Covariances do not change. Where the aspect ratios agree, neither do powers and cross-spectra;
/// for a taller tile these are interpolated. A model that already has the size does not change.
/// Takes at least one model; all have one number of channels.
[[nodiscard]] std::vector<GaussianModel> onOneGrid(std::span<const GaussianModel> models);

} // namespace lichen::texton
