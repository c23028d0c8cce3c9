// SPDX-License-Identifier: MIT
// What the bake of a material needs from a method. Each method defines its own in its folder, and
// method_analysis.cpp lists them.
#pragma once

#include <lichen/bake_memory.h>
#include <lichen/method_bake.h>
#include <lichen/suitability.h>

#include <span>
#include <string>

namespace lichen {

/// What is baked, and how whatever the method.
struct MethodInput {
  std::string name;
  std::span<const MapExemplar> maps;
  Periodic borders{};            ///< as MaterialSet::periodic
  int bits = 8;                  ///< per channel of the tables
  const MaterialNoise& material; ///< that will use the noise
  SettingWords words = plainWords;
  Progress progress;
};

struct MethodAnalysis {
  /// The memory of a bake. `options` are the method's.
  BakeMemory (*memory)(const MethodOptions& options);
  /// Members of `input` replace members of `options` with the same names.
  Result<MethodBake> (*bake)(const MethodOptions& options, const MethodInput& input);
};

[[nodiscard]] const MethodAnalysis& analysisOf(Method method);

/// The options of a method as a bake of `input` takes them. Precondition: `options` holds them.
template <class Options>
[[nodiscard]] Options optionsFor(const MethodOptions& options, const MethodInput& input) {
  auto own = std::get<Options>(options);
  own.bits = input.bits;
  own.progress = input.progress;
  if constexpr (requires { own.periodic; })
    own.periodic = input.borders;
  return own;
}

extern const MethodAnalysis kTilingAnalysis, kTextonAnalysis, kLocalRandomPhaseAnalysis,
    kMultipleKernelsAnalysis, kQuiltingAnalysis;

} // namespace lichen
