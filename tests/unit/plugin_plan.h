// SPDX-License-Identifier: MIT
// Parses bundles and fills uniforms with the engine plugin's plan layer, and keeps its diagnostics.
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

inline LichenUniformInfo uniformInfo() {
  LichenUniformInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_UNIFORM_INFO);
  return info;
}

struct Filled {
  LichenResult result = LICHEN_SUCCESS;
  shader::LichenUniforms uniforms{};
  std::string message;
};

inline Filled fill(LichenBundle bundle, const LichenUniformInfo& info) {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  Filled filled;
  filled.result = lichenFillUniforms(bundle, &info, &filled.uniforms, &diagnostic);
  filled.message = diagnostic.text;
  return filled;
}

} // namespace lichen::test
