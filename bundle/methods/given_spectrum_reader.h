// SPDX-License-Identifier: MIT
// Reads whose spectrum a noise has.
#pragma once

#include "extension_reader.h"

#include <optional>

namespace lichen {

/// The member "spectrum": whether it is "given" rather than "exemplar", which it is if it is
/// absent. Nothing if it is faulty.
[[nodiscard]] std::optional<bool> readGivenSpectrum(ObjectReader& reader);

} // namespace lichen
