// SPDX-License-Identifier: MIT
// Texton coefficients -> what a shader fetches, and what each level of averaging takes from them.
#pragma once

#include "fit.h"

#include <lichen/bundle.h>

#include <span>
#include <vector>

namespace lichen::texton {

/// The table of some channels, 1 to 3, of one texton for each step: frames one above the other,
/// with mips of box averages. Each channel is divided by its `scale`; one of scale 0 is 0. `bits`
/// 16 or 32, of floats.
[[nodiscard]] Table textonTable(std::span<const TextonCoefficients* const> steps,
                                const TextonShape& shape, std::size_t firstChannel,
                                std::span<const double> scale, int bits);

/// The coefficients of a step, the channels of all maps, as the tables of `noise` hold them.
[[nodiscard]] TextonCoefficients storedTexton(const Noise& noise, std::span<const Table> tables,
                                              int step = 0);

/// NoiseMap::mipLoss of each step of such a table, kMaxTextonLosses values a channel; of one that
/// does not vary 0.
[[nodiscard]] std::vector<std::vector<double>>
mipLosses(const Table& table, const TextonShape& shape, std::size_t channels);

} // namespace lichen::texton
