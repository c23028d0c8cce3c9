// SPDX-License-Identifier: MIT
// Materials -> the switches of the shader library that fit all of them.
#include "abi.h"
#include "noise_summary.h"

#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cstdio>
#include <methods/method_parameters.h>

using namespace lichen;
using namespace lichen::plugin;

namespace {

/// Adds what the material and its noise need. Returns whether layers may be drawn with them.
bool addMaterial(const LichenMaterialParameters& parameters, const NoiseSummary& noise,
                 LichenShaderSwitches& switches) {
  MaterialNoise material;
  material.tileRotation = parameters.tileRotation;
  material.blendSharpness = parameters.blendSharpness;
  material.pointProcess = PointProcess(parameters.pointProcess);
  bool isLayerable = mappingFitsLayers(Mapping(parameters.mapping));
  const auto add = [&](const shader::LichenNoise& each) {
    const MethodParameters& method = parametersOf(each);
    isLayerable = isLayerable && method.isLayerable;
    switches.methods |= 1u << each.method;
    if (method.features != nullptr)
      switches.features |= method.features(each, material);
  };
  switches.roles |= noise.constants.roles;
  switches.mappings |= 1u << parameters.mapping;
  switches.layers = std::max(switches.layers, noise.layerCount);
  switches.features |= noise.features;
  add(noise.constants);
  for (std::uint32_t layer = 1; layer < noise.layerCount; ++layer) {
    add(noise.layers[layer - 1]);
    add(noise.indices[layer - 1]);
  }
  return isLayerable;
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
    bool areLayerable = true;
    for (std::uint32_t i = 0; i < materialCount; ++i) {
      LichenMaterialParameters parameters{};
      NoiseSummary noise{};
      LichenResult result =
          readStruct(materials[i], LICHEN_STRUCTURE_MATERIAL_PARAMETERS, parameters, diagnostic);
      if (result == LICHEN_SUCCESS)
        result = readNoiseSummary(parameters, noise, diagnostic);
      if (result != LICHEN_SUCCESS)
        return result;
      areLayerable = addMaterial(parameters, noise, switches) && areLayerable;
    }
    if (switches.layers > 1 && !areLayerable) {
      writeDiagnostic(diagnostic,
                      "materials: one has layers, and shaders with LICHEN_LAYERS above 1 do not "
                      "draw the method or the mapping of another; ask for the switches of each by "
                      "itself");
      return LICHEN_ERROR_USAGE;
    }
    LichenPlacement where{};
    if (placement != nullptr)
      if (const LichenResult result =
              readStruct(placement, LICHEN_STRUCTURE_PLACEMENT, where, diagnostic);
          result != LICHEN_SUCCESS)
        return result;
    switches.features |= switches.methods | switches.mappings * LICHEN_FEATURE_UV |
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
