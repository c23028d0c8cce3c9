// SPDX-License-Identifier: MIT
// Materials -> the switches of the shader library that fit all of them.
#include "abi.h"
#include "noise_summary.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cstdio>
#include <string>

using namespace lichen;
using namespace lichen::plugin;

namespace {

/// What some material needs.
struct Needs {
  std::uint32_t roles = 0, methods = 0;       // bits
  std::uint32_t layers = 1, layerMethods = 0; // the latter without index maps
  bool tables = false, gaussianOnly = false;  // of tiling
  bool valuesAboveOne = false;
  bool triplanar = false, otherMappings = false, surface = false, solid = false;
  bool mixes = false, poisson = false, cubic = false, nearest = false; // of textons
  bool structure = false;                                              // of local random phase
  bool rings = false, squares = false, patterns = false;               // of multiple kernels
  bool rotation = false, sharpness = false, grain = false;             // of tiling
  bool period = false, anisotropy = false;
};

void addTables(const NoiseSummary& noise, Needs& needs) {
  needs.tables = needs.tables || (noise.mapKinds & (1u << LICHEN_TABLE_JOINT)) != 0;
  needs.gaussianOnly = needs.gaussianOnly || (noise.mapKinds & (1u << LICHEN_TABLE_NONE)) != 0;
}

void addTiling(const LichenMaterialParameters& parameters, const shader::LichenNoise& noise,
               Needs& needs) {
  needs.rotation = needs.rotation || parameters.tileRotation > 1;
  needs.sharpness = needs.sharpness || parameters.blendSharpness != 1.0;
  needs.grain = needs.grain || tilingPart(noise).grain != LICHEN_GRAIN_NONE;
}

void addTextons(const LichenMaterialParameters& parameters, const shader::LichenNoise& noise,
                Needs& needs) {
  const shader::LichenTextonNoise texton = textonPart(noise);
  constexpr std::uint32_t kCubic = 3;
  needs.mixes = needs.mixes || texton.steps > 1;
  needs.poisson = needs.poisson || parameters.pointProcess == LICHEN_POINT_PROCESS_POISSON;
  needs.cubic = needs.cubic || texton.order == kCubic;
  needs.nearest = needs.nearest || texton.order == 0;
}

void addKernels(const shader::LichenNoise& noise, Needs& needs) {
  const shader::LichenKernelsNoise kernels = kernelsPart(noise);
  needs.rings = needs.rings || kernels.rings > 0;
  needs.squares = needs.squares || kernels.window != LICHEN_WINDOW_GABOR;
  needs.patterns = needs.patterns || kernels.cosines > 0;
}

/// What the method of a layer or of an index map needs.
void addNoise(const LichenMaterialParameters& parameters, const shader::LichenNoise& noise,
              Needs& needs) {
  needs.methods |= 1u << noise.method;
  if (noise.method == LICHEN_METHOD_TEXTON)
    addTextons(parameters, noise, needs);
  if (noise.method == LICHEN_METHOD_TILING)
    addTiling(parameters, noise, needs);
  if (noise.method == LICHEN_METHOD_LOCAL_RANDOM_PHASE)
    needs.structure = needs.structure || cosinesPart(noise).structure != 0;
  if (noise.method == LICHEN_METHOD_MULTIPLE_KERNELS)
    addKernels(noise, needs);
}

void addMaterial(const LichenMaterialParameters& parameters, const NoiseSummary& noise,
                 Needs& needs) {
  needs.roles |= noise.constants.roles;
  needs.layers = std::max(needs.layers, noise.layerCount);
  needs.valuesAboveOne = needs.valuesAboveOne || (noise.mapKinds & kValuesAboveOne) != 0;
  (parameters.mapping == LICHEN_MAPPING_TRIPLANAR ? needs.triplanar : needs.otherMappings) = true;
  needs.surface = needs.surface || parameters.mapping == LICHEN_MAPPING_SURFACE;
  needs.solid = needs.solid || parameters.mapping == LICHEN_MAPPING_SOLID;
  addTables(noise, needs);
  addNoise(parameters, noise.constants, needs);
  needs.layerMethods |= 1u << noise.constants.method;
  for (std::uint32_t layer = 1; layer < noise.layerCount; ++layer) {
    addNoise(parameters, noise.layers[layer - 1], needs);
    needs.layerMethods |= 1u << noise.layers[layer - 1].method;
    addNoise(parameters, noise.indices[layer - 1], needs);
  }
}

std::string switchesOf(const Needs& needs) {
  char bits[64]; // std::to_string() would export a symbol of the standard library
  std::snprintf(bits, sizeof bits, "-DLICHEN_ROLES=%u -DLICHEN_METHODS=%u", needs.roles,
                needs.methods);
  std::string text = bits;
  if (needs.layers > 1) {
    std::snprintf(bits, sizeof bits, " -DLICHEN_LAYERS=%u -DLICHEN_LAYER_METHODS=%u", needs.layers,
                  needs.layerMethods);
    text += bits;
  }
  const auto unless = [&](bool isNeeded, const char* name) {
    if (!isNeeded)
      text += std::string(" -DLICHEN_") + name;
  };
  unless(needs.valuesAboveOne, "VALUES_ABOVE_ONE=0");
  unless(needs.triplanar, "OMIT_TRIPLANAR");
  unless(needs.otherMappings, "OTHER_MAPPINGS=0");
  const auto has = [&](std::uint32_t method) { return (needs.methods & (1u << method)) != 0; };
  if (has(LICHEN_METHOD_TEXTON) || has(LICHEN_METHOD_MULTIPLE_KERNELS))
    unless(needs.surface, "OMIT_SURFACE");
  if (has(LICHEN_METHOD_TEXTON)) {
    unless(needs.mixes, "MIXED_TEXTONS=0");
    unless(needs.poisson, "POISSON_POINTS=0");
    unless(needs.cubic, "CUBIC_TEXTONS=0");
    unless(needs.nearest, "NEAREST_TEXTONS=0");
  }
  if ((needs.methods & ~(1u << LICHEN_METHOD_TEXTON)) != 0) {
    unless(needs.tables, "TABLES=0");
    unless(needs.gaussianOnly || !needs.tables, "GAUSSIAN_ONLY=0"); // not both are 0
  }
  if (has(LICHEN_METHOD_TILING)) {
    unless(needs.rotation, "TILE_ROTATION=0");
    unless(needs.sharpness, "BLEND_SHARPNESS=0");
    unless(needs.grain, "GRAIN=0");
  }
  if (has(LICHEN_METHOD_LOCAL_RANDOM_PHASE))
    unless(needs.structure, "STRUCTURE=0");
  if (has(LICHEN_METHOD_MULTIPLE_KERNELS)) {
    unless(needs.rings, "RING_KERNELS=0");
    unless(needs.squares, "SQUARE_KERNELS=0");
    unless(needs.patterns, "KERNEL_PATTERN=0");
  }
  if (has(LICHEN_METHOD_LOCAL_RANDOM_PHASE) || has(LICHEN_METHOD_MULTIPLE_KERNELS))
    unless(needs.solid, "OMIT_SOLID");
  unless(needs.period, "PERIODIC_LATTICE=0");
  unless(!needs.anisotropy, "ANISOTROPIC=1");
  return text;
}

} // namespace

LichenResult lichenGetShaderSwitches(const LichenMaterialParameters* const* materials,
                                     std::uint32_t materialCount, const LichenPlacement* placement,
                                     char* text, std::size_t textBytes,
                                     LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    if (materials == nullptr || materialCount == 0 || text == nullptr) {
      writeDiagnostic(diagnostic, "materials and text must not be NULL, and materialCount not 0");
      return LICHEN_ERROR_USAGE;
    }
    Needs needs;
    for (std::uint32_t i = 0; i < materialCount; ++i) {
      LichenMaterialParameters parameters{};
      NoiseSummary noise{};
      LichenResult result =
          readStruct(materials[i], LICHEN_STRUCTURE_MATERIAL_PARAMETERS, parameters, diagnostic);
      if (result == LICHEN_SUCCESS)
        result = readNoiseSummary(parameters, noise, diagnostic);
      if (result != LICHEN_SUCCESS)
        return result;
      addMaterial(parameters, noise, needs);
    }
    if (needs.layers > 1 && (needs.methods & (1u << LICHEN_METHOD_QUILTING)) != 0) {
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
    needs.period = where.periodTiles[0] != 0.0 || where.periodTiles[1] != 0.0;
    needs.anisotropy = where.maxAnisotropy > 1.0f;
    const std::string switches = switchesOf(needs);
    if (switches.size() >= textBytes) {
      writeDiagnostic(diagnostic, "textBytes %zu is too small; expected at least %d", textBytes,
                      LICHEN_SWITCH_BYTES);
      return LICHEN_ERROR_USAGE;
    }
    std::memcpy(text, switches.c_str(), switches.size() + 1);
    return LICHEN_SUCCESS;
  });
}
