// SPDX-License-Identifier: MIT
// What lichenFillMaterial and lichenGetShaderSwitches need of a noise, copied into a material's
// parameters so that the bundle may be destroyed.
#pragma once

#include <lichen/lichen.h>

#include <cstdint>
#include <lichen_interface.h>

namespace lichen::plugin {

struct NoiseSummary {
  shader::LichenNoise constants;
  // For a layered noise: `constants` is its first layer.
  shader::LichenNoise layers[LICHEN_MAX_LAYERS - 1], indices[LICHEN_MAX_LAYER_NODES];
  std::uint32_t layerCount; // 1 of a noise that is not layered
  std::uint32_t features;   // LICHEN_FEATURE_...: what decodes the maps of all layers
  std::uint32_t reserved;   // 0: to a multiple of 8 bytes
  std::uint32_t checksum;   // of the members above
};
static_assert(sizeof(NoiseSummary) == sizeof(LichenMaterialParameters::noiseSummary));

[[nodiscard]] std::uint32_t checksumOf(const NoiseSummary& summary);

/// Reads it from parameters. LICHEN_ERROR_USAGE if the checksum shows that the host has changed it.
LichenResult readNoiseSummary(const LichenMaterialParameters& source, NoiseSummary& summary,
                              LichenDiagnostic* diagnostic);

} // namespace lichen::plugin
