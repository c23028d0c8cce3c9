// SPDX-License-Identifier: MIT
// What lichenFillMaterial and lichenGetShaderSwitches need of a noise, copied into a material's
// parameters so that the bundle may be destroyed.
#pragma once

#include <lichen/lichen.h>

#include <cstdint>
#include <lichen_interface.h>

namespace lichen::plugin {

/// A bit of mapKinds: a map has values above 1.
inline constexpr std::uint32_t kValuesAboveOne = 1u << 31;

struct NoiseSummary {
  shader::LichenNoise constants;
  std::uint32_t mapKinds; // bit k: a map with the LichenTableKind k; kValuesAboveOne
  std::uint32_t checksum; // of the members above
};
static_assert(sizeof(NoiseSummary) == sizeof(LichenMaterialParameters::noiseSummary));

[[nodiscard]] std::uint32_t checksumOf(const NoiseSummary& summary);

/// Reads it from parameters. LICHEN_ERROR_USAGE if the checksum shows that the host has changed it.
LichenResult readNoiseSummary(const LichenMaterialParameters& source, NoiseSummary& summary,
                              LichenDiagnostic* diagnostic);

} // namespace lichen::plugin
