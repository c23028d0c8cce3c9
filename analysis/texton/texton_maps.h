// SPDX-License-Identifier: MIT
// Textons of all maps of a noise -> its maps and their tables.
#pragma once

#include "fit.h"

#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

/// What one step of a noise is made of; of one that is no mix, all.
struct TextonOfMaps {
  TextonCoefficients coefficients; ///< the channels of all maps
  Eigen::VectorXd mean;            ///< of their stored values
};

/// Coefficients in units of each channel -> of stored values.
[[nodiscard]] TextonCoefficients inStoredUnits(TextonCoefficients coefficients,
                                               const Eigen::VectorXd& units);

/// Gives `noise`, whose shape and name are set, a map for each of `maps`, of which pixels are not
/// read, and appends their tables. A step each of the shape's. `bits` 8 or 16, as
/// TextonOptions::bits. Throws std::bad_alloc.
void storeMaps(std::span<const TextonOfMaps> steps, std::span<const MapExemplar> maps, int bits,
               Noise& noise, std::vector<Table>& tables);

} // namespace lichen::texton
