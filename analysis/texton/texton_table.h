// SPDX-License-Identifier: MIT
// Texton coefficients -> the table that a shader fetches from, and the lost variance of each level.
#pragma once

#include "fit.h"

#include <lichen/bundle.h>
#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

/// Returns the table of 1 to 3 channels, with one texton per step: frames one above the other, and
/// mips of box averages. Each channel is divided by its `scale`; a channel of scale 0 is stored as
/// 0. `bits` is the size of its floats, 16 or 32.
[[nodiscard]] Table textonTable(std::span<const TextonCoefficients* const> steps,
                                const TextonShape& shape, std::size_t firstChannel,
                                std::span<const double> scale, int bits);

/// Returns the coefficients of a step for the channels of some maps of `noise`, as stored in its
/// tables.
[[nodiscard]] TextonCoefficients storedTexton(const Noise& noise, std::span<const NoiseMap> maps,
                                              std::span<const Table> tables, int step = 0);

/// Returns TextonMap::mipLoss for each step of such a table, kMaxTextonLosses values per channel.
/// For a channel that does not vary, the values are 0.
[[nodiscard]] std::vector<std::vector<double>>
mipLosses(const Table& table, const TextonShape& shape, std::size_t channels);

/// One step of a mix. A noise without a mix has only one.
struct TextonOfMaps {
  TextonCoefficients coefficients; ///< of all maps' channels
  Eigen::VectorXd mean;            ///< of the stored values
};

/// Converts coefficients from the units of each channel to stored values.
[[nodiscard]] TextonCoefficients inStoredUnits(TextonCoefficients coefficients,
                                               const Eigen::VectorXd& units);

/// Adds to `noise`, whose shape and name are set, a map for each entry of `maps`, and appends their
/// tables. It does not read the pixels of `maps`. There is one entry of `steps` per step of the
/// shape. `bits` is 8 or 16, as in TextonOptions::bits. Throws std::bad_alloc.
void storeMaps(std::span<const TextonOfMaps> steps, std::span<const MapExemplar> maps, int bits,
               Noise& noise, std::vector<Table>& tables);

} // namespace lichen::texton
