// SPDX-License-Identifier: MIT
// The methods of the format, in the order of Method.
#include "local_random_phase/local_random_phase_format.h"
#include "multiple_kernels/multiple_kernels_format.h"
#include "quilting/quilting_format.h"
#include "texton/texton_format.h"
#include "tiling/tiling_format.h"

#include <algorithm>

namespace lichen {

std::span<const MethodFormat* const> methodFormats() {
  static const TilingFormat kTiling;
  static const TextonFormat kTexton;
  static const LocalRandomPhaseFormat kLocalRandomPhase;
  static const MultipleKernelsFormat kMultipleKernels;
  static const QuiltingFormat kQuilting;
  static const std::array<const MethodFormat*, 5> kFormats{&kTiling, &kTexton, &kLocalRandomPhase,
                                                           &kMultipleKernels, &kQuilting};
  static_assert(kFormats.size() == std::variant_size_v<MethodMap>);
  return kFormats;
}

const MethodFormat& formatOf(Method method) { return *methodFormats()[std::size_t(method)]; }

std::span<const Method> allMethods() {
  static constexpr std::array kMethods{Method::tiling, Method::texton, Method::localRandomPhase,
                                       Method::multipleKernels, Method::quilting};
  static_assert(kMethods.size() == std::variant_size_v<MethodMap>);
  return kMethods;
}

std::string_view nameOf(Method value) { return formatOf(value).name(); }

std::optional<Method> methodFrom(std::string_view name) {
  for (const Method method : allMethods())
    if (nameOf(method) == name)
      return method;
  return std::nullopt;
}

int revisionOf(Method method) { return formatOf(method).revision(); }

bool mappingFits(Method method, Mapping mapping) { return formatOf(method).fits(mapping); }

std::string_view mappingObstacle(const shader::LichenNoise& noise, Mapping mapping) {
  return formatOf(Method(noise.method)).obstacle(noise, mapping);
}

std::string_view mappingObstacle(const Noise& noise, Mapping mapping) {
  return formatOf(noise).obstacle(noise, mapping);
}

bool isMix(const Noise& noise) { return formatOf(noise).isMix(noise); }

std::array<std::uint32_t, 2> exemplarSize(const Bundle& bundle, const Noise& noise,
                                          const NoiseMap& map) {
  return formatOf(noise).exemplarSize(bundle, noise, map);
}

} // namespace lichen
