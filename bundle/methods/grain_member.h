// SPDX-License-Identifier: MIT
// Reads and writes the member `grain` of tiling and quilting noises.
#pragma once

#include "object_reader.h"

#include <lichen/lattice.h>

#include <nlohmann/json.hpp>

namespace lichen {

/// Grain::none if the member is absent or not `x` or `y`, which is an error.
[[nodiscard]] Grain readGrain(ObjectReader& reader);
/// Writes nothing for Grain::none.
void writeGrain(Grain grain, nlohmann::ordered_json& json);

} // namespace lichen
