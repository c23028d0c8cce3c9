// SPDX-License-Identifier: MIT
// Gaussianizes the maps of an exemplar: what every method begins with that decodes by an inverse
// table. [HN18] section 4.
#pragma once

#include "gaussianize.h"

#include <lichen/bundle.h>
#include <lichen/gaussianization.h>
#include <lichen/result.h>

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace lichen::gaussian {

/// One map as Gaussian values, and the way back.
struct GaussianizedMap {
  NoiseMap map; ///< without the method's data
  /// Its `image` is the Gaussian image at full precision. A map that does not vary has the mean
  /// everywhere.
  Gaussianized image;
  Table gaussian;               ///< the image with its mips, and the loss of each
  std::optional<Table> inverse; ///< absent if the stored values are Gaussian
};

using MapConsumer = std::function<void(GaussianizedMap)>;

/// Whether a bake fades streaks over another band than the rest:
/// docs/decisions/006-light-and-grain.md.
enum class UsesGrain { no, yes };

/// Passes each map to `consume`, in the order given; maps of one set correlate. Returns how it
/// treated the exemplar's borders. With UsesGrain::yes the streaks of all maps fade along the grain
/// of the first. `name` is the noise's name, with which the tables' names begin. Errors and
/// requirements: as bakeTiling(), but throws std::bad_alloc.
[[nodiscard]] Result<gaussian::BorderTreatment>
gaussianizeMaps(const std::string& name, std::span<const MapExemplar> maps,
                const GaussianizationOptions& options, UsesGrain usesGrain,
                const MapConsumer& consume);

/// Appends a table and returns its index.
[[nodiscard]] std::size_t appended(Table table, std::vector<Table>& tables);

/// The message when memory runs out.
[[nodiscard]] std::string noMemoryToBake(const std::string& name,
                                         std::span<const MapExemplar> maps);

} // namespace lichen::gaussian
