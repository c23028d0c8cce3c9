// SPDX-License-Identifier: MIT
// Texton coefficients -> the table that a shader fetches from, and the lost variance of each level.
#pragma once

#include "fit.h"

#include <lichen/bundle.h>

#include <span>
#include <vector>

namespace lichen::texton {

/// Returns the table of 1 to 3 channels, with one texton per step: frames one above the other, and
/// mips of box averages. Each channel is divided by its `scale`; a channel of scale 0 is stored as
/// 0. `bits` is the size of its floats, 16 or 32.
[[nodiscard]] Table textonTable(std::span<const TextonCoefficients* const> steps,
                                const TextonShape& shape, std::size_t firstChannel,
                                std::span<const double> scale, int bits);

/// Returns the coefficients of a step for the channels of all maps, as stored in the tables of
/// `noise`.
[[nodiscard]] TextonCoefficients storedTexton(const Noise& noise, std::span<const Table> tables,
                                              int step = 0);

/// Returns TextonMap::mipLoss for each step of such a table, kMaxTextonLosses values per channel.
/// For a channel that does not vary, the values are 0.
[[nodiscard]] std::vector<std::vector<double>>
mipLosses(const Table& table, const TextonShape& shape, std::size_t channels);

} // namespace lichen::texton
