// SPDX-License-Identifier: MIT
// Parses bundles and fills materials' blocks with the engine plugin's plan layer, and keeps its
// diagnostics.
#pragma once

#include "bundle_example.h"

#include <lichen/lichen.h>

#include <catch2/catch.hpp>

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

/// The parameters of a bundle's first material.
inline LichenMaterialParameters parametersOf(LichenBundle bundle) {
  LichenMaterialParameters parameters;
  LICHEN_INIT(parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  CHECK(lichenGetMaterialParameters(bundle, 0, &parameters) == LICHEN_SUCCESS);
  return parameters;
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
