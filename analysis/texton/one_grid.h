// SPDX-License-Identifier: MIT
// Brings Gaussian models of exemplars of different sizes to one grid of frequencies.
#pragma once

#include "fit.h"

#include <span>
#include <vector>

namespace lichen::texton {

/// Returns the same textures sampled at the texels of one tile. The tile is as wide as the widest
/// model, and as high as the highest model at that width. Every exemplar spans the tile's width, as
/// in a bundle: its number of pixels says how fine it is, not how large.
/// Covariances do not change. Where the aspect ratios agree, neither do powers and cross-spectra;
/// for a taller tile these are interpolated. A model that already has the size does not change.
/// Takes at least one model; all have one number of channels.
[[nodiscard]] std::vector<gaussian::GaussianModel>
onOneGrid(std::span<const gaussian::GaussianModel> models);

} // namespace lichen::texton
