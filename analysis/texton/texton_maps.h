// SPDX-License-Identifier: MIT
// Textons for all maps of a noise -> its maps and their tables.
#pragma once

#include "fit.h"

#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

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
