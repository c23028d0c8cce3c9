// SPDX-License-Identifier: MIT
// The methods of the format, in the order of Method.
#include "method_parameters.h"
#include "method_reader.h"

#include <algorithm>
#include <array>

namespace lichen {

extern const MethodReader kTilingReader, kTextonReader, kLocalRandomPhaseReader,
    kMultipleKernelsReader, kQuiltingReader;
extern const MethodParameters kTilingParameters, kTextonParameters, kLocalRandomPhaseParameters,
    kMultipleKernelsParameters, kQuiltingParameters;

const MethodReader& readerOf(Method method) {
  static constexpr std::array kReaders{&kTilingReader, &kTextonReader, &kLocalRandomPhaseReader,
                                       &kMultipleKernelsReader, &kQuiltingReader};
  static_assert(kReaders.size() == std::variant_size_v<MethodMap>);
  return *kReaders[std::size_t(method)];
}

const MethodParameters& parametersOf(Method method) {
  static constexpr std::array kParameters{&kTilingParameters, &kTextonParameters,
                                          &kLocalRandomPhaseParameters, &kMultipleKernelsParameters,
                                          &kQuiltingParameters};
  static_assert(kParameters.size() == std::variant_size_v<MethodMap>);
  return *kParameters[std::size_t(method)];
}

std::span<const Method> allMethods() {
  static constexpr std::array kMethods{Method::tiling, Method::texton, Method::localRandomPhase,
                                       Method::multipleKernels, Method::quilting};
  static_assert(kMethods.size() == std::variant_size_v<MethodMap>);
  return kMethods;
}

std::string_view nameOf(Method value) { return readerOf(value).name; }

std::optional<Method> methodFrom(std::string_view name) {
  for (const Method method : allMethods())
    if (nameOf(method) == name)
      return method;
  return std::nullopt;
}

int revisionOf(Method method) { return readerOf(method).revision; }

std::string mappingsOf(Method method) {
  std::string names;
  for (const Mapping each : {Mapping::uv, Mapping::triplanar, Mapping::surface, Mapping::solid})
    if (mappingFits(method, each))
      names += (names.empty() ? "" : ", ") + std::string(nameOf(each));
  return names;
}

bool mappingFits(Method method, Mapping mapping) { return parametersOf(method).fits(mapping); }

std::string_view mappingObstacle(const shader::LichenNoise& noise, Mapping mapping) {
  const MethodParameters& parameters = parametersOf(noise);
  return parameters.obstacle != nullptr ? parameters.obstacle(noise, mapping) : "";
}

std::string_view mappingObstacle(const Noise& noise, Mapping mapping) {
  const MethodParameters& parameters = parametersOf(noise);
  if (parameters.obstacle == nullptr)
    return "";
  shader::LichenNoise constants{};
  parameters.setNoise({}, noise, constants);
  return parameters.obstacle(constants, mapping);
}

bool isMix(const Noise& noise) {
  const MethodParameters& parameters = parametersOf(noise);
  return parameters.isMix != nullptr && parameters.isMix(noise);
}

std::array<std::uint32_t, 2> exemplarSize(const Bundle& bundle, const Noise& noise,
                                          const NoiseMap& map) {
  const MethodParameters& parameters = parametersOf(noise);
  if (parameters.texelsPerTile != nullptr)
    return parameters.texelsPerTile(noise);
  const Table& image = bundle.tables[parameters.imageOf(map)];
  return {image.width, image.height};
}

std::array<std::uint32_t, 2> tileSize(const Bundle& bundle, const Noise& noise) {
  if (const MethodParameters& parameters = parametersOf(noise); parameters.texelsPerTile != nullptr)
    return parameters.texelsPerTile(noise);
  std::array<std::uint32_t, 2> size{1, 1};
  for (const NoiseMap& map : noise.maps) {
    const auto [width, height] = exemplarSize(bundle, noise, map);
    size = {std::max(size[0], width), std::max(size[1], height)};
  }
  return size;
}

} // namespace lichen
