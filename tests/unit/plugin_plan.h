// SPDX-License-Identifier: MIT
// Parses bundles and fills materials' blocks with the engine plugin's plan layer, and keeps its
// diagnostics.
#pragma once

#include "bundle_example.h"

#include <lichen/lichen.h>

#include <catch2/catch.hpp>

#include <concepts>
#include <cstdint>
#include <lichen_interface.h>
#include <string>
#include <vector>

namespace lichen::test {

struct Parsed {
  LichenResult result = LICHEN_SUCCESS;
  LichenBundle bundle = nullptr;
  std::string message;
};

inline LichenParseInfo parseInfo(const std::vector<std::byte>& bytes) {
  LichenParseInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.bytes = bytes.data();
  info.byteCount = bytes.size();
  return info;
}

inline Parsed parse(const LichenParseInfo& info) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  Parsed parsed;
  parsed.result = lichenParseBundle(&info, &parsed.bundle, &diagnostic);
  parsed.message = diagnostic.text;
  return parsed;
}

/// A bundle that is destroyed at the end of the test.
struct OwnedBundle {
  explicit OwnedBundle(const BundleFile& file) {
    const std::vector<std::byte> glb = encodeGlb(file).value();
    const Parsed parsed = parse(parseInfo(glb));
    INFO(parsed.message);
    REQUIRE(parsed.result == LICHEN_SUCCESS);
    handle = parsed.bundle;
  }
  OwnedBundle(const OwnedBundle&) = delete;
  OwnedBundle& operator=(const OwnedBundle&) = delete;
  ~OwnedBundle() { lichenDestroyBundle(handle); }

  LichenBundle handle = nullptr;
};

template <class Struct>
inline constexpr LichenStructureType kTypeOf = LICHEN_STRUCTURE_BUNDLE_PROPERTIES;
template <>
inline constexpr auto kTypeOf<LichenNoiseProperties> = LICHEN_STRUCTURE_NOISE_PROPERTIES;
template <>
inline constexpr auto kTypeOf<LichenMapProperties> = LICHEN_STRUCTURE_MAP_PROPERTIES;
template <>
inline constexpr auto kTypeOf<LichenMaterialProperties> = LICHEN_STRUCTURE_MATERIAL_PROPERTIES;
template <>
inline constexpr auto kTypeOf<LichenMaterialParameters> = LICHEN_STRUCTURE_MATERIAL_PARAMETERS;
template <>
inline constexpr auto kTypeOf<LichenImageProperties> = LICHEN_STRUCTURE_IMAGE_PROPERTIES;
template <>
inline constexpr auto kTypeOf<LichenCopy> = LICHEN_STRUCTURE_COPY;
template <>
inline constexpr auto kTypeOf<LichenBinding> = LICHEN_STRUCTURE_BINDING;

/// What a function of the plan layer, which must succeed, writes for these indices.
template <class Struct, class Get, std::integral... Indices>
Struct got(const Get& get, LichenBundle bundle, Indices... indices) {
  Struct result;
  LICHEN_INIT(result, kTypeOf<Struct>);
  REQUIRE(get(bundle, std::uint32_t(indices)..., &result) == LICHEN_SUCCESS);
  return result;
}

/// The parameters of a bundle's first material.
inline LichenMaterialParameters parametersOf(LichenBundle bundle) {
  return got<LichenMaterialParameters>(lichenGetMaterialParameters, bundle, 0);
}

inline LichenPlacement atOrigin() {
  LichenPlacement placement;
  LICHEN_INIT(placement, LICHEN_STRUCTURE_PLACEMENT);
  return placement;
}

struct Filled {
  LichenResult result = LICHEN_SUCCESS;
  shader::LichenTriplanarMaterial block{};
  std::string message;
};

inline Filled fill(const LichenMaterialParameters& parameters,
                   const LichenPlacement& placement = atOrigin()) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  Filled filled;
  filled.result = lichenFillMaterial(&parameters, &placement, &filled.block, &diagnostic);
  filled.message = diagnostic.text;
  return filled;
}

} // namespace lichen::test
