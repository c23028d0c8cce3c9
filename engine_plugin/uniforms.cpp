// SPDX-License-Identifier: MIT
// Material parameters and the host's overrides -> LichenUniforms, the uniform block.
#include "abi.h"
#include "plan.h"

#include <lichen/shader_parameters.h>

#include <cmath>

using namespace lichen;
using namespace lichen::plugin;

namespace {

constexpr std::uint32_t kKnownOverrides =
    LICHEN_OVERRIDE_SCALE | LICHEN_OVERRIDE_OFFSET | LICHEN_OVERRIDE_ROTATION |
    LICHEN_OVERRIDE_SEED | LICHEN_OVERRIDE_BLEND_SHARPNESS | LICHEN_OVERRIDE_CONTRAST |
    LICHEN_OVERRIDE_NOISE | LICHEN_OVERRIDE_IMPACTS | LICHEN_OVERRIDE_POINT_PROCESS |
    LICHEN_OVERRIDE_MAPPING | LICHEN_OVERRIDE_PLANE_SHARPNESS | LICHEN_OVERRIDE_TILE_ROTATION;

LichenResult checkRange(const char* name, double value, NumberRange range,
                        LichenDiagnostic* diagnostic) {
  // This form also rejects NaN.
  if (value >= range.least && value <= range.most)
    return LICHEN_SUCCESS;
  writeDiagnostic(diagnostic, "%s %.9g is out of range; expected %.9g to %.9g", name, value,
                  range.least, range.most);
  return LICHEN_ERROR_USAGE;
}

LichenResult readPointProcess(LichenPointProcess value, PointProcess& process,
                              LichenDiagnostic* diagnostic) {
  if (value != LICHEN_POINT_PROCESS_STRATIFIED && value != LICHEN_POINT_PROCESS_POISSON) {
    writeDiagnostic(diagnostic,
                    "pointProcess %d is invalid; expected 0 (stratified) or 1 (Poisson)",
                    int(value));
    return LICHEN_ERROR_USAGE;
  }
  process =
      value == LICHEN_POINT_PROCESS_POISSON ? PointProcess::poisson : PointProcess::stratified;
  return LICHEN_SUCCESS;
}

LichenResult readMapping(LichenMapping value, const Noise& noise, Mapping& mapping,
                         LichenDiagnostic* diagnostic) {
  for (const auto& [code, candidate] : {std::pair{LICHEN_MAPPING_UV, Mapping::uv},
                                        {LICHEN_MAPPING_TRIPLANAR, Mapping::triplanar},
                                        {LICHEN_MAPPING_SURFACE, Mapping::surface}})
    if (value == code && mappingFits(noise.method(), candidate)) {
      mapping = candidate;
      return LICHEN_SUCCESS;
    }
  writeDiagnostic(
      diagnostic,
      "mapping %d is invalid for a noise with method %s; expected 0 (uv), 1 (triplanar) or, for "
      "texton noise, 2 (surface)",
      int(value), nameOf(noise.method()).data());
  return LICHEN_ERROR_USAGE;
}

/// The material's parameters, replaced by the host's overrides.
LichenResult findParameters(const LichenBundle_T& plan, const LichenUniformInfo& info,
                            MaterialNoise& parameters, LichenDiagnostic* diagnostic) {
  if (info.overrides & ~kKnownOverrides) {
    writeDiagnostic(diagnostic, "overrides 0x%x has unknown bits; the LichenOverride bits are 0x%x",
                    info.overrides, kKnownOverrides);
    return LICHEN_ERROR_USAGE;
  }
  const auto& materials = plan.bundle.materials;
  if (info.overrides & LICHEN_OVERRIDE_NOISE) {
    if (info.noise >= plan.bundle.noises.size()) {
      writeDiagnostic(diagnostic, "noise %u does not exist; expected an index below %zu",
                      info.noise, plan.bundle.noises.size());
      return LICHEN_ERROR_USAGE;
    }
    parameters.noise = info.noise;
  } else if (info.material >= materials.size() || !materials[info.material]) {
    writeDiagnostic(diagnostic, "material %u has no noise; number of materials: %zu", info.material,
                    materials.size());
    return LICHEN_ERROR_USAGE;
  } else {
    parameters = *materials[info.material];
  }
  if (info.overrides & LICHEN_OVERRIDE_SCALE)
    parameters.scale = info.scale;
  if (info.overrides & LICHEN_OVERRIDE_OFFSET)
    parameters.offset = {info.offset[0], info.offset[1]};
  if (info.overrides & LICHEN_OVERRIDE_ROTATION)
    parameters.rotation = info.rotation;
  if (info.overrides & LICHEN_OVERRIDE_SEED)
    parameters.seed = info.seed;
  if (info.overrides & LICHEN_OVERRIDE_BLEND_SHARPNESS)
    parameters.blendSharpness = info.blendSharpness;
  if (info.overrides & LICHEN_OVERRIDE_PLANE_SHARPNESS)
    parameters.planeSharpness = info.planeSharpness;
  if (info.overrides & LICHEN_OVERRIDE_CONTRAST)
    parameters.contrast = info.contrast;
  if (info.overrides & LICHEN_OVERRIDE_TILE_ROTATION)
    parameters.tileRotation = info.tileRotation;
  if (info.overrides & LICHEN_OVERRIDE_IMPACTS)
    parameters.impacts = info.impacts;
  LichenResult result = LICHEN_SUCCESS;
  if (info.overrides & LICHEN_OVERRIDE_POINT_PROCESS)
    result = readPointProcess(info.pointProcess, parameters.pointProcess, diagnostic);
  if (result == LICHEN_SUCCESS && info.overrides & LICHEN_OVERRIDE_MAPPING)
    result = readMapping(info.mapping, plan.bundle.noises[parameters.noise], parameters.mapping,
                         diagnostic);
  return result;
}

LichenResult checkPeriod(const MaterialNoise& parameters, const LichenUniformInfo& info,
                         LichenDiagnostic* diagnostic) {
  // tiles; keeps columns far below 2^24, where floats skip integers
  constexpr NumberRange kPeriodRange{1.0, 65536.0};
  if (info.periodTiles[0] == 0.0 && info.periodTiles[1] == 0.0)
    return LICHEN_SUCCESS;
  if (parameters.mapping != Mapping::uv) {
    writeDiagnostic(
        diagnostic,
        "periodTiles %.9g is not supported for %s mapping, which cannot repeat; set it to 0",
        info.periodTiles[info.periodTiles[0] == 0.0 ? 1 : 0], nameOf(parameters.mapping).data());
    return LICHEN_ERROR_USAGE;
  }
  for (int axis = 0; axis < 2; ++axis) {
    const double period = info.periodTiles[axis];
    if (const LichenResult result = checkRange("periodTiles", period, kPeriodRange, diagnostic);
        result != LICHEN_SUCCESS)
      return result;
    if (info.tileOrigin[axis] != 0 && period != std::floor(period)) {
      writeDiagnostic(diagnostic,
                      "periodTiles %.9g must be a whole number when tileOrigin is not 0", period);
      return LICHEN_ERROR_USAGE;
    }
  }
  return LICHEN_SUCCESS;
}

LichenResult checkParameters(const MaterialNoise& parameters, const LichenUniformInfo& info,
                             LichenDiagnostic* diagnostic) {
  constexpr double kFarthest = 1099511627776; // 2^40 tiles, exact in the doubles of triplanar origins
  const struct {
    const char* name;
    double value;
    NumberRange range;
  } checks[] = {
      {"scale", parameters.scale, kScaleRange},
      {"offset", parameters.offset[0], kOffsetRange},
      {"offset", parameters.offset[1], kOffsetRange},
      {"rotation", parameters.rotation, kRotationRange},
      {"blendSharpness", parameters.blendSharpness, kBlendSharpnessRange},
      {"planeSharpness", parameters.planeSharpness, kPlaneSharpnessRange},
      {"contrast", parameters.contrast, kContrastRange},
      {"impacts", parameters.impacts, kImpactsRange},
      {"tileRotation", double(parameters.tileRotation), {0.0, double(kMostTileRotation)}},
      {"tileOrigin", double(info.tileOrigin[0]), {-kFarthest, kFarthest}},
      {"tileOrigin", double(info.tileOrigin[1]), {-kFarthest, kFarthest}},
      {"tileOriginZ", double(info.tileOriginZ), {-kFarthest, kFarthest}},
      {"maxAnisotropy", double(info.maxAnisotropy), {0.0, kMostAnisotropy}},
  };
  for (const auto& check : checks)
    if (const LichenResult result = checkRange(check.name, check.value, check.range, diagnostic);
        result != LICHEN_SUCCESS)
      return result;
  return checkPeriod(parameters, info, diagnostic);
}

} // namespace

LichenResult lichenFillUniforms(LichenBundle bundle, const LichenUniformInfo* hostInfo,
                                void* destination, LichenDiagnostic* diagnostic) {
  static_assert(sizeof(shader::LichenUniforms) == LICHEN_UNIFORM_BYTES);
  return guarded(diagnostic, [&] {
    if (bundle == nullptr || destination == nullptr) {
      writeDiagnostic(diagnostic, "bundle and destination must not be NULL");
      return LICHEN_ERROR_USAGE;
    }
    LichenUniformInfo info{};
    MaterialNoise parameters;
    LichenResult result = readStruct(hostInfo, LICHEN_STRUCTURE_UNIFORM_INFO, info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = findParameters(*bundle, info, parameters, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkParameters(parameters, info, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
    Placement placement;
    placement.tileOriginX = info.tileOrigin[0];
    placement.tileOriginY = info.tileOrigin[1];
    placement.tileOriginZ = info.tileOriginZ;
    placement.periodic = info.periodTiles[0] > 0.0;
    placement.periodTilesX = info.periodTiles[0];
    placement.periodTilesY = info.periodTiles[1];
    placement.maxAnisotropy = double(info.maxAnisotropy);
    shader::LichenUniforms uniforms{};
    uniforms.noise = shaderNoise(bundle->bundle, parameters, placement);
    uniforms.texton = shaderTexton(bundle->bundle, parameters, placement);
    std::copy(bundle->maps[parameters.noise].begin(), bundle->maps[parameters.noise].end(),
              uniforms.maps);
    std::memcpy(destination, &uniforms, sizeof uniforms);
    return LICHEN_SUCCESS;
  });
}
