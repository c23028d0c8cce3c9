// SPDX-License-Identifier: MIT
// Members that noises of several methods have.
#pragma once

#include "extension_reader.h"

#include <lichen/lattice.h>

#include <array>
#include <optional>

namespace lichen {

/// The member "spectrum": whether it is "given" rather than "exemplar", which it is if it is
/// absent. Nothing if it is faulty.
[[nodiscard]] std::optional<bool> readGivenSpectrum(ObjectReader& reader);

/// The member "grain". Grain::none if it is absent or not "x" or "y", which is an error.
[[nodiscard]] Grain readGrain(ObjectReader& reader);

/// Two whole numbers in [1, most]: x and y. Nothing if the member is faulty.
[[nodiscard]] std::optional<std::array<int, 2>> readSize(ObjectReader& reader, const char* key,
                                                         int most);

} // namespace lichen
