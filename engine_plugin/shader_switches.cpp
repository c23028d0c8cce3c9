// SPDX-License-Identifier: MIT
// Materials -> the switches of the shader library that fit all of them.
#include "abi.h"
#include "noise_summary.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cstdio>

using namespace lichen;
using namespace lichen::plugin;

namespace {

std::uint32_t featureIf(bool isNeeded, std::uint32_t feature) { return isNeeded ? feature : 0; }

/// What a noise that is not layered, a layer or an index map needs.
std::uint32_t featuresOf(const LichenMaterialParameters& parameters,
                         const shader::LichenNoise& noise) {
  switch (noise.method) {
  case LICHEN_METHOD_TILING:
    return featureIf(parameters.tileRotation > 1, LICHEN_FEATURE_TILE_ROTATION) |
           featureIf(parameters.blendSharpness != 1.0, LICHEN_FEATURE_BLEND_SHARPNESS) |
           featureIf(partOf<shader::LichenTilingNoise>(noise).grain != LICHEN_GRAIN_NONE,
                     LICHEN_FEATURE_GRAIN);
  case LICHEN_METHOD_TEXTON: {
    const auto texton = partOf<shader::LichenTextonNoise>(noise);
    return featureIf(texton.order == 3, LICHEN_FEATURE_CUBIC_TEXTONS) |
           featureIf(texton.order == 0, LICHEN_FEATURE_NEAREST_TEXTONS) |
           featureIf(texton.steps > 1, LICHEN_FEATURE_MIXES) |
           featureIf(parameters.pointProcess == LICHEN_POINT_PROCESS_POISSON,
                     LICHEN_FEATURE_POISSON_POINTS);
  }
  case LICHEN_METHOD_LOCAL_RANDOM_PHASE:
    return featureIf(partOf<shader::LichenCosinesNoise>(noise).structure != 0,
                     LICHEN_FEATURE_STRUCTURES);
  case LICHEN_METHOD_MULTIPLE_KERNELS: {
    const auto kernels = partOf<shader::LichenKernelsNoise>(noise);
    return featureIf(kernels.rings > 0, LICHEN_FEATURE_RING_KERNELS) |
           featureIf(kernels.window != LICHEN_WINDOW_GABOR, LICHEN_FEATURE_SQUARE_KERNELS) |
           featureIf(kernels.cosines > 0, LICHEN_FEATURE_PATTERNS);
  }
  default:
    return 0;
  }
}

void addMaterial(const LichenMaterialParameters& parameters, const NoiseSummary& noise,
                 LichenShaderSwitches& switches) {
  const auto add = [&](const shader::LichenNoise& each) {
    switches.methods |= 1u << each.method;
    switches.features |= featuresOf(parameters, each);
  };
  switches.roles |= noise.constants.roles;
  switches.mappings |= 1u << parameters.mapping;
  switches.layers = std::max(switches.layers, noise.layerCount);
  switches.features |=
      featureIf((noise.mapKinds & (1u << LICHEN_TABLE_JOINT)) != 0, LICHEN_FEATURE_TABLES) |
      featureIf((noise.mapKinds & (1u << LICHEN_TABLE_NONE)) != 0, LICHEN_FEATURE_GAUSSIAN_ONLY) |
      featureIf((noise.mapKinds & kValuesAboveOne) != 0, LICHEN_FEATURE_VALUES_ABOVE_ONE);
  add(noise.constants);
  for (std::uint32_t layer = 1; layer < noise.layerCount; ++layer) {
    add(noise.layers[layer - 1]);
    add(noise.indices[layer - 1]);
  }
}

} // namespace

LichenResult lichenGetShaderSwitches(const LichenMaterialParameters* const* materials,
                                     std::uint32_t materialCount, const LichenPlacement* placement,
                                     LichenShaderSwitches* target, LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    if (materials == nullptr || materialCount == 0) {
      writeDiagnostic(diagnostic, "materials must not be NULL, and materialCount not 0");
      return LICHEN_ERROR_USAGE;
    }
    LichenShaderSwitches switches{};
    switches.layers = 1;
    for (std::uint32_t i = 0; i < materialCount; ++i) {
      LichenMaterialParameters parameters{};
      NoiseSummary noise{};
      LichenResult result =
          readStruct(materials[i], LICHEN_STRUCTURE_MATERIAL_PARAMETERS, parameters, diagnostic);
      if (result == LICHEN_SUCCESS)
        result = readNoiseSummary(parameters, noise, diagnostic);
      if (result != LICHEN_SUCCESS)
        return result;
      addMaterial(parameters, noise, switches);
    }
    if (switches.layers > 1 && (switches.methods & (1u << LICHEN_METHOD_QUILTING)) != 0) {
      writeDiagnostic(diagnostic,
                      "materials: one has layers and another the method quilting, which "
                      "shaders with LICHEN_LAYERS above 1 do not draw; ask for the "
                      "switches of each by itself");
      return LICHEN_ERROR_USAGE;
    }
    LichenPlacement where{};
    if (placement != nullptr)
      if (const LichenResult result =
              readStruct(placement, LICHEN_STRUCTURE_PLACEMENT, where, diagnostic);
          result != LICHEN_SUCCESS)
        return result;
    constexpr std::uint32_t kFirstMapping = 5; // bit of LICHEN_FEATURES
    switches.features |= switches.methods | switches.mappings << kFirstMapping |
                         featureIf(where.periodTiles[0] != 0.0 || where.periodTiles[1] != 0.0,
                                   LICHEN_FEATURE_PERIOD);
    switches.anisotropic = where.maxAnisotropy > 1.0f ? 1 : 0;
    // std::to_string() would export a symbol of the standard library.
    std::snprintf(switches.text, sizeof switches.text,
                  "-DLICHEN_METHODS=%u -DLICHEN_MAPPINGS=%u -DLICHEN_LAYERS=%u -DLICHEN_ROLES=%u "
                  "-DLICHEN_FEATURES=0x%Xu -DLICHEN_ANISOTROPIC=%u",
                  switches.methods, switches.mappings, switches.layers, switches.roles,
                  switches.features, switches.anisotropic);
    if (const LichenResult result = writeStruct(switches, LICHEN_STRUCTURE_SHADER_SWITCHES, target);
        result != LICHEN_SUCCESS) {
      writeDiagnostic(diagnostic,
                      "switches is NULL or has an invalid type or size; use LICHEN_INIT");
      return result;
    }
    return LICHEN_SUCCESS;
  });
}
