// SPDX-License-Identifier: MIT
// A material's parameters and its placement -> LichenMaterial, the block that may change each
// frame. Needs no bundle.
#include "abi.h"
#include "noise_summary.h"
#include "plan.h"

#include <lichen/lattice.h>
#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <span>

using namespace lichen;
using namespace lichen::plugin;

namespace {

LichenResult checkRange(const char* name, double value, NumberRange range,
                        LichenDiagnostic* diagnostic) {
  // This form also rejects NaN.
  if (value >= range.least && value <= range.most)
    return LICHEN_SUCCESS;
  writeDiagnostic(diagnostic, "%s %.9g is out of range; expected %.9g to %.9g", name, value,
                  range.least, range.most);
  return LICHEN_ERROR_USAGE;
}

/// Converts an enumerator of lichen.h to the bundle's, which has the same number, at most `last`.
template <class Value>
LichenResult readChoice(const char* name, int number, Value last, Value& value,
                        LichenDiagnostic* diagnostic) {
  if (number >= 0 && number <= int(last)) {
    value = Value(number);
    return LICHEN_SUCCESS;
  }
  writeDiagnostic(diagnostic, "%s %d is invalid; expected 0 to %d", name, number, int(last));
  return LICHEN_ERROR_USAGE;
}

/// Whether all layers and index maps of the noise have a mapping. If not, says why not.
LichenResult checkMapping(LichenMapping value, const NoiseSummary& summary, Mapping mapping,
                          LichenDiagnostic* diagnostic) {
  if (summary.layerCount > 1 && !mappingFitsLayers(mapping)) {
    writeDiagnostic(diagnostic, "mapping %d (%s) does not fit the noise: it has layers", int(value),
                    nameOf(mapping).data());
    return LICHEN_ERROR_USAGE;
  }
  std::array<const shader::LichenNoise*, 1 + 2 * LICHEN_MAX_LAYER_NODES> noises{&summary.constants};
  std::size_t count = 1;
  for (std::uint32_t layer = 1; layer < summary.layerCount; ++layer) {
    noises[count++] = &summary.layers[layer - 1];
    noises[count++] = &summary.indices[layer - 1];
  }
  for (const shader::LichenNoise* noise : std::span(noises).first(count)) {
    if (!mappingFits(Method(noise->method), mapping)) {
      writeDiagnostic(diagnostic,
                      "mapping %d (%s) is invalid for a noise with method %s; expected one of %s",
                      int(value), nameOf(mapping).data(), nameOf(Method(noise->method)).data(),
                      mappingsOf(Method(noise->method)).c_str());
      return LICHEN_ERROR_USAGE;
    }
    const std::string_view obstacle = mappingObstacle(*noise, mapping);
    if (!obstacle.empty()) {
      writeDiagnostic(diagnostic, "mapping %d (%s) does not fit the noise: %.*s", int(value),
                      nameOf(mapping).data(), int(obstacle.size()), obstacle.data());
      return LICHEN_ERROR_USAGE;
    }
  }
  return LICHEN_SUCCESS;
}

LichenResult readTileRotation(std::uint32_t value, const NoiseSummary& summary,
                              MaterialNoise& parameters, LichenDiagnostic* diagnostic) {
  parameters.tileRotation = value;
  const auto others = std::span(summary.layers).first(summary.layerCount - 1);
  if (takesTileRotation(summary.constants, value) &&
      std::ranges::all_of(others,
                          [&](const auto& other) { return takesTileRotation(other, value); }))
    return LICHEN_SUCCESS;
  writeDiagnostic(diagnostic, "tileRotation %u is invalid; expected %s", unsigned(value),
                  kTileRotations.data());
  return LICHEN_ERROR_USAGE;
}

LichenResult readParameters(const LichenMaterialParameters& source, const NoiseSummary& summary,
                            MaterialNoise& parameters, LichenDiagnostic* diagnostic) {
  parameters.noise = source.noise;
  parameters.seed = source.seed;
  parameters.scale = source.scale;
  parameters.offset = {source.offset[0], source.offset[1]};
  parameters.rotation = source.rotation;
  parameters.blendSharpness = source.blendSharpness;
  parameters.contrast = source.contrast;
  parameters.planeSharpness = source.planeSharpness;
  parameters.impacts = source.impacts;
  parameters.mix.weight = source.mixWeight;
  parameters.mix.start = {source.mixStart[0], source.mixStart[1]};
  parameters.mix.end = {source.mixEnd[0], source.mixEnd[1]};
  LichenResult result = readChoice("pointProcess", int(source.pointProcess), PointProcess::poisson,
                                   parameters.pointProcess, diagnostic);
  if (result == LICHEN_SUCCESS)
    result =
        readChoice("mapping", int(source.mapping), Mapping::solid, parameters.mapping, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = checkMapping(source.mapping, summary, parameters.mapping, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = readTileRotation(source.tileRotation, summary, parameters, diagnostic);
  if (result == LICHEN_SUCCESS)
    result = readChoice("mixSource", int(source.mixSource), MixSource::vertexColor,
                        parameters.mix.source, diagnostic);
  return result;
}

LichenResult checkPeriod(const MaterialNoise& parameters, const LichenPlacement& info,
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
    if (!(period >= kPeriodRange.least && period <= kPeriodRange.most)) {
      writeDiagnostic(diagnostic,
                      "periodTiles[%d] %.9g is out of range; expected %.9g to %.9g, or 0 on both "
                      "axes for none",
                      axis, period, kPeriodRange.least, kPeriodRange.most);
      return LICHEN_ERROR_USAGE;
    }
    if (info.tileOrigin[axis] != 0 && period != std::floor(period)) {
      writeDiagnostic(diagnostic,
                      "periodTiles[%d] %.9g must be a whole number when tileOrigin[%d] is not 0",
                      axis, period, axis);
      return LICHEN_ERROR_USAGE;
    }
  }
  return LICHEN_SUCCESS;
}

LichenResult checkParameters(const MaterialNoise& parameters, const LichenPlacement& info,
                             LichenDiagnostic* diagnostic) {
  constexpr double kFarthest =
      1099511627776; // 2^40 tiles, exact in the doubles of triplanar origins
  const struct {
    const char* name;
    double value;
    NumberRange range;
  } checks[] = {
      {"scale", parameters.scale, kScaleRange},
      {"offset[0]", parameters.offset[0], kOffsetRange},
      {"offset[1]", parameters.offset[1], kOffsetRange},
      {"rotation", parameters.rotation, kRotationRange},
      {"blendSharpness", parameters.blendSharpness, kBlendSharpnessRange},
      {"planeSharpness", parameters.planeSharpness, kPlaneSharpnessRange},
      {"contrast", parameters.contrast, kContrastRange},
      {"impacts", parameters.impacts, kImpactsRange},
      {"mixWeight", parameters.mix.weight, {0.0, 1.0}},
      {"mixStart[0]", parameters.mix.start[0], kMixPlaceRange},
      {"mixStart[1]", parameters.mix.start[1], kMixPlaceRange},
      {"mixEnd[0]", parameters.mix.end[0], kMixPlaceRange},
      {"mixEnd[1]", parameters.mix.end[1], kMixPlaceRange},
      {"tileOrigin[0]", double(info.tileOrigin[0]), {-kFarthest, kFarthest}},
      {"tileOrigin[1]", double(info.tileOrigin[1]), {-kFarthest, kFarthest}},
      {"tileOrigin[2]", double(info.tileOrigin[2]), {-kFarthest, kFarthest}},
      {"maxAnisotropy", double(info.maxAnisotropy), {0.0, kMostAnisotropy}},
  };
  for (const auto& check : checks)
    if (const LichenResult result = checkRange(check.name, check.value, check.range, diagnostic);
        result != LICHEN_SUCCESS)
      return result;
  const MixWeight& mix = parameters.mix;
  if (mix.source == MixSource::direction &&
      std::hypot(mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]) < kLeastMixLength) {
    writeDiagnostic(diagnostic, "mixEnd (%.9g, %.9g) is closer than %.9g to mixStart", mix.end[0],
                    mix.end[1], kLeastMixLength);
    return LICHEN_ERROR_USAGE;
  }
  return checkPeriod(parameters, info, diagnostic);
}

} // namespace

namespace lichen::plugin {

std::uint32_t checksumOf(const NoiseSummary& summary) {
  constexpr std::size_t kWords = offsetof(NoiseSummary, checksum) / sizeof(std::uint32_t);
  std::array<std::uint32_t, kWords> words{};
  std::memcpy(words.data(), &summary, sizeof words);
  std::uint32_t sum = 1;
  for (const std::uint32_t word : words)
    sum = pcg(sum ^ word);
  return sum;
}

LichenResult readNoiseSummary(const LichenMaterialParameters& source, NoiseSummary& summary,
                              LichenDiagnostic* diagnostic) {
  std::memcpy(&summary, source.noiseSummary, sizeof summary);
  if (summary.checksum == checksumOf(summary))
    return LICHEN_SUCCESS;
  writeDiagnostic(diagnostic, "noiseSummary is not what the library wrote; get the parameters from "
                              "lichenGetMaterialParameters or lichenGetDefaultParameters");
  return LICHEN_ERROR_USAGE;
}

} // namespace lichen::plugin

LichenResult lichenFillMaterial(const LichenMaterialParameters* hostParameters,
                                const LichenPlacement* hostPlacement, void* destination,
                                LichenDiagnostic* diagnostic) {
  static_assert(sizeof(shader::LichenMaterial) == LICHEN_MATERIAL_BYTES);
  static_assert(sizeof(shader::LichenTriplanarMaterial) == LICHEN_TRIPLANAR_MATERIAL_BYTES);
  static_assert(sizeof(shader::LichenLayeredMaterial) == LICHEN_LAYERED_MATERIAL_BYTES);
  return guarded(diagnostic, [&] {
    if (destination == nullptr) {
      writeDiagnostic(diagnostic, "destination must not be NULL");
      return LICHEN_ERROR_USAGE;
    }
    LichenMaterialParameters values{};
    LichenPlacement info{};
    NoiseSummary summary{};
    MaterialNoise parameters;
    LichenResult result =
        readStruct(hostParameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS, values, diagnostic);
    if (result == LICHEN_SUCCESS && hostPlacement != nullptr)
      result = readStruct(hostPlacement, LICHEN_STRUCTURE_PLACEMENT, info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = readNoiseSummary(values, summary, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = readParameters(values, summary, parameters, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkParameters(parameters, info, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
    Placement placement;
    placement.tileOriginX = info.tileOrigin[0];
    placement.tileOriginY = info.tileOrigin[1];
    placement.tileOriginZ = info.tileOrigin[2];
    placement.periodic = info.periodTiles[0] > 0.0;
    placement.periodTilesX = info.periodTiles[0];
    placement.periodTilesY = info.periodTiles[1];
    placement.maxAnisotropy = double(info.maxAnisotropy);
    if (summary.layerCount > 1) {
      std::array<shader::LichenNoise, LICHEN_MAX_LAYERS> layers{summary.constants};
      std::copy(std::begin(summary.layers), std::end(summary.layers), layers.begin() + 1);
      const shader::LichenLayeredMaterial filled = shaderLayeredMaterial(
          std::span(layers).first(summary.layerCount),
          std::span(summary.indices).first(summary.layerCount - 1), parameters, placement);
      std::memcpy(destination, &filled, sizeof filled);
      return LICHEN_SUCCESS;
    }
    const shader::LichenTriplanarMaterial filled =
        shaderMaterial(summary.constants, parameters, placement);
    std::memcpy(destination, &filled,
                parameters.mapping == Mapping::triplanar ? sizeof filled : sizeof filled.material);
    return LICHEN_SUCCESS;
  });
}

namespace {

LichenResult writeParameters(const LichenBundle_T& plan, const MaterialNoise& source,
                             LichenMaterialParameters* parameters) {
  NoiseSummary summary{};
  const shader::LichenNoiseConstants& constants = plan.noises[source.noise].constants;
  summary.constants = constants.noise;
  std::copy(std::begin(constants.layerNoises), std::end(constants.layerNoises), summary.layers);
  std::copy(std::begin(constants.indexNoises), std::end(constants.indexNoises), summary.indices);
  const LichenBundle_T::NoisePlan& layered = plan.noises[source.noise];
  summary.layerCount = layered.layerCount;
  for (const std::uint32_t layer : std::span(layered.layers).first(layered.layerCount)) {
    for (const NoiseMap& map : plan.bundle.noises[layer].maps) {
      summary.features |=
          decodingTableOf(map) ? LICHEN_FEATURE_TABLES : LICHEN_FEATURE_GAUSSIAN_ONLY;
      if (map.encoding == ValueEncoding::log2)
        summary.features |= LICHEN_FEATURE_VALUES_ABOVE_ONE;
    }
  }
  summary.checksum = checksumOf(summary);
  LichenMaterialParameters values{};
  values.noise = std::uint32_t(source.noise);
  values.mapping = LichenMapping(source.mapping);
  values.seed = source.seed;
  values.tileRotation = source.tileRotation;
  values.scale = source.scale;
  std::copy(source.offset.begin(), source.offset.end(), values.offset);
  values.rotation = source.rotation;
  values.blendSharpness = source.blendSharpness;
  values.contrast = source.contrast;
  values.planeSharpness = source.planeSharpness;
  values.impacts = source.impacts;
  values.pointProcess = LichenPointProcess(source.pointProcess);
  values.mixSource = LichenMixSource(source.mix.source);
  values.mixWeight = source.mix.weight;
  std::copy(source.mix.start.begin(), source.mix.start.end(), values.mixStart);
  std::copy(source.mix.end.begin(), source.mix.end.end(), values.mixEnd);
  std::memcpy(values.noiseSummary, &summary, sizeof summary);
  return writeStruct(values, LICHEN_STRUCTURE_MATERIAL_PARAMETERS, parameters);
}

} // namespace

LichenResult lichenGetMaterialParameters(LichenBundle bundle, std::uint32_t material,
                                         LichenMaterialParameters* parameters) {
  if (bundle == nullptr || material >= bundle->bundle.materials.size() ||
      !bundle->bundle.materials[material])
    return LICHEN_ERROR_USAGE;
  return writeParameters(*bundle, *bundle->bundle.materials[material], parameters);
}

LichenResult lichenGetDefaultParameters(LichenBundle bundle, std::uint32_t noise,
                                        LichenMaterialParameters* parameters) {
  if (bundle == nullptr || noise >= bundle->noises.size())
    return LICHEN_ERROR_USAGE;
  MaterialNoise material;
  material.noise = noise;
  return writeParameters(*bundle, material, parameters);
}
