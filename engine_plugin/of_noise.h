// SPDX-License-Identifier: MIT
// What a material's parameters hold of its noise, so that the bundle need not live.
#pragma once

#include <lichen/lichen.h>

#include <cstdint>
#include <lichen_interface.h>

namespace lichen::plugin {

struct OfNoise {
  shader::LichenNoise constants;
  std::uint32_t tableKinds; // bit k: a map with the LichenTableKind k
  std::uint32_t checksum;   // of all before
};
static_assert(sizeof(OfNoise) == sizeof(LichenMaterialParameters::ofNoise));

[[nodiscard]] std::uint32_t checksumOf(const OfNoise& part);

/// Reads them from parameters. LICHEN_ERROR_USAGE where the host has not left them as they were.
LichenResult readOfNoise(const LichenMaterialParameters& source, OfNoise& part,
                         LichenDiagnostic* diagnostic);

} // namespace lichen::plugin
